#include "app/cli/reference_subcommands.h"

#include <memory>
#include <string>

#include <fmt/core.h>

#include "app/cli/manual_page.h"
#include "app/cli/shell_completions.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

void add_help(CLI::App& program) {
    const auto name = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("help", "Print the help of a command");
    command->footer("");  // not that of the program, which a command inherits
    command->add_option("COMMAND", *name, "A command; by default, the program");
    command->final_callback([name, &program] {
        if (name->empty()) {
            // App::help() would print the help of the command in use.
            const auto text =
                program.get_formatter()->make_help(&program, program.get_name(), CLI::AppFormatMode::Normal);
            fmt::print("{}", text);
            return;
        }
        try {
            fmt::print("{}", program.get_subcommand(*name)->help(program.get_name()));
        } catch (const CLI::OptionNotFound&) {
            throw UsageError(fmt::format("help: there is no command '{}'", *name));
        }
    });
}

void add_manual(CLI::App& program) {
    CLI::App* command = program.add_subcommand("manual", "Print the manual page, in the form that man reads");
    command->final_callback([&program] { fmt::print("{}", manual_page(program, INTERLEAF_VERSION)); });
    command->footer(
        "Example:\n"
        "  interleaf manual | man -l -");
}

void add_completions(CLI::App& program) {
    const auto shell = std::make_shared<std::string>();
    CLI::App* command =
        program.add_subcommand("completions", "Print a script that completes command lines in a shell");
    command->add_option("SHELL", *shell, "bash, zsh or fish")->required();
    command->final_callback([shell, &program] {
        const auto named = shell_named(*shell);
        if (!named)
            throw UsageError(fmt::format("completions: expected bash, zsh or fish, got '{}'", *shell));
        fmt::print("{}", shell_completions(program, *named));
    });
    command->footer(
        "Example:\n"
        "  source <(interleaf completions bash)");
}

}  // namespace

void add_reference_subcommands(CLI::App& program) {
    add_help(program);
    add_manual(program);
    add_completions(program);
}

}  // namespace interleaf
