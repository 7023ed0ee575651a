// Touches the given number of megabytes of memory, and frees them. On a virtual machine, the host backs a
// page when it is first touched, and may take it away some time after it was freed. That costs ten times a
// page fault of the guest. Running this program right before a measurement keeps the host out of it.
#include <cstddef>

#include <sys/mman.h>

#include "text/parsed_number.h"

int main(int argc, char** argv) {
    const std::size_t bytes = (argc == 2 ? interleaf::parsed_number<std::size_t>(argv[1]).value_or(0) : 0)
                              << 20;
    if (bytes == 0) return 2;
    void* const memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return 3;
    ::madvise(memory, bytes, MADV_HUGEPAGE);
    for (std::size_t place = 0; place < bytes; place += 4096) static_cast<volatile char*>(memory)[place] = 1;
    return 0;
}
