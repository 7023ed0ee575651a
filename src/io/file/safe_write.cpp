#include "io/file/safe_write.h"

#include <cerrno>

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

}  // namespace

void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    const std::filesystem::path target = behind_links(file);
    struct stat status {};
    const bool exists = ::stat(target.c_str(), &status) == 0;
    if (exists && !S_ISREG(status.st_mode)) return write_in_place(bytes, target);
    // A writable folder would let us replace even a write-protected file.
    if (exists && ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0)
        throw_system_error(target, cannot_write);

    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
    // A file that only its owner may read stays private while it is written.
    TemporaryFile temporary(folder, exists ? 0600 : 0666);
    if (!temporary.is_open()) throw_system_error(target, cannot_write);
    write_all(temporary.descriptor(), bytes, target);
    if ((exists && !take_after(temporary.descriptor(), status)) ||
        ::fsync(temporary.descriptor().number()) != 0 || !temporary.rename_to(target))
        throw_system_error(target, cannot_write);
    flush_folder(folder);
}

void write_file(const std::filesystem::path& file, std::string_view text) {
    write_file(file, std::as_bytes(std::span(text)));
}

}  // namespace interleaf
