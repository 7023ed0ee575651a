#include "cli/process.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "scratch_folder.h"
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace interleaf {
namespace {

void redirect(int stream, const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (descriptor < 0 || ::dup2(descriptor, stream) < 0) ::_exit(127);
}

void limit_files(std::size_t bytes) {
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_IGN);
}

[[noreturn]] void become_interleaf(const std::vector<std::string>& arguments,
                                   const Surroundings& surroundings, const std::filesystem::path& output,
                                   const std::filesystem::path& errors) {
    redirect(STDOUT_FILENO, output);
    redirect(STDERR_FILENO, errors);
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    if (surroundings.display) ::setenv("DISPLAY", surroundings.display->c_str(), 1);
    if (surroundings.max_file_size) limit_files(*surroundings.max_file_size);

    std::vector<std::string> words = {"interleaf"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execv(INTERLEAF_PROGRAM, pointers.data());
    ::_exit(127);
}

}  // namespace

Outcome run_interleaf(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
    const ScratchFolder folder;
    const std::filesystem::path output = surroundings.standard_output.value_or(folder.path() / "output");
    const std::filesystem::path errors = folder.path() / "errors";
    const pid_t child = ::fork();
    if (child == 0) become_interleaf(arguments, surroundings, output, errors);
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, surroundings.standard_output ? "" : content(output),
            content(errors)};
}

bool is_one_message(const std::string& text) {
    return text.starts_with("interleaf: ") && text.ends_with('\n') && std::ranges::count(text, '\n') == 1;
}

}  // namespace interleaf
