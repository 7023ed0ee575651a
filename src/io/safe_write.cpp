#include "io/safe_write.h"

#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hierarchy/error.h"
#include "io/file_descriptor.h"

namespace interleaf {

namespace {

constexpr std::string_view cannot_write = "cannot write";

/// A new file with a name of its own in \p folder, removed again unless it was renamed.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::filesystem::path& target);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!renamed_) ::unlink(path_.c_str());
    }

    FileDescriptor& descriptor() { return descriptor_; }
    bool rename_to(const std::filesystem::path& target) {
        return renamed_ = ::rename(path_.c_str(), target.c_str()) == 0;
    }

  private:
    std::filesystem::path path_;
    FileDescriptor descriptor_;
    bool renamed_ = false;
};

// The name does not contain the target's, which may be as long as names can be. O_EXCL keeps it ours; a
// number that another thread or a killed process has taken is passed over.
TemporaryFile::TemporaryFile(const std::filesystem::path& target) {
    constexpr int attempts = 10'000;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        path_ = target.parent_path() / fmt::format(".interleaf-{}-{}", ::getpid(), attempt);
        descriptor_ = FileDescriptor(path_, O_WRONLY | O_CREAT | O_EXCL, 0666);
        if (descriptor_.is_open()) return;
        if (errno != EEXIST) break;
    }
    throw_system_error(target, cannot_write);
}

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

/// Makes the rename last through a power failure. Some file systems and permissions do not allow it; the file
/// is whole all the same, so that is no error.
void flush_folder(const std::filesystem::path& folder) {
    const FileDescriptor descriptor(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
    if (descriptor.is_open()) ::fsync(descriptor.number());
}

}  // namespace

void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    std::error_code error;
    std::filesystem::path target = file;
    if (std::filesystem::is_symlink(file, error)) target = std::filesystem::weakly_canonical(file, error);
    if (error && target.empty()) {
        errno = error.value();
        throw_system_error(file, cannot_write);
    }

    struct stat status {};
    const bool exists = ::stat(target.c_str(), &status) == 0;
    if (exists && !S_ISREG(status.st_mode)) return write_in_place(bytes, target);

    TemporaryFile temporary(target);
    FileDescriptor& descriptor = temporary.descriptor();
    write_all(descriptor, bytes, target);
    if (exists && ::fchmod(descriptor.number(), status.st_mode & 07777) != 0)
        throw_system_error(target, cannot_write);
    if (::fsync(descriptor.number()) != 0 || !descriptor.close() || !temporary.rename_to(target))
        throw_system_error(target, cannot_write);
    flush_folder(target.parent_path());
}

void write_file(const std::filesystem::path& file, std::string_view text) {
    write_file(file, std::as_bytes(std::span(text)));
}

}  // namespace interleaf
