#include "fuzz/scratch_file.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

namespace interleaf::fuzz {

ScratchFile::ScratchFile(std::string_view name) {
    // In memory if there is such a folder, because a fuzzer writes the file some thousand times per second.
    const std::filesystem::path in_memory = "/dev/shm";
    const bool has_memory = std::filesystem::is_directory(in_memory);
    std::string folder =
        (has_memory ? in_memory : std::filesystem::temp_directory_path()) / "interleaf-fuzz-XXXXXX";
    if (::mkdtemp(folder.data()) == nullptr) throw std::runtime_error("cannot make " + folder);
    path_ = std::filesystem::path(folder) / name;
}

ScratchFile::~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder(), ignored);
}

void ScratchFile::set_content(ByteSpan bytes) const {
    std::ofstream stream(path_, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream.flush()) throw std::runtime_error("cannot write " + path_.string());
}

}  // namespace interleaf::fuzz
