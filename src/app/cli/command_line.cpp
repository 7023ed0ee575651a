#include "app/cli/command_line.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <sstream>
#include <string>

#include <fmt/core.h>

#include "app/cli/error_message.h"
#include "app/cli/reference_subcommands.h"
#include "app/cli/shared_options.h"
#include "app/cli/subcommands.h"
#include "app/cli/view_command.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

enum ExitStatus { done = 0, input_at_fault = 1, command_line_at_fault = 2, machine_at_fault = 3 };

/// Help without details that users do not need: the types of names, and which options exclude each other.
class HelpFormatter : public CLI::Formatter {
  public:
    HelpFormatter() { column_width(34); }

    std::string make_option_opts(const CLI::Option* option) const override {
        return option->get_positional() || option->get_type_name().empty() ? ""
                                                                           : " " + option->get_type_name();
    }

    std::string make_option_desc(const CLI::Option* option) const override {
        const std::string& text = option->get_description();
        if (option->get_required() && !option->get_positional()) return text + " (required)";
        return option->get_default_str().empty() ? text
                                                 : text + " (default " + option->get_default_str() + ")";
    }
};

/// Adds `interleaf [FAMILY...]`: without a command, the program views the family.
void add_bare_view(CLI::App& program) {
    const auto options = std::make_shared<ViewOptions>();
    add_family_or_keys(program, "FAMILY", viewed_help(), options->family);
    program.final_callback([options, &program] {
        if (!program.get_subcommands().empty()) return;
        std::error_code error;
        if (!options->family.empty() && !options->family.front().has_extension() &&
            !std::filesystem::exists(options->family.front(), error)) {
            throw UsageError(
                fmt::format("{}: neither a command nor a file", options->family.front().string()));
        }
        run_view(*options);
    });
}

/// Parses the command line and runs the command it names.
ExitStatus run(CLI::App& program, int argument_count, const char* const* arguments) {
    CheckResult checked = CheckResult::sound;
    add_subcommands(program, checked);
    add_reference_subcommands(program);
    add_bare_view(program);
    program.parse(argument_count, arguments);
    if (checked == CheckResult::unread) return machine_at_fault;
    return checked == CheckResult::sound ? done : input_at_fault;
}

/// Prints the help, the version, or the error in the command line.
ExitStatus answer(const CLI::App& program, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
        std::ostringstream text;
        program.exit(error, text, text);
        fmt::print("{}", text.str());
        return done;
    }
    print_error(error.what());
    return command_line_at_fault;
}

ExitStatus run_and_report(int argument_count, const char* const* arguments) {
    CLI::App program("Interpolates between triangle surfaces that have different meshes.", "interleaf");
    program.formatter(std::make_shared<HelpFormatter>());
    program.set_help_flag("-h,--help", "Print this help and exit");
    program.set_version_flag("--version", "interleaf " INTERLEAF_VERSION, "Print the version and exit");
    program.require_subcommand(0, 1);
    program.footer(
        "Exit status: 0 done, 1 the input is at fault, 2 the command line is at fault,\n"
        "3 the machine is at fault.\n\n"
        "Examples:\n"
        "  interleaf                      open the viewer with the built-in five keys\n"
        "  interleaf star.ilh             open a key\n"
        "  interleaf render --help        print how to draw without a display");
    try {
        return run(program, argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        return answer(program, error);
    } catch (const InputError& error) {
        print_error(error.what());
        return input_at_fault;
    } catch (const UsageError& error) {
        print_error(error.what());
        return command_line_at_fault;
    } catch (const std::bad_alloc&) {
        print_error("out of memory");
        return machine_at_fault;
    } catch (const std::exception& error) {
        print_error(error.what());
        return machine_at_fault;
    }
}

}  // namespace

int run_command_line(int argument_count, const char* const* arguments) {
    const ExitStatus status = run_and_report(argument_count, arguments);
    if (status == machine_at_fault || std::fflush(stdout) == 0) return status;
    print_error(fmt::format("standard output: {}", std::strerror(errno)));
    return machine_at_fault;
}

}  // namespace interleaf
