// A file descriptor of the operating system, closed by its destructor.
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

namespace interleaf {

class FileDescriptor {
  public:
    FileDescriptor() = default;

    /// Opens \p file with the flags and mode of open(2). If that fails, is_open() is false and errno holds
    /// the reason.
    FileDescriptor(const std::filesystem::path& file, int flags, unsigned mode = 0);

    /// Takes over an open descriptor.
    explicit FileDescriptor(int number) : number_(number) {}

    FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~FileDescriptor() { close(); }

    bool is_open() const { return number_ >= 0; }
    int number() const { return number_; }

    /// Closes the file now.
    /// \return whether the system reported no error
    bool close();

  private:
    int number_ = -1;
};

/// Throws a MachineError "FILE: ACTION: the system's text for errno".
[[noreturn]] void throw_system_error(const std::filesystem::path& file, std::string_view action);

}  // namespace interleaf
