// The main function of every doctest program. `./dev test LAYER FILTER` chooses test cases by a variable of
// the environment, which ctest and xvfb-run pass on.
#include <cstdlib>
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

int main(int count, char** arguments) {
    doctest::Context context(count, arguments);
    if (const char* cases = std::getenv("INTERLEAF_TEST_CASES")) context.addFilter("test-case", cases);
    return context.run();
}
