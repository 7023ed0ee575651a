#include "io/file/safe_write.h"

#include <cerrno>
#include <optional>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file/file_descriptor.h"
#include "io/file/temporary_file.h"

namespace interleaf {

namespace {

constexpr std::string_view cannot_write = "cannot write";

void write_all(const FileDescriptor& descriptor, std::span<const std::byte> bytes,
               const std::filesystem::path& target) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor.number(), bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw_system_error(target, cannot_write);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

void write_in_place(std::span<const std::byte> bytes, const std::filesystem::path& target) {
    FileDescriptor descriptor(target, O_WRONLY);
    if (!descriptor.is_open()) throw_system_error(target, cannot_write);
    write_all(descriptor, bytes, target);
    if (!descriptor.close()) throw_system_error(target, cannot_write);
}

/// Makes the rename survive a power failure. Some file systems and permissions do not allow this. The file is
/// whole anyway, so a failure is not an error.
void flush_folder(const std::filesystem::path& folder) {
    const FileDescriptor descriptor(folder, O_RDONLY | O_DIRECTORY);
    if (descriptor.is_open()) ::fsync(descriptor.number());
}

/// The path of \p file with all symbolic links followed, whether the file exists or not.
std::filesystem::path behind_links(const std::filesystem::path& file) {
    constexpr int max_links = 40;  // the limit of the system
    std::filesystem::path target = file;
    std::error_code error;
    for (int links = 0; std::filesystem::is_symlink(target, error); ++links) {
        if (links == max_links) {
            errno = ELOOP;
            throw_system_error(file, cannot_write);
        }
        target = target.parent_path() / std::filesystem::read_symlink(target, error);
    }
    return target;
}

/// Gives \p file the permissions of the file that it replaces, and its owner if the system permits.
bool take_after(const FileDescriptor& file, const struct stat& old) {
    if (::fchown(file.number(), old.st_uid, old.st_gid) != 0) errno = 0;  // then we own it, as any new file
    return ::fchmod(file.number(), old.st_mode & 07777) == 0;
}

std::filesystem::path folder_with(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

/// The type and permissions of \p file; none if there is no such file.
std::optional<struct stat> status_of(const std::filesystem::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return std::nullopt;
    return status;
}

}  // namespace

FileReplacement::FileReplacement(const std::filesystem::path& file) : target_(behind_links(file)) {
    const auto status = status_of(target_);
    exists_ = status.has_value();
    if (exists_ && !S_ISREG(status->st_mode)) {
        errno = S_ISDIR(status->st_mode) ? EISDIR : EINVAL;
        throw_system_error(target_, cannot_write);
    }
    // A writable folder would let us replace even a write-protected file.
    if (exists_ && ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0)
        throw_system_error(target_, cannot_write);
    // A file that only its owner may read stays private while it is written.
    temporary_.emplace(folder_with(target_), exists_ ? 0600 : 0666);
    if (!temporary_->is_open()) throw_system_error(target_, cannot_write);
}

void FileReplacement::commit() {
    const auto status = exists_ ? status_of(target_) : std::nullopt;
    if ((status && !take_after(temporary_->descriptor(), *status)) ||
        ::fsync(temporary_->descriptor().number()) != 0 || !temporary_->rename_to(target_))
        throw_system_error(target_, cannot_write);
    flush_folder(folder_with(target_));
}

void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    const std::filesystem::path target = behind_links(file);
    const auto status = status_of(target);
    if (status && !S_ISREG(status->st_mode)) return write_in_place(bytes, target);
    FileReplacement replacement(target);
    write_all(replacement.descriptor(), bytes, target);
    replacement.commit();
}

void write_file(const std::filesystem::path& file, std::string_view text) {
    write_file(file, std::as_bytes(std::span(text)));
}

}  // namespace interleaf
