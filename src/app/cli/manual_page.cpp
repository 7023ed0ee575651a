#include "app/cli/manual_page.h"

#include <fmt/core.h>

namespace interleaf {
namespace {

/// \p text without what roff takes for a command.
std::string escaped(std::string_view text) {
    std::string result;
    bool starts_line = true;
    for (const char c : text) {
        // A point or an apostrophe at the start of a line begins a command.
        if (starts_line && (c == '.' || c == '\'')) result += "\\&";
        starts_line = c == '\n';
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if (c == '\'')
            result += "\\(aq";
        else
            result += c;
    }
    return result;
}

/// Text whose line breaks and spaces count, such as examples.
std::string verbatim(std::string_view text) {
    return text.empty() ? "" : fmt::format(".PP\n.nf\n{}\n.fi\n", escaped(text));
}

std::string option_entry(const CLI::Option& option) {
    const std::string type = option.get_positional() ? "" : option.get_type_name();
    std::string entry =
        fmt::format(".TP\n\\fB{}\\fR", escaped(option.get_name(option.get_positional(), true)));
    if (!type.empty()) entry += fmt::format(" \\fI{}\\fR", escaped(type));
    entry += "\n" + escaped(option.get_description());
    if (option.get_required() && !option.get_positional()) entry += " (required)";
    if (!option.get_default_str().empty())
        entry += fmt::format(" (default {})", escaped(option.get_default_str()));
    return entry + "\n";
}

std::string option_entries(const CLI::App& command) {
    std::string entries;
    for (const CLI::Option* option : command.get_options())
        if (option != command.get_help_ptr() && !option->get_group().empty())
            entries += option_entry(*option);
    return entries;
}

std::string command_section(const CLI::App& command) {
    return fmt::format(".SS {}\n{}\n{}{}", escaped(command.get_name()), escaped(command.get_description()),
                       option_entries(command), verbatim(command.get_footer()));
}

}  // namespace

std::string manual_page(const CLI::App& program, std::string_view version) {
    const std::string& name = program.get_name();
    std::string page = fmt::format(
        ".TH INTERLEAF 1 \"\" \"{0} {1}\" \"User Commands\"\n"
        ".SH NAME\n{0} \\- {2}\n"
        ".SH SYNOPSIS\n.B {0}\n[\\fIFILE\\fR...]\n.br\n.B {0}\n\\fICOMMAND\\fR [\\fIOPTION\\fR...]\n"
        ".SH DESCRIPTION\n{2} Without a command, the viewer opens the files.\n"
        ".SH OPTIONS\n{3}.SH COMMANDS\n",
        name, version, escaped(program.get_description()), option_entries(program));
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        page += command_section(*command);
    return page + ".SH NOTES\n" + verbatim(program.get_footer());
}

}  // namespace interleaf
