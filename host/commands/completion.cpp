#include "host/commands/completion.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "host/error.hpp"
#include "host/import/import.hpp"
#include "host/scene/scene_path.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

using Words = std::vector<std::string>;

/// What is known of the word to complete: how it begins, and what stands in front of that.
struct Begun {
    std::string in_front;  // kept as it is: `--shading=`, `Z,word,`
    std::string start;
};

class Candidates {
  public:
    explicit Candidates(Begun begun) : begun_(std::move(begun)) {}
    void add(const std::string& word, const std::string& what) {
        if (word.starts_with(begun_.start))
            text_ += begun_.in_front + printable(word, 400) + '\t' + printable(what, 400) + '\n';
    }
    void ask_shell(const std::string& kind) { text_ += ':' + kind + '\n'; }
    /// What comes after the last comma is completed.
    void as_list() {
        const std::size_t comma = begun_.start.rfind(',');
        if (comma == std::string::npos) return;
        begun_.in_front += begun_.start.substr(0, comma + 1);
        begun_.start.erase(0, comma + 1);
    }
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    Begun begun_;
    std::string text_;
};

void add_options(const CommandFacts& command, Candidates& candidates) {
    for (const OptionFacts& option : command.options)
        if (!option.is_argument) candidates.add(option.names.back(), option.what);
}

/// The entries of the file that is among the words.
void add_entries(const Words& words, Candidates& candidates) {
    for (const std::string& word : words) {
        try {
            for (const std::string& entry : entries_of(word)) candidates.add(entry, word);
        } catch (const Error&) {
            continue;  // what cannot be read has no entries
        }
    }
}

void add_words(std::string value, Candidates& candidates) {
    const std::string more = ",...";
    if (value.ends_with(more)) {
        value.resize(value.size() - more.size());
        candidates.as_list();
    }
    value += '|';
    for (std::size_t from = 0; from < value.size();) {
        const std::size_t bar = value.find('|', from);
        const std::string word = value.substr(from, bar - from);
        // `TMIN,TMAX` stands for numbers.
        if (word.find(',') == std::string::npos) candidates.add(word, "");
        from = bar + 1;
    }
}

void add_values(const std::string& value, const Words& words, Candidates& candidates) {
    if (value == "SCENE") {
        for (const std::string& name : scene_names()) candidates.add(name, "scene");
        candidates.ask_shell("files .pxm");
    } else if (value.starts_with("FILE")) {
        const std::string extension = value.substr(std::string("FILE").size());
        candidates.ask_shell("files" + (extension.empty() ? "" : " " + extension));
    } else if (value == "DIR") {
        candidates.ask_shell("folders");
    } else if (value == "ENTRY") {
        add_entries(words, candidates);
    } else if (value.find('|') != std::string::npos) {
        add_words(value, candidates);
    }
}

/// The option whose value the last word is, and how the value begins. bash makes words of
/// `--option`, `=` and the value.
struct Valued {
    const OptionFacts* option;
    Begun begun;
};
std::optional<Valued> option_of_last(const CommandFacts& command, const Words& words) {
    const std::string& last = words.back();
    const auto before = [&](std::size_t count) {
        return words.size() > count ? words[words.size() - 1 - count] : std::string();
    };
    const auto valued = [&](const std::string& name, const Begun& begun) -> std::optional<Valued> {
        const OptionFacts* option = find_option(command, name);
        if (option == nullptr || option->value.empty()) return std::nullopt;
        return Valued{option, begun};
    };
    const std::size_t equals = last.find('=');
    if (last == "=") return valued(before(1), {"", ""});
    if (before(1) == "=") return valued(before(2), {"", last});
    if (last.starts_with("--") && equals != std::string::npos)
        return valued(last.substr(0, equals),
                      {last.substr(0, equals + 1), last.substr(equals + 1)});
    return valued(before(1), {"", last});
}

/// The argument that the last word is: options and their values do not count.
const OptionFacts* argument_of_last(const CommandFacts& command, const Words& words) {
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < words.size(); ++i) {
        const OptionFacts* option = find_option(command, words[i]);
        if (option != nullptr && !option->value.empty()) ++i;
        if (option == nullptr && !words[i].starts_with('-')) ++count;
    }
    const OptionFacts* last = nullptr;
    for (const OptionFacts& option : command.options) {
        if (!option.is_argument) continue;
        last = &option;
        if (count-- == 0) return last;
    }
    return last != nullptr && last->several ? last : nullptr;
}

std::string first_word(const std::vector<CommandFacts>& commands, const std::string& start) {
    Candidates candidates({"", start});
    for (const CommandFacts& command : commands)
        if (!command.name.empty()) candidates.add(command.name, command.what);
    if (start.starts_with('-')) add_options(*find_command(commands, ""), candidates);
    return candidates.text();
}

}  // namespace

std::string completions(const std::vector<CommandFacts>& commands, const Words& words) {
    if (words.empty()) return first_word(commands, "");
    if (words.size() == 1) return first_word(commands, words[0]);
    const CommandFacts* command = find_command(commands, words[0]);
    if (command == nullptr || words[0].empty()) return "";
    if (const auto valued = option_of_last(*command, words)) {
        Candidates candidates(valued->begun);
        add_values(valued->option->value, words, candidates);
        return candidates.text();
    }
    Candidates candidates({"", words.back()});
    if (words.back().starts_with('-')) {
        add_options(*command, candidates);
    } else if (const OptionFacts* argument = argument_of_last(*command, words)) {
        add_values(argument->value, words, candidates);
    }
    return candidates.text();
}

}  // namespace pxm::host
