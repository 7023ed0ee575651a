#include "io/file/temporary_file.h"

#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace interleaf {

namespace {

/// Whether \p path still names the open file \p file.
bool is_called(const FileDescriptor& file, const std::filesystem::path& path) {
    struct stat open_file {};
    struct stat named {};
    return ::fstat(file.number(), &open_file) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           open_file.st_dev == named.st_dev && open_file.st_ino == named.st_ino;
}

/// Removes \p path if it is a file of this user that no process has locked. While we hold the lock, no other
/// process removes the file, and its writer has ended, so nobody renames it.
bool remove_if_left_behind(const std::filesystem::path& path) {
    const FileDescriptor file(path, O_WRONLY | O_NOFOLLOW | O_NONBLOCK);
    struct stat status {};
    return file.is_open() && ::fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode) &&
           status.st_uid == ::geteuid() && ::flock(file.number(), LOCK_EX | LOCK_NB) == 0 &&
           is_called(file, path) && ::unlink(path.c_str()) == 0;
}

/// A new, empty, locked file. On a file system without locks the file is not locked, but no process removes
/// files there, either.
FileDescriptor locked_new_file(const std::filesystem::path& path, unsigned mode) {
    FileDescriptor file(path, O_WRONLY | O_CREAT | O_EXCL, mode);
    if (!file.is_open()) return file;
    // Before the lock, another process may have removed the file as one left behind.
    const bool is_lost = ::flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!is_lost && is_called(file, path)) return file;
    errno = EEXIST;
    return {};
}

}  // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& folder, unsigned mode) {
    constexpr int max_writers = 10'000;
    for (int number = 0; number < max_writers; ++number) {
        path_ = folder / fmt::format(".interleaf-{}", number);
        descriptor_ = locked_new_file(path_, mode);
        if (is_open() || errno != EEXIST) return;
        if (remove_if_left_behind(path_)) descriptor_ = locked_new_file(path_, mode);
        if (is_open()) return;
    }
    errno = EEXIST;
}

TemporaryFile::~TemporaryFile() {
    if (is_open() && !renamed_) ::unlink(path_.c_str());
}

bool TemporaryFile::rename_to(const std::filesystem::path& target) {
    return renamed_ = ::rename(path_.c_str(), target.c_str()) == 0;
}

}  // namespace interleaf
