#include "host/engine/assembled_node.hpp"

#include <algorithm>
#include <cassert>

#include "host/engine/overflow.hpp"
#include "host/engine/word_hash.hpp"
#include "pxm/frame_buffer.hpp"

namespace pxm::host {

namespace {

using dsp32::processor::StopReason;

constexpr std::int64_t heap_bytes = 17 * 4096;  // dsp_kernels/asm/cell_heap.s
constexpr long page_words = 1024;
constexpr long front_window = 0xD000;  // pxm/dsp32/processor/address_map.hpp
constexpr std::uint32_t key_word = 7;  // of a cell: behind its ray

}  // namespace

AssembledNode::AssembledNode(dsp32::processor::ProcessorNode& node, const CompiledScene& scene,
                             const Model& model, const UnitPixels& unit)
    : scene_(scene), program_(assembled_program(scene)), processor_(node) {
    stops_ = {program_.address_of("program_sample_done"), program_.address_of("program_next"),
              program_.address_of("cell_heap_full"), program_.address_of("search_word_full")};
    const bool heap_fits = node.zbuffer().reserve(heap_bytes);
    assert(heap_fits);
    static_cast<void>(heap_fits);
    const auto full = processor_.load(program_.words());
    assert(!full);
    static_cast<void>(full);
    const int width = static_cast<int>(scene.size.columns);
    const long first =
        pixel_in_node(model, width, static_cast<int>(unit.x0), static_cast<int>(unit.y0));
    const long skip = owned_along(width, node.id().column, model.columns) - unit.columns();
    set_half("share_x", unit.x0);
    set_half("share_y", unit.y0);
    set_half("share_end_x", unit.x1);
    set_half("share_end_y", unit.y1);
    set_half("share_step_x", unit.step_x);
    set_half("share_step_y", unit.step_y);
    set_half("share_page", first / page_words);
    set_half("share_at", front_window + first % page_words * 4);
    set_half("share_skip_pages", skip / page_words);
    set_half("share_skip_bytes", skip % page_words * 4);
    processor_.start(program_.address_of("program"));
}

NodeEvent AssembledNode::go_on(std::uint64_t instructions) {
    stop_ = processor_.run(instructions, stops_);
    switch (stop_.reason) {
        case StopReason::steps_used:
            return NodeEvent::working;
        case StopReason::ended:
            return NodeEvent::done;
        case StopReason::breakpoint:
            break;
        default:
            return NodeEvent::broken;
    }
    const auto at = std::ranges::find(stops_, stop_.instruction_address) - stops_.begin();
    if (at == 0) look_at_sample();
    constexpr std::array events{NodeEvent::working, NodeEvent::pixel, NodeEvent::heap_full,
                                NodeEvent::word_full};
    return events[static_cast<std::size_t>(at)];
}

void AssembledNode::look_at_sample() {
    constexpr unsigned met_register = 25;  // r21
    const auto tested = scene_.cell_cap - word_at("search_left");
    const bool met = processor_.register_value(met_register) != 0;
    seen_.volumes += tested;
    if ((word_at("search_was_capped") & 0xFFFFU) != 0) ++seen_.capped;
    if (!std::exchange(seen_.first, false) || !met) return;
    seen_.hit = true;
    const double t = dsp32::double_of(word_at("cell_heap_top", key_word));
    seen_.z = static_cast<float>(t * scene_.unit);
    for (std::uint32_t i = 0; i < 3; ++i) seen_.normal[i] = number_at("walk_normal", i);
    const std::uint32_t level = word_at("cell_level") & 0xFFFFU;
    seen_.level =
        static_cast<std::int32_t>(scene_.objects.front().prefix.size() + std::size_t{level});
    seen_.word = word_hash(level);
}

std::uint32_t AssembledNode::word_hash(std::uint32_t level) {
    std::uint32_t hash = hash_symbols(scene_.objects.front().prefix);
    for (std::uint32_t i = 0; i < level; ++i) {
        const std::uint32_t byte = i ^ 1U;  // the first map of a half is in its higher byte
        hash = hash_symbol(hash, word_at("cell_word", byte / 4) >> byte % 4 * 8 & 0xFFU);
    }
    return finished_hash(hash);
}

void AssembledNode::take(PixelRecord& record, RayStatistics& counts) {
    for (std::uint32_t i = 0; i < 3; ++i) record.color[i] = number_at("program_color", i);
    record.alpha = std::min(number_at("program_alpha"), 1.0F);
    record.volumes = seen_.volumes;
    if (seen_.hit) {
        record.z = seen_.z;
        std::ranges::copy(seen_.normal, record.normal);
        record.object = scene_.objects.front().origin;
        record.level = seen_.level;
        record.word = seen_.word;
    }
    if (seen_.capped > 0) record.alarms |= alarm_capped;
    if (take_overflow<dsp32::Float>()) record.alarms |= alarm_overflow;
    record.cycles = cycles() - std::exchange(cycles_before_, cycles());
    ++counts.pixels;
    counts.eye_rays += scene_.samples.size();
    counts.hits += seen_.hit ? 1 : 0;
    counts.volumes_tested += seen_.volumes;
    counts.capped_rays += seen_.capped;
    seen_ = {};
}

void AssembledNode::set_half(std::string_view label, long value) {
    const std::uint32_t address = program_.address_of(label);
    const unsigned shift = address % 4 * 8;
    dsp32::Word& word = processor_.fast_word(address);
    word = (word & ~(0xFFFFU << shift)) | (static_cast<std::uint32_t>(value) & 0xFFFFU) << shift;
}

dsp32::Word AssembledNode::word_at(std::string_view label, std::uint32_t index) {
    return processor_.fast_word(program_.address_of(label) + 4 * index);
}

float AssembledNode::number_at(std::string_view label, std::uint32_t index) {
    return dsp32::float_of(word_at(label, index));
}

}  // namespace pxm::host
