#include "driver/shell_files.h"

#include "driver/environment.h"
#include "driver/file_system.h"

#include <CLI/CLI.hpp>

#include <cctype>

namespace gliftc {

namespace {

bool is_shown(const CLI::App& app) { return !app.get_group().empty(); }
bool is_shown(const CLI::Option& option) { return !option.get_group().empty(); }

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    std::vector<const CLI::App*> commands;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App* each) { return is_shown(*each); }))
        commands.push_back(command);
    return commands;
}

/// Options that begin with a dash, not positional arguments.
std::vector<const CLI::Option*> options_of(const CLI::App& app) {
    std::vector<const CLI::Option*> options;
    for (const CLI::Option* option : app.get_options())
        if (is_shown(*option) && !option->get_positional()) options.push_back(option);
    return options;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// `-o`, `--output`.
std::vector<std::string> spellings_of(const CLI::Option& option) {
    std::vector<std::string> words;
    for (const std::string& name : option.get_snames()) words.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) words.push_back("--" + name);
    return words;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/// A description on one line.
std::string line_of(const std::string& text) { return replaced(text, "\n", " "); }

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
    std::vector<std::string> names;
    for (const CLI::App* command : commands) names.push_back(command->get_name());
    return names;
}

std::vector<std::string> all_spellings(const CLI::App& app) {
    std::vector<std::string> words;
    for (const CLI::Option* option : options_of(app))
        for (const std::string& word : spellings_of(*option)) words.push_back(word);
    return words;
}

// --- manual pages

/// Text of a manual page: backslashes and dashes as they are, and no line that begins with a command of roff.
std::string roff(const std::string& text) {
    std::string result = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
    if (result.starts_with('.') || result.starts_with('\'')) result.insert(0, "\\&");
    return replaced(replaced(result, "\n.", "\n\\&."), "\n'", "\n\\&'");
}

std::string option_entry(const CLI::Option& option) {
    std::vector<std::string> words;
    for (const std::string& word : spellings_of(option)) words.push_back("\\fB" + roff(word) + "\\fR");
    const std::string value = takes_value(option) ? " \\fI" + roff(option.get_type_name()) + "\\fR" : "";
    return ".TP\n" + joined(words, ", ") + value + "\n" + roff(line_of(option.get_description())) + "\n";
}

std::string man_page(const CLI::App& app, const CLI::App* command, const std::string& version) {
    const CLI::App& shown = command != nullptr ? *command : app;
    const std::string program = app.get_name(), spaced = command ? program + " " + command->get_name() : program;
    const std::string page = replaced(spaced, " ", "-");
    std::string title = page;
    for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    std::string text = ".TH " + title + " 1 \"\" \"" + program + " " + version + "\" \"Glift\"\n.SH NAME\n" +
                       roff(page) + " \\- " + roff(line_of(shown.get_description())) + "\n.SH SYNOPSIS\n.B " +
                       roff(spaced) + "\n[\\fIoptions\\fR]";
    for (const CLI::Option* option : shown.get_options())
        if (option->get_positional() && is_shown(*option)) text += " \\fI" + roff(option->get_type_name()) + "\\fR";
    text += "\n.SH OPTIONS\n";
    for (const CLI::Option* option : options_of(shown)) text += option_entry(*option);
    if (command == nullptr) {
        text += ".SH COMMANDS\n";
        for (const CLI::App* each : commands_of(app))
            text += ".TP\n\\fB" + roff(program + "-" + each->get_name()) + "\\fR(1)\n" +
                    roff(line_of(each->get_description())) + "\n";
    } else {
        text += ".PP\nThe options of \\fB" + program + "\\fR(1) are understood, too.\n";
    }
    if (!shown.get_footer().empty()) text += ".SH NOTES\n" + roff(shown.get_footer()) + "\n";
    text += ".SH SEE ALSO\n" + (command ? "\\fB" + program + "\\fR(1)" : "\\fI/usr/share/doc/glift\\fR") + "\n";
    return text;
}

// --- completion

