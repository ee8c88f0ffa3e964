#include "host/commands/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <string_view>

#include "host/commands/help.hpp"
#include "host/error.hpp"
#include "host/text/nearest.hpp"

namespace pxm::host {

namespace {

CLI::Validator validator(const OptionCheck& check) { return {check.look, check.range, ""}; }

std::vector<const CLI::App*> all_commands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

bool is_hidden(const CLI::App* command) { return command->get_group().empty(); }

/// CLI11 only says that a command is missing; a misspelt one is named here.
void require_known_command(const CLI::App& app, int argc, const char* const* argv) {
    const std::string word = argc > 1 ? argv[1] : "-";
    if (word.starts_with('-')) return;
    std::string known;
    std::vector<std::string_view> names;
    for (const CLI::App* command : all_commands(app)) {
        if (command->get_name() == word) return;
        if (is_hidden(command)) continue;
        known += " " + command->get_name();
        names.push_back(command->get_name());
    }
    throw Error(ErrorKind::setting, "unknown command \"" + word + "\", expected one of" + known +
                                        suggestion(word, names));
}

/// The command that is given, or the program itself.
const CLI::App& given_command(const CLI::App& app) {
    const auto given = app.get_subcommands();
    return given.empty() ? app : *given.front();
}

std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    if (names.empty()) names.push_back(option.get_name());
    return names;
}

/// For the first word that looks like an option and is none. The dashes are in all of them: they
/// make no two names alike.
std::string suggest_option(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : given_command(app).get_options())
        for (const std::string& name : option->get_lnames()) names.push_back(name);
    for (const std::string& word : app.remaining(true)) {
        if (!word.starts_with('-')) continue;
        const std::string bare = word.substr(std::min(word.find_first_not_of('-'), word.size()));
        const std::string_view near =
            nearest(bare.substr(0, bare.find('=')), {names.begin(), names.end()});
        return near.empty() ? "" : " (did you mean '--" + std::string(near) + "'?)";
    }
    return "";
}

OptionFacts facts_of(const CLI::Option& option) {
    OptionFacts facts;
    facts.names = names_of(option);
    facts.is_argument = option.get_positional();
    facts.what = option.get_description();
    facts.required = option.get_required();
    facts.several = option.get_items_expected_max() > 1;
    if (option.get_items_expected_max() == 0) return facts;
    const std::string type = option.get_type_name();
    const std::size_t colon = std::min(type.find(':'), type.size());
    facts.value = type.substr(0, colon);
    facts.range = type.substr(std::min(colon + 1, type.size()));
    if (facts.value == "UINT" || facts.value == "INT") facts.value = "N";
    if (facts.value == "FLOAT") facts.value = "NUMBER";
    return facts;
}

CommandFacts facts_of(const CLI::App& command, const std::string& name) {
    CommandFacts facts{name, command.get_description(), {}};
    for (const CLI::Option* option : command.get_options())
        facts.options.push_back(facts_of(*option));
    std::ranges::stable_partition(facts.options, &OptionFacts::is_argument);
    return facts;
}

std::string usage_error(const std::string& message) {
    return message + "\ntry: pxm --help, or pxm COMMAND --help";
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

Option& Option::may_lack_value(const std::string& meant) {
    option_->expected(0, 1)->default_str(meant);
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

void CommandOptions::hide() { app_->group(""); }

bool CommandOptions::given() const { return app_->parsed(); }

CommandLine::CommandLine(const std::string& name, const std::string& what,
                         const std::string& version)
    : app_(std::make_unique<CLI::App>(what, name)) {
    app_->set_version_flag("--version", version,
                           "Print the version; with --json what it was built of, and exit");
    app_->require_subcommand(1);
    app_->failure_message(CLI::FailureMessage::simple);
}

CommandLine::~CommandLine() = default;

CommandOptions CommandLine::add_command(const std::string& name, const std::string& what) {
    return CommandOptions(*app_->add_subcommand(name, what));
}

void CommandLine::name_values(const std::vector<ValueName>& names) {
    for (CLI::App* command : app_->get_subcommands([](CLI::App*) { return true; })) {
        for (const ValueName& name : names) {
            if (!name.command.empty() && name.command != command->get_name()) continue;
            // Not by get_option_no_throw(): it is noexcept and copies names, so that a lack of
            // memory would end the process.
            for (CLI::Option* option : command->get_options())
                if (option->check_name(name.option)) option->type_name(name.value);
        }
    }
}

std::vector<CommandFacts> CommandLine::facts() const {
    std::vector<CommandFacts> facts{facts_of(*app_, "")};
    for (const CLI::App* command : all_commands(*app_))
        if (!is_hidden(command)) facts.push_back(facts_of(*command, command->get_name()));
    return facts;
}

std::optional<std::string> CommandLine::read(int argc, const char* const* argv) {
    require_known_command(*app_, argc, argv);
    try {
        app_->parse(argc, argv);
    } catch (const CLI::Success& success) {
        std::ostringstream text, messages;  // --help, --version; both are no failure
        app_->exit(success, text, messages);
        if (success.get_name() != "CallForHelp") return text.str();
        const CLI::App& command = given_command(*app_);
        return help_text(&command == app_.get() ? "" : command.get_name(), text.str());
    } catch (const CLI::ExtrasError& error) {
        throw Error(ErrorKind::setting, usage_error(error.what() + suggest_option(*app_)));
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorKind::setting, usage_error(error.what()));
    }
    return std::nullopt;
}

}  // namespace pxm::host
