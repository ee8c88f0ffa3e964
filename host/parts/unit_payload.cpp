#include "host/parts/unit_payload.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>
#include <utility>

namespace pxm::host {

namespace {

using Word = std::uint32_t;
using Words = std::vector<Word>;

static_assert(std::endian::native == std::endian::little, "a part file is little endian");

// --- words of a pixel ----------------------------------------------------------------------------

/// Calls each(field) with the fields of a record that are kept.
template <class Record, class Each>
void for_fields(Record& pixel, const std::vector<Aov>& channels, const Each& each) {
    for (auto& part : pixel.color) each(part);
    for (const Aov aov : channels) {
        switch (aov) {
            case Aov::z:
                each(pixel.z);
                break;
            case Aov::node:
                each(pixel.node);
                break;
            case Aov::cycles:
            case Aov::neighbours:
                each(pixel.cycles);
                break;
            case Aov::volumes:
                each(pixel.volumes);
                break;
            case Aov::level:
                each(pixel.level);
                break;
            case Aov::heap:
                each(pixel.heap);
                break;
            case Aov::alpha:
                each(pixel.alpha);
                break;
            case Aov::object:
                each(pixel.object);
                break;
            case Aov::word:
                each(pixel.word);
                break;
            case Aov::normal:
                for (auto& part : pixel.normal) each(part);
                break;
        }
    }
}

template <class Field>
constexpr std::size_t words_in = (sizeof(Field) + sizeof(Word) - 1) / sizeof(Word);

std::size_t words_a_pixel(const std::vector<Aov>& channels) {
    std::size_t words = 0;
    PixelRecord pixel;
    for_fields(pixel, channels, [&](auto& field) { words += words_in<decltype(+field)>; });
    return words;
}

/// The words of all pixels, the first of each, then the second of each, and so on.
Words planes_of(std::span<const PixelRecord> pixels, const std::vector<Aov>& channels) {
    Words planes(pixels.size() * words_a_pixel(channels));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        std::size_t at = i;
        for_fields(pixels[i], channels, [&](const auto& field) {
            std::array<Word, words_in<decltype(+field)>> words{};
            std::memcpy(words.data(), &field, sizeof field);
            for (const Word word : words) {
                planes[at] = word;
                at += pixels.size();
            }
        });
    }
    return planes;
}

void put_planes(const Words& planes, const std::vector<Aov>& channels,
                std::vector<PixelRecord>& pixels) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        std::size_t at = i;
        for_fields(pixels[i], channels, [&](auto& field) {
            std::array<Word, words_in<decltype(+field)>> words{};
            for (Word& word : words) {
                word = planes[at];
                at += pixels.size();
            }
            std::memcpy(&field, words.data(), sizeof field);
        });
    }
}

// --- runs of words -------------------------------------------------------------------------------

// A run begins with its length; one of equal words has this bit set and holds the word once.
constexpr Word equal_bit = Word{1} << 31U;
constexpr std::size_t least_equal = 4;  // words that are worth a run of their own

template <class Value>
void append(std::string& bytes, const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append_words(std::string& bytes, const Word* words, std::size_t count) {
    if (count == 0) return;
    append(bytes, static_cast<Word>(count));
    bytes.append(reinterpret_cast<const char*>(words), count * sizeof(Word));
}

void append_runs(std::string& bytes, const Words& words) {
    std::size_t pending = 0;  // where words begin that are in no run yet
    for (std::size_t at = 0; at < words.size();) {
        std::size_t end = at + 1;
        while (end < words.size() && words[end] == words[at]) ++end;
        if (end - at >= least_equal) {
            append_words(bytes, &words[pending], at - pending);
            append(bytes, static_cast<Word>(end - at) | equal_bit);
            append(bytes, words[at]);
            pending = end;
        }
        at = end;
    }
    append_words(bytes, words.data() + pending, words.size() - pending);
}

/// Takes a value off the front; false if there is none.
template <class Value>
bool take(std::string_view& bytes, Value& value) {
    if (bytes.size() < sizeof value) return false;
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
    return true;
}

/// All words of the runs, which end with the bytes.
bool take_runs(std::string_view bytes, Words& words) {
    std::size_t at = 0;
    Word head = 0;
    while (take(bytes, head)) {
        const std::size_t count = head & ~equal_bit;
        if (count == 0 || count > words.size() - at) return false;
        if ((head & equal_bit) != 0) {
            Word value = 0;
            if (!take(bytes, value)) return false;
            std::fill_n(words.begin() + static_cast<std::ptrdiff_t>(at), count, value);
        } else {
            if (bytes.size() < count * sizeof(Word)) return false;
            std::memcpy(words.data() + at, bytes.data(), count * sizeof(Word));
            bytes.remove_prefix(count * sizeof(Word));
        }
        at += count;
    }
    return bytes.empty() && at == words.size();
}

/// What of a node's statistics is stored.
struct NodeCounts {
    std::uint64_t is_there = 0;
    std::uint64_t instructions = 0;
    std::uint64_t cycles = 0;
    std::array<std::uint64_t, operation_count> operations{};
};

}  // namespace

std::string payload_of(const FinishedUnit& unit, const AlarmSums& alarms,
                       const std::vector<Aov>& channels) {
    NodeCounts node;
    if (unit.node != nullptr)
        node = {1, unit.node->instructions, unit.node->cycles, unit.node->tally.counts};
    std::string bytes;
    append(bytes, unit.rays);
    append(bytes, alarms);
    append(bytes, node.is_there);
    if (unit.node != nullptr) append(bytes, node);
    append_runs(bytes, planes_of(unit.pixels, channels));
    return bytes;
}

std::optional<StoredUnit> unit_of_payload(std::string_view bytes, std::size_t pixels,
                                          const std::vector<Aov>& channels,
                                          std::vector<PixelRecord> memory) {
    StoredUnit unit;
    std::uint64_t has_node = 0;
    if (!take(bytes, unit.rays) || !take(bytes, unit.alarms) || !take(bytes, has_node))
        return std::nullopt;
    if (has_node != 0) {
        NodeCounts node;
        if (!take(bytes, node)) return std::nullopt;
        unit.node.emplace();
        unit.node->rays = unit.rays;
        unit.node->instructions = node.instructions;
        unit.node->cycles = node.cycles;
        unit.node->tally.counts = node.operations;
    }
    Words planes(pixels * words_a_pixel(channels));
    if (!take_runs(bytes, planes)) return std::nullopt;
    unit.pixels = std::move(memory);
    unit.pixels.resize(pixels);
    put_planes(planes, channels, unit.pixels);
    return unit;
}

}  // namespace pxm::host