std::string bash_completion(const CLI::App& app) {
    const std::string program = app.get_name();
    const std::vector<const CLI::App*> commands = commands_of(app);
    const std::string common = joined(all_spellings(app), " ");
    std::string text = "# Completion of " + program + " for bash. Made by " + program + ".\n_" + program +
                       "() {\n    local word=${COMP_WORDS[COMP_CWORD]} command= each options\n"
                       "    for each in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n        case $each in\n            " +
                       joined(names_of(commands), "|") +
                       ") command=$each; break ;;\n        esac\n    done\n"
                       "    case $command in\n";
    for (const CLI::App* command : commands)
        text += "        " + command->get_name() + ") options=\"" + joined(all_spellings(*command), " ") + " " +
                common + "\" ;;\n";
    text += "        *) options=\"" + common +
            "\" ;;\n    esac\n    if [[ $word == -* ]]; then\n"
            "        COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n        return\n    fi\n"
            "    COMPREPLY=($(compgen -f -X '!*.glift' -- \"$word\") $(compgen -d -- \"$word\"))\n"
            "    [[ $command ]] || COMPREPLY+=($(compgen -W \"" +
            joined(names_of(commands), " ") + "\" -- \"$word\"))\n}\ncomplete -o filenames -F _" + program + " " +
            program + "\n";
    return text;
}

/// Text between single quotes of a shell.
std::string single_quoted(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }

/// One option as an argument of zsh's _arguments.
std::string zsh_option(const CLI::Option& option) {
    const std::string about = replaced(replaced(line_of(option.get_description()), "[", "("), "]", ")");
    const std::string value = takes_value(option) ? ":" + option.get_type_name() + ":_files" : "";
    std::string text;
    for (const std::string& word : spellings_of(option))
        text += " \\\n            " + single_quoted("*" + word + "[" + replaced(about, ":", "\\:") + "]" + value);
    return text;
}

std::string zsh_options(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : options_of(app)) text += zsh_option(*option);
    return text;
}

std::string zsh_completion(const CLI::App& app) {
    const std::string program = app.get_name();
    std::string text = "#compdef " + program + "\n# Completion of " + program + " for zsh. Made by " + program +
                       ".\nlocal -a commands\ncommands=(\n";
    for (const CLI::App* command : commands_of(app))
        text += "    " + single_quoted(command->get_name() + ":" + line_of(command->get_description())) + "\n";
    text += ")\nlocal files='*:file:_files -g \"*.glift(-.)\"'\n"
            "(( CURRENT == 2 )) && [[ ${words[2]} != -* ]] && _describe command commands\ncase ${words[2]} in\n";
    for (const CLI::App* command : commands_of(app))
        text += "    " + command->get_name() + ")\n        _arguments $files" + zsh_options(*command) +
                zsh_options(app) + "\n        ;;\n";
    return text + "    *)\n        _arguments $files" + zsh_options(app) + "\n        ;;\nesac\n";
}

std::string fish_options(const std::string& program, const CLI::App& app, const std::string& condition) {
    std::string text;
    for (const CLI::Option* option : options_of(app)) {
        text += "complete -c " + program + condition;
        for (const std::string& name : option->get_snames()) text += " -s " + name;
        for (const std::string& name : option->get_lnames()) text += " -l " + name;
        text +=
            (takes_value(*option) ? " -r" : "") + (" -d " + single_quoted(line_of(option->get_description()))) + "\n";
    }
    return text;
}

std::string fish_completion(const CLI::App& app) {
    const std::string program = app.get_name();
    std::string text = "# Completion of " + program + " for fish. Made by " + program + ".\n";
    for (const CLI::App* command : commands_of(app))
        text += "complete -c " + program + " -n __fish_use_subcommand -a " + command->get_name() + " -d " +
                single_quoted(line_of(command->get_description())) + "\n";
    text += fish_options(program, app, "");
    for (const CLI::App* command : commands_of(app))
        text += fish_options(program, *command, " -n '__fish_seen_subcommand_from " + command->get_name() + "'");
    return text;
}

}  // namespace

std::vector<ShellFile> shell_files(const CLI::App& app, const std::string& version) {
    const std::string program = app.get_name();
    std::vector<ShellFile> files{{"man1/" + program + ".1", man_page(app, nullptr, version)},
                                 {"bash/" + program, bash_completion(app)},
                                 {"zsh/_" + program, zsh_completion(app)},
                                 {"fish/" + program + ".fish", fish_completion(app)}};
    for (const CLI::App* command : commands_of(app))
        files.push_back({"man1/" + program + "-" + command->get_name() + ".1", man_page(app, command, version)});
    return files;
}

void write_shell_files(const CLI::App& app, const std::string& version, const std::string& folder) {
    for (const ShellFile& file : shell_files(app, version)) {
        const std::string path = folder + "/" + file.path;
        if (const auto error = write_if_changed(path, file.text))
            throw EnvironmentError("cannot write '" + path + "': " + *error);
    }
}

}  // namespace gliftc
