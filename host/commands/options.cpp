#include "host/commands/options.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "host/error.hpp"

namespace pxm::host {

namespace {

CLI::Validator validator(const OptionCheck& check) { return {check.look, check.range, ""}; }

/// CLI11 only says that a command is missing; a misspelt one is named here.
void require_known_command(const CLI::App& app, int argc, const char* const* argv) {
    const std::string word = argc > 1 ? argv[1] : "-";
    if (word.starts_with('-')) return;
    std::string known;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == word) return;
        known += " " + command->get_name();
    }
    throw Error(ErrorKind::setting, "unknown command \"" + word + "\", expected one of" + known);
}

}  // namespace

Option& Option::required() {
    option_->required();
    return *this;
}

Option& Option::one_value() {
    option_->allow_extra_args(false);
    return *this;
}

Option& Option::delimiter(char between) {
    option_->delimiter(between);
    return *this;
}

Option& Option::excludes(const Option& other) {
    option_->excludes(other.option_);
    return *this;
}

Option& Option::transform(const OptionCheck& check) {
    option_->transform(validator(check));
    return *this;
}

Option& Option::check(const OptionCheck& check) {
    option_->check(validator(check));
    return *this;
}

template <class Value>
Option CommandOptions::add_option(const std::string& names, Value& value, const std::string& what) {
    return Option(*app_->add_option(names, value, what));
}

template Option CommandOptions::add_option(const std::string&, std::string&, const std::string&);
template Option CommandOptions::add_option(const std::string&, std::vector<std::string>&,
                                           const std::string&);
template Option CommandOptions::add_option(const std::string&, int&, const std::string&);
template Option CommandOptions::add_option(const std::string&, long&, const std::string&);
template Option CommandOptions::add_option(const std::string&, std::uint64_t&, const std::string&);
template Option CommandOptions::add_option(const std::string&, double&, const std::string&);
template Option CommandOptions::add_option(const std::string&, std::optional<long>&,
                                           const std::string&);
template Option CommandOptions::add_option(const std::string&, std::optional<double>&,
                                           const std::string&);

Option CommandOptions::add_flag(const std::string& names, bool& value, const std::string& what) {
    return Option(*app_->add_flag(names, value, what));
}

void CommandOptions::check_all(const OptionCheck& check) {
    for (CLI::Option* option : app_->get_options()) {
        if (option->get_expected_min() > 0) option->check(validator(check));
    }
}

bool CommandOptions::given() const { return app_->parsed(); }

CommandLine::CommandLine(const std::string& name, const std::string& what,
                         const std::string& version)
    : app_(std::make_unique<CLI::App>(what, name)) {
    app_->set_version_flag("--version", version);
    app_->require_subcommand(1);
    app_->failure_message(CLI::FailureMessage::simple);
}

CommandLine::~CommandLine() = default;

CommandOptions CommandLine::add_command(const std::string& name, const std::string& what) {
    return CommandOptions(*app_->add_subcommand(name, what));
}

std::optional<std::string> CommandLine::read(int argc, const char* const* argv) {
    require_known_command(*app_, argc, argv);
    try {
        app_->parse(argc, argv);
    } catch (const CLI::Success& success) {
        std::ostringstream text, messages;  // --help, --version; both are no failure
        app_->exit(success, text, messages);
        return text.str();
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorKind::setting,
                    std::string(error.what()) + "\ntry: pxm --help, or pxm COMMAND --help");
    }
    return std::nullopt;
}

}  // namespace pxm::host
