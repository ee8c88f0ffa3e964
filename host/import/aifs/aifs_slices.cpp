#include "host/import/aifs/aifs_slices.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace pxm::host {
namespace {

constexpr std::string_view blanks = " \t\r\f\v\n";

bool is_word(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Without its comment and the blanks around it.
std::string_view bare(std::string_view line) {
    line = line.substr(0, line.find('#'));
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return line.substr(begin, line.find_last_not_of(blanks) + 1 - begin);
}

/// Takes `$n = text` of a line of its own.
void take_heading(std::string_view line, AifsSlice& slice) {
    if (line.size() < 3 || line[0] != '$' || is_word(line[2])) return;
    const std::string_view rest = bare(line.substr(2));
    if (!rest.starts_with('=')) return;
    const std::string_view value = bare(rest.substr(1));
    if (line[1] == 'n') slice.name = value;
    if (line[1] == 'a') slice.hidden = value == "h";
}

void take_block(std::string_view line, AifsSlice& slice) {
    const std::string_view head = bare(line.substr(1));
    const std::size_t colon = std::min(head.find(':'), head.size());
    slice.id = head.substr(0, colon);
    if (colon < head.size()) slice.parent = head.substr(colon + 1);
}

/// Calls `take` with every word of the text.
template <class Take>
void for_words(std::string_view text, const Take& take) {
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && is_word(text[end])) ++end;
        if (end > at) take(text.substr(at, end - at));
        at = end + 1;
    }
}

/// What stands outside of blocks, by the rules of parse_aifs.
void take_other(std::string_view text, int line, Diagnostics& diagnostics) {
    std::size_t left = 0;
    (void)parse_aifs_part(text, {0, line, 1}, left, diagnostics);
}

/// The numbers of the blocks that `chosen` names, and that those name.
std::set<std::size_t> family_of(const std::vector<AifsSlice>& slices, std::size_t chosen) {
    std::multimap<std::string_view, std::size_t, std::less<>> by_id;
    for (std::size_t i = 0; i < slices.size(); ++i)
        if (!slices[i].id.empty()) by_id.emplace(slices[i].id, i);
    std::set<std::size_t> family{chosen};
    std::vector<std::size_t> waiting{chosen};
    const auto want = [&](std::string_view id) {
        const auto [begin, end] = by_id.equal_range(id);
        for (auto one = begin; one != end; ++one)
            if (family.insert(one->second).second) waiting.push_back(one->second);
    };
    while (!waiting.empty()) {
        const AifsSlice& slice = slices[waiting.back()];
        waiting.pop_back();
        want(slice.parent);
        for_words(slice.text, want);
    }
    return family;
}

}  // namespace

std::vector<AifsSlice> slice_aifs(std::string_view text, Diagnostics& diagnostics) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    std::vector<AifsSlice> slices;
    int number = 1;
    for (std::size_t at = 0; at < text.size() && !diagnostics.full(); ++number) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        const std::string_view line = text.substr(at, end - at);
        const std::size_t first = std::min(line.find_first_not_of(blanks), line.size());
        const std::string_view rest = line.substr(first);
        if (rest.starts_with("@@")) {
            take_other(line, number, diagnostics);
        } else if (rest.starts_with('@')) {
            AifsSlice& slice = slices.emplace_back();
            slice.position = {0, number, static_cast<int>(first) + 1};
            slice.text = text.substr(at + first);
            take_block(rest, slice);
        } else if (slices.empty()) {
            take_other(line, number, diagnostics);
            if (diagnostics.has_errors()) return slices;
        } else {
            take_heading(rest, slices.back());
        }
        at = end;
    }
    for (std::size_t i = 0; i + 1 < slices.size(); ++i)
        slices[i].text.remove_suffix(slices[i + 1].text.size());
    return slices;
}

std::vector<AifsBlock> parse_aifs_family(const std::vector<AifsSlice>& slices, std::size_t& chosen,
                                         Diagnostics& diagnostics) {
    std::vector<AifsBlock> blocks;
    std::size_t left = most_aifs_parts;
    std::size_t place = 0;
    for (const std::size_t i : family_of(slices, chosen)) {
        if (i == chosen) place = blocks.size();
        for (AifsBlock& block :
             parse_aifs_part(slices[i].text, slices[i].position, left, diagnostics)) {
            // `$a` is text, and the last one counts.
            const bool shown = i == chosen && blocks.size() == place;
            if (!shown) block.definitions.push_back({"$a", {}, "h", block.position});
            blocks.push_back(std::move(block));
        }
    }
    chosen = place;
    return blocks;
}

}  // namespace pxm::host
