#include "io/scratch_folder.h"

#include <fstream>
#include <iterator>

#include <doctest/doctest.h>
#include <unistd.h>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

template <typename Error>
std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

ScratchFolder::ScratchFolder(const std::filesystem::path& parent) {
    std::string name = (parent / "interleaf-test-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = std::filesystem::canonical(name);
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::size_t ScratchFolder::entry_count() const {
    const std::filesystem::directory_iterator entries(path_);
    return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
}

std::filesystem::path memory_folder() {
    const std::filesystem::path folder = "/dev/shm";
    return std::filesystem::is_directory(folder) ? folder : std::filesystem::temp_directory_path();
}

std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    REQUIRE(stream.good());
    return {std::istreambuf_iterator<char>(stream), {}};
}

void put(const std::filesystem::path& file, std::string_view text) {
    std::ofstream stream(file, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    REQUIRE(stream.good());
}

std::string input_error_of(const std::function<void()>& action) {
    return error_of<InputError>(action);
}

std::string machine_error_of(const std::function<void()>& action) {
    return error_of<MachineError>(action);
}

}  // namespace interleaf
