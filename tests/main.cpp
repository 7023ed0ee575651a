// The main function of every doctest program. `./dev test LAYER FILTER` chooses cases by a variable of the environment,
// which reaches them through ctest and the display that it starts for some.
#define DOCTEST_CONFIG_IMPLEMENT
#include <cstdlib>

#include <doctest/doctest.h>

int main(int count, char** arguments) {
    doctest::Context context(count, arguments);
    if (const char* cases = std::getenv("INTERLEAF_TEST_CASES")) context.addFilter("test-case", cases);
    return context.run();
}
