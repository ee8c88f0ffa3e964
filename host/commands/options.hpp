// The command line as the commands state it: their options, what is checked of them, where their
// values go. Its .cpp alone knows CLI11, whose header costs more to compile than all commands
// together.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/commands/command_facts.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/option_values.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace pxm::host {

/// An option or argument of a command.
class Option {
  public:
    explicit Option(CLI::Option& option) : option_(&option) {}
    Option& required();
    /// What follows the value is another argument.
    Option& one_value();
    /// Without a value of its own it means this one.
    Option& may_lack_value(const std::string& meant);
    /// One text may hold several values.
    Option& delimiter(char between);
    Option& excludes(const Option& other);
    /// The check puts a canonical text in place of what was written.
    Option& transform(const OptionCheck& check);
    Option& check(const OptionCheck& check);

  private:
    CLI::Option* option_;
};

/// A command and its options.
class CommandOptions {
  public:
    explicit CommandOptions(CLI::App& app) : app_(&app) {}
    /// `Value` is a string, a number, one of them that may be absent, or several strings.
    template <class Value>
    Option add_option(const std::string& names, Value& value, const std::string& what);
    Option add_flag(const std::string& names, bool& value, const std::string& what);
    /// Of every option that takes a value.
    void check_all(const OptionCheck& check);
    /// It is not spoken of.
    void hide();
    /// Whether the command line gave this command.
    [[nodiscard]] bool given() const;
    [[nodiscard]] CLI::App& app() const { return *app_; }

  private:
    CLI::App* app_;
};

extern template Option CommandOptions::add_option(const std::string&, std::string&,
                                                  const std::string&);
extern template Option CommandOptions::add_option(const std::string&, std::vector<std::string>&,
                                                  const std::string&);
extern template Option CommandOptions::add_option(const std::string&, int&, const std::string&);
extern template Option CommandOptions::add_option(const std::string&, long&, const std::string&);
extern template Option CommandOptions::add_option(const std::string&, std::uint64_t&,
                                                  const std::string&);
extern template Option CommandOptions::add_option(const std::string&, double&, const std::string&);
extern template Option CommandOptions::add_option(const std::string&, std::optional<long>&,
                                                  const std::string&);
extern template Option CommandOptions::add_option(const std::string&, std::optional<double>&,
                                                  const std::string&);

/// The whole command line.
class CommandLine {
  public:
    CommandLine(const std::string& name, const std::string& what, const std::string& version);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    [[nodiscard]] CommandOptions add_command(const std::string& name, const std::string& what);
    /// Says what options take, where their numbers do not say it.
    void name_values(const std::vector<ValueName>& names);
    /// Of all commands that are not hidden; the program itself first.
    [[nodiscard]] std::vector<CommandFacts> facts() const;
    /// Puts the values where the options want them. The text to print instead if it asks for help
    /// or the version. Throws Error for what it cannot be read as.
    [[nodiscard]] std::optional<std::string> read(int argc, const char* const* argv);

  private:
    std::unique_ptr<CLI::App> app_;
};

}  // namespace pxm::host
