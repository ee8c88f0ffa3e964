#include "host/commands/manual.hpp"

#include <fmt/format.h>

#include <string_view>

#include "host/commands/help.hpp"

namespace pxm::host {

namespace {

/// As scdoc shows it: marks are taken for what they are.
std::string plain(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (std::string_view("\\*_").find(c) != std::string_view::npos) escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string bold(std::string_view text) { return "*" + plain(text) + "*"; }
std::string placeholder(std::string_view text) { return "_" + plain(text) + "_"; }

std::string page_of(const CommandFacts& command) {
    return command.name.empty() ? "pxm" : "pxm-" + command.name;
}

std::string head(const std::string& page, int section, std::string_view what) {
    return fmt::format("{}({}) \"pxm {}\" \"pxm\"\n\n# NAME\n\n{} - {}\n\n", page, section,
                       PXM_VERSION, page, plain(what));
}

/// `*-o*, *--out* _FILE_`, or the word of an argument.
std::string term(const OptionFacts& option) {
    if (option.is_argument) return placeholder(option.names.front());
    std::string names;
    for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + bold(name);
    return option.value.empty() ? names : names + " " + placeholder(option.value);
}

std::string options(const CommandFacts& command) {
    std::string text = "# OPTIONS\n\n";
    for (const OptionFacts& option : command.options) {
        text += term(option) + "\n\t" + plain(option.what);
        if (option.is_argument && option.value.find('|') != std::string::npos)
            text += "; one of " + placeholder(option.value);
        if (!option.range.empty()) text += "; " + option.range;
        if (option.several) text += "; may be given again";
        if (option.required && !option.is_argument) text += "; required";
        text += text.ends_with('.') ? "\n\n" : ".\n\n";
    }
    return text;
}

std::string synopsis(const CommandFacts& command) {
    std::string text = "# SYNOPSIS\n\n*pxm*";
    if (command.name.empty()) return text + " _command_ [_options_] [_arguments_]\n\n";
    text += " " + bold(command.name);
    for (const OptionFacts& option : command.options) {
        if (!option.is_argument && !option.required) continue;
        const std::string one = term(option) + (option.several ? "..." : "");
        text += option.required ? " " + one : " [" + one + "]";
    }
    return text + " [_options_]\n\n";
}

std::string list_of(const std::vector<CommandFacts>& commands) {
    std::string text = "# COMMANDS\n\n";
    for (const CommandFacts& command : commands) {
        if (command.name.empty()) continue;
        text += fmt::format("{}(1)\n\t{}.\n\n", bold(page_of(command)), plain(command.what));
    }
    return text;
}

std::string examples(const CommandFacts& command) {
    std::string text = "# EXAMPLES\n\n";
    for (const Example& example : examples_of(command.name))
        text += fmt::format("{}:\n\n```\n{}\n```\n\n", plain(example.what), example.line);
    return text;
}

std::string exit_status() {
    std::string text = "# EXIT STATUS\n\n";
    for (const ExitCodeMeaning& one : exit_code_meanings())
        text += fmt::format("*{}*\n\t{}.\n\n", one.code, plain(one.meaning));
    return text;
}

std::string see_also(const std::string& page, const std::vector<CommandFacts>& commands) {
    std::string text = "# SEE ALSO\n\n";
    for (const CommandFacts& command : commands)
        if (page_of(command) != page) text += bold(page_of(command)) + "(1), ";
    return text + "*pxm-scene*(5)\n";
}

std::string ended(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return text + "\n\n";
}

}  // namespace

std::string command_page(const CommandFacts& command, const std::vector<CommandFacts>& commands,
                         const std::string& text) {
    const std::string page = page_of(command);
    return head(page, 1, command.what) + synopsis(command) + "# DESCRIPTION\n\n" + ended(text) +
           (command.name.empty() ? list_of(commands) : "") + options(command) + examples(command) +
           exit_status() + see_also(page, commands);
}

std::string scene_page(const std::string& text) {
    return head("pxm-scene", 5, "the language of scenes") + ended(text) +
           "# SEE ALSO\n\n*pxm*(1), *pxm-render*(1), *pxm-check*(1)\n";
}

}  // namespace pxm::host
