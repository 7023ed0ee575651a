#include "app/cli/shell_completions.h"

#include <vector>

#include <fmt/core.h>
#include <fmt/format.h>

#include "text/shell_word.h"

namespace interleaf {
namespace {

struct Flag {
    std::string name;  ///< with its dashes
    std::string description;
};

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<Flag> flags_of(const CLI::App& command) {
    std::vector<Flag> flags;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_snames())
            flags.push_back({"-" + name, option->get_description()});
        for (const std::string& name : option->get_lnames())
            flags.push_back({"--" + name, option->get_description()});
    }
    return flags;
}

std::string names_of(const std::vector<Flag>& flags) {
    std::string names;
    for (const Flag& flag : flags) names += (names.empty() ? "" : " ") + flag.name;
    return names;
}

/// As quoted_shell_word(), for `_describe` of zsh, which takes what follows a colon for the description.
std::string zsh_entry(std::string_view name, std::string_view description) {
    return quoted_shell_word(fmt::format("{}:{}", name, description));
}

std::string bash_script(const CLI::App& program) {
    std::string commands;
    std::string cases;
    for (const CLI::App* command : commands_of(program)) {
        commands += command->get_name() + " ";
        cases += fmt::format("        {}) words={} ;;\n", command->get_name(),
                             quoted_shell_word(names_of(flags_of(*command))));
    }
    return fmt::format(R"(# bash completion of {0}
_{0}() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} words
    case ${{COMP_WORDS[1]}} in
{1}        *) words={2} ;;
    esac
    if ((COMP_CWORD == 1)); then words={3}; fi
    if [[ $word == -* ]] || ((COMP_CWORD == 1)); then COMPREPLY=($(compgen -W "$words" -- "$word")); fi
}}
complete -o bashdefault -o default -F _{0} {0}
)",
                       program.get_name(), cases, quoted_shell_word(names_of(flags_of(program))),
                       quoted_shell_word(commands + names_of(flags_of(program))));
}

std::string zsh_script(const CLI::App& program) {
    std::string commands;
    std::string cases;
    for (const CLI::App* command : commands_of(program)) {
        commands += "        " + zsh_entry(command->get_name(), command->get_description()) + "\n";
        cases += fmt::format("        {})\n            flags=(\n", command->get_name());
        for (const Flag& flag : flags_of(*command))
            cases += "                " + zsh_entry(flag.name, flag.description) + "\n";
        cases += "            ) ;;\n";
    }
    return fmt::format(R"(#compdef {0}
_{0}() {{
    local -a commands flags
    commands=(
{1}    )
    if ((CURRENT == 2)); then
        _describe command commands
        _files
        return
    fi
    case $words[2] in
{2}    esac
    if [[ $words[CURRENT] == -* ]]; then _describe option flags; else _files; fi
}}
_{0} "$@"
)",
                       program.get_name(), commands, cases);
}

std::string fish_script(const CLI::App& program) {
    std::string script = fmt::format("# fish completion of {}\n", program.get_name());
    for (const CLI::App* command : commands_of(program)) {
        script += fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d {}\n", program.get_name(),
                              command->get_name(), quoted_shell_word(command->get_description()));
        for (const Flag& flag : flags_of(*command)) {
            const bool is_long = flag.name.starts_with("--");
            script += fmt::format("complete -c {} -n '__fish_seen_subcommand_from {}' -{} {} -d {}\n",
                                  program.get_name(), command->get_name(), is_long ? 'l' : 's',
                                  flag.name.substr(is_long ? 2 : 1), quoted_shell_word(flag.description));
        }
    }
    return script;
}

}  // namespace

std::optional<Shell> shell_named(std::string_view name) {
    if (name == "bash") return Shell::bash;
    if (name == "zsh") return Shell::zsh;
    if (name == "fish") return Shell::fish;
    return {};
}

std::string shell_completions(const CLI::App& program, Shell shell) {
    switch (shell) {
        case Shell::bash:
            return bash_script(program);
        case Shell::zsh:
            return zsh_script(program);
        case Shell::fish:
            return fish_script(program);
    }
    return {};
}

}  // namespace interleaf
