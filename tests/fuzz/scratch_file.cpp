#include "fuzz/scratch_file.h"

namespace interleaf::fuzz {

ScratchFile::ScratchFile(std::string_view name)
    // In memory where there is such a folder: a fuzzer writes the file some thousand times per second.
    : folder_(memory_folder()), path_(folder_ / name) {}

void ScratchFile::set_content(ByteSpan bytes) const {
    put(path_, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace interleaf::fuzz
