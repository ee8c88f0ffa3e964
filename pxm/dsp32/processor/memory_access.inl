// Accesses of the processor to the memories of its node. Part of processor.cpp.
#pragma once

#include "pxm/dsp32/processor/processor.hpp"

namespace pxm::dsp32::processor {

inline Word* Processor::find(std::uint32_t address, std::uint32_t bytes) {
    if (address % bytes != 0) [[unlikely]] {
        fail(StopReason::misaligned, address, bytes);
        return nullptr;
    }
    const Page& page = pages_[address / page_bytes];
    const std::uint32_t index = address % page_bytes / 4;
    if (index >= page.count) [[unlikely]] {
        fail(StopReason::fault, address, bytes);
        return nullptr;
    }
    waits_ += page.wait_cycles;
    return page.words + index;
}

/// A read while results are on their way gets what is there; whether it waited is noted.
inline void Processor::look_for_pending(std::uint32_t address, std::uint32_t bytes) {
    if (last_due_ <= now_) [[likely]]
        return;
    for (const Write& write : writes_) {
        const std::uint32_t size = write.half ? 2 : 4;
        const bool pending = write.due != never && write.due > now_;
        if (pending && write.address < address + bytes && address < write.address + size)
            note_stale(StaleKind::memory);
    }
}

inline Word Processor::read_word(std::uint32_t address) {
    const Word* word = find(address, 4);
    if (word == nullptr) return zero;
    look_for_pending(address, 4);
    return *word;
}

inline std::uint32_t Processor::read_part(std::uint32_t address, std::uint32_t bytes) {
    const std::uint32_t window = (address - window_registers) / 2;
    if (bytes == 2 && address >= window_registers && window < window_count && address % 2 == 0)
        return shown_[window];
    const Word* word = find(address, bytes);
    if (word == nullptr) return 0;
    look_for_pending(address, bytes);
    // The lower half of a word lies at the lower address [S9].
    return (*word >> (address % 4 * 8)) & (bytes == 2 ? 0xFFFFU : 0xFFU);
}

/// What was decoded of that word is void.
inline void Processor::changed(std::uint32_t address) noexcept {
    if (address / 4 < program_.size()) program_[address / 4].step = Step::unknown;
}

inline void Processor::write_word(std::uint32_t address, Word value) {
    Word* word = find(address, 4);
    if (word == nullptr) return;
    *word = value;
    changed(address);
}

inline void Processor::write_part(std::uint32_t address, std::uint32_t bytes, std::uint32_t value) {
    const std::uint32_t window = (address - window_registers) / 2;
    if (bytes == 2 && address >= window_registers && window < window_count && address % 2 == 0) {
        shown_[window] = static_cast<std::uint16_t>(value);
        pages_ = pages_of(node_, shown_);
        return;
    }
    Word* word = find(address, bytes);
    if (word == nullptr) return;
    const unsigned shift = address % 4 * 8;
    const Word mask = (bytes == 2 ? 0xFFFFU : 0xFFU) << shift;
    *word = (*word & ~mask) | ((value << shift) & mask);
    changed(address);
}

inline void Processor::commit(const Write& write) {
    if (write.half) {
        write_part(write.address, 2, write.value);
    } else {
        write_word(write.address, write.value);
    }
}

/// The result that was written four instructions ago arrives.
inline void Processor::commit_due() {
    Write& write = writes_[now_ % memory_latency];
    if (write.due != now_) [[likely]]
        return;
    write.due = never;
    commit(write);
}

}  // namespace pxm::dsp32::processor
