// An open file of the operating system that closes itself.
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

namespace interleaf {

class FileDescriptor {
  public:
    FileDescriptor() = default;

    /// Opens \p file with the flags and mode of open(2). See is_open() for the outcome; errno says why not.
    FileDescriptor(const std::filesystem::path& file, int flags, unsigned mode = 0);
    FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~FileDescriptor() { close(); }

    bool is_open() const { return number_ >= 0; }
    int number() const { return number_; }

    /// Closes it at once. \return whether the system had nothing to complain about
    bool close();

  private:
    int number_ = -1;
};

/// Throws a MachineError "FILE: ACTION: what the system says about errno".
[[noreturn]] void throw_system_error(const std::filesystem::path& file, std::string_view action);

}  // namespace interleaf
