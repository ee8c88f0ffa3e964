#include "host/import/eisenscript/eisen_tokens.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <utility>

#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t most_tokens = 2'000'000;
constexpr int deepest_define = 8;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f'; }

class Tokenizer {
  public:
    Tokenizer(std::string_view text, Diagnostics& diagnostics)
        : text_(text), diagnostics_(diagnostics) {
        if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    }

    std::vector<EisenToken> read() {
        while (place_ < text_.size() && !diagnostics_.full()) {
            const char c = text_[place_];
            if (is_blank(c)) {
                take();
            } else if (c == '#' && position_.column == 1) {
                directive();
            } else if (text_.substr(place_, 2) == "//") {
                while (place_ < text_.size() && text_[place_] != '\n') take();
            } else if (text_.substr(place_, 2) == "/*") {
                block_comment();
            } else {
                word();
            }
        }
        return std::move(tokens_);
    }

  private:
    char take() {
        const char c = text_[place_++];
        ++position_.column;
        if (c == '\n') {
            ++position_.line;
            position_.column = 1;
        }
        return c;
    }

    void block_comment() {
        const std::size_t end = text_.find("*/", place_ + 2);
        const std::size_t stop = end == std::string_view::npos ? text_.size() : end + 2;
        while (place_ < stop) take();
    }

    /// #define NAME words (what stands in parentheses is for the program's window)
    void directive() {
        const Position place = position_;
        std::string line;
        while (place_ < text_.size() && text_[place_] != '\n') line += take();
        line = line.substr(0, line.find("//"));
        line = line.substr(0, line.find('('));
        std::vector<std::string> words;
        for (std::size_t i = 0; i < line.size();) {
            while (i < line.size() && is_blank(line[i])) ++i;
            const std::size_t begin = i;
            while (i < line.size() && !is_blank(line[i])) ++i;
            if (i > begin) words.push_back(line.substr(begin, i - begin));
        }
        if (words.empty() || words[0] == "#javascript")
            return diagnostics_.error(place, "programs in JavaScript are not run");
        if (words[0] != "#define" || words.size() < 2) return;
        std::vector<std::string>& value = defines_[words[1]];
        value.assign(words.begin() + 2, words.end());
    }

    void word() {
        const Position place = position_;
        std::string text(1, take());
        if (text == "[") {
            while (place_ < text_.size() && text_[place_] != ']') text += take();
            if (place_ == text_.size()) diagnostics_.error(place, "'[' without its ']'");
            if (place_ < text_.size()) text += take();
        } else if (text != "{" && text != "}") {
            while (place_ < text_.size() && !is_blank(text_[place_]) && text_[place_] != '{' &&
                   text_[place_] != '}' && text_.substr(place_, 2) != "/*" &&
                   text_.substr(place_, 2) != "//")
                text += take();
        }
        add(text, place, 0);
    }

    /// A defined number may have a sign in front: the program puts in text, not words.
    [[nodiscard]] std::string with_sign(const std::string& text) const {
        if (text.size() < 2 || text[0] != '-') return text;
        const auto found = defines_.find(std::string_view(text).substr(1));
        if (found == defines_.end() || found->second.size() != 1) return text;
        const std::string& value = found->second[0];
        return value[0] == '-' ? value.substr(1) : "-" + value;
    }

    void add(const std::string& word, const Position& place, int depth) {
        const std::string text = with_sign(word);
        const auto found = defines_.find(text);
        if (found == defines_.end()) {
            if (tokens_.size() < most_tokens) return tokens_.push_back({text, place});
            place_ = text_.size();
            if (!diagnostics_.has_errors())
                diagnostics_.error(place, fmt::format("more than {} words", most_tokens));
            return;
        }
        if (depth == deepest_define)
            return diagnostics_.error(place, fmt::format("'{}' is defined by itself, or more than "
                                                         "{} deep",
                                                         printable(text), deepest_define));
        for (const std::string& part : found->second)
            if (!diagnostics_.has_errors()) add(part, place, depth + 1);
    }

    std::string_view text_;
    Diagnostics& diagnostics_;
    std::size_t place_ = 0;
    Position position_;
    std::vector<EisenToken> tokens_;
    std::map<std::string, std::vector<std::string>, std::less<>> defines_;
};

}  // namespace

std::vector<EisenToken> eisen_tokens(std::string_view text, Diagnostics& diagnostics) {
    return Tokenizer(text, diagnostics).read();
}

}  // namespace pxm::host
