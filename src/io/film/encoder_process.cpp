#include "io/film/encoder_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <system_error>

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "hierarchy/error.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves the declaration to us

namespace interleaf {
namespace {

constexpr const char* encoder = "ffmpeg";

/// The setup of a process that POSIX calls its attributes and its file actions.
class SpawnSetup {
  public:
    SpawnSetup() {
        ::posix_spawnattr_init(&attributes_);
        ::posix_spawn_file_actions_init(&actions_);
    }
    SpawnSetup(const SpawnSetup&) = delete;
    SpawnSetup& operator=(const SpawnSetup&) = delete;
    ~SpawnSetup() {
        ::posix_spawnattr_destroy(&attributes_);
        ::posix_spawn_file_actions_destroy(&actions_);
    }

    void make_standard(int number, const FileDescriptor& file) {
        ::posix_spawn_file_actions_adddup2(&actions_, file.number(), number);
    }

    /// A process group of its own, and no signal blocked.
    void stand_alone() {
        sigset_t none;
        sigemptyset(&none);
        ::posix_spawnattr_setsigmask(&attributes_, &none);
        ::posix_spawnattr_setpgroup(&attributes_, 0);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    }

    /// \return 0, or the number of the system's error
    int start(std::vector<char*>& arguments, int& process) {
        return ::posix_spawnp(&process, arguments.front(), &actions_, &attributes_, arguments.data(),
                              environ);
    }

  private:
    posix_spawnattr_t attributes_{};
    posix_spawn_file_actions_t actions_{};
};

[[noreturn]] void throw_not_started(int error) {
    if (error == ENOENT)
        throw MachineError(
            "there is no ffmpeg, which encodes films (Debian package ffmpeg); single pictures need none: "
            "-o frame.####.png");
    throw MachineError(fmt::format("{}: {}", encoder, std::generic_category().message(error)));
}

}  // namespace

EncoderProcess::EncoderProcess(const std::vector<std::string>& arguments)
    : messages_(::memfd_create(encoder, MFD_CLOEXEC)) {
    // A socket rather than a pipe: writing to an ended process gives an error instead of a signal.
    std::array<int, 2> ends{};
    if (!messages_.is_open() || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw_not_started(errno);
    input_ = FileDescriptor(ends[0]);
    const FileDescriptor their_input(ends[1]);

    std::vector<std::string> texts = arguments;
    texts.insert(texts.begin(), encoder);
    std::vector<char*> pointers;
    pointers.reserve(texts.size() + 1);
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);

    SpawnSetup setup;
    setup.make_standard(STDIN_FILENO, their_input);
    setup.make_standard(STDOUT_FILENO, messages_);
    setup.make_standard(STDERR_FILENO, messages_);
    setup.stand_alone();
    if (const int error = setup.start(pointers, process_); error != 0) {
        process_ = -1;
        throw_not_started(error);
    }
}

EncoderProcess::~EncoderProcess() {
    if (process_ < 0) return;
    kill();
    finish();
}

bool EncoderProcess::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::send(input_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

bool EncoderProcess::finish() {
    input_.close();
    // Until it is forgotten, the ended process keeps its number, so kill() reaches no other process.
    siginfo_t ended{};
    while (::waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
    }
    const std::lock_guard lock(mutex_);
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void EncoderProcess::kill() {
    const std::lock_guard lock(mutex_);
    if (process_ >= 0) ::kill(process_, SIGKILL);
}

std::string EncoderProcess::last_message() const {
    constexpr off_t longest = 4096;
    std::string text(static_cast<std::size_t>(longest), '\0');
    const off_t size = ::lseek(messages_.number(), 0, SEEK_END);
    const ssize_t count =
        ::pread(messages_.number(), text.data(), text.size(), size > longest ? size - longest : 0);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    text.erase(text.find_last_not_of("\n\r ") + 1);
    const std::size_t line = text.find_last_of("\n\r");
    return line == std::string::npos ? text : text.substr(line + 1);
}

}  // namespace interleaf
