#include "pxm/dsp32/processor/processor.hpp"

#include <algorithm>

#include "pxm/dsp32/processor/control_instructions.inl"
#include "pxm/dsp32/processor/data_instructions.inl"
#include "pxm/dsp32/processor/memory_access.inl"

namespace pxm::dsp32::processor {

namespace {

/// The name of what an address was meant to reach, and how far its bank goes.
struct Reached {
    std::string_view bank;
    std::int64_t end_bytes;
    std::int64_t limit_bytes;
};

Reached reached(ProcessorNode& node, const std::array<std::uint16_t, window_count>& shown,
                std::uint32_t address, std::uint32_t bytes) {
    const std::int64_t end = std::int64_t{address} + bytes;
    if (address < first_window_page * page_bytes)
        return {node.fast_memory().name(), end, node.fast_memory().used_bytes()};
    const std::uint32_t window = address / page_bytes - first_window_page;
    if (window >= window_count) return {"no bank", end, 0};
    const Bank& bank = bank_of_window(node, window);
    const std::int64_t from = std::int64_t{shown[window]} * page_bytes;
    return {bank.name(), from + end % page_bytes, bank.used_bytes()};
}

}  // namespace

Processor::Processor(ProcessorNode& node) : node_(node) {}

std::optional<Fault> Processor::load(std::span<const Word> program) {
    const auto bytes = static_cast<std::int64_t>(program.size()) * 4;
    if (auto full = node_.load_program(bytes, std::max<std::int64_t>(fast_memory_bytes - bytes, 0)))
        return full;
    const auto words = node_.fast_memory().words();
    std::ranges::fill(words, zero);
    std::ranges::copy(program, words.begin());
    program_.assign(words.size(), {});
    return std::nullopt;
}

void Processor::start(std::uint32_t address) noexcept {
    constexpr unsigned link = 14;
    registers_[link] = return_address;
    pc_ = address;
    next_ = address + 4;
    stop_.reset();
}

Word& Processor::fast_word(std::uint32_t address) noexcept {
    changed(address);
    return node_.fast_memory().words()[address / 4];
}

Stop Processor::run(std::uint64_t steps, std::span<const std::uint32_t> breakpoints) {
    pages_ = pages_of(node_, shown_);
    if (breakpoints.empty() || steps == 0) return run_freely(steps);
    Stop stop = run_freely(1);
    if (stop.reason != StopReason::steps_used) return stop;
    // What was not decoded yet is looked at, and only there breakpoints cost time.
    breakpoints_ = breakpoints;
    for (const std::uint32_t address : breakpoints_) changed(address);
    stop = run_freely(steps - 1);
    breakpoints_ = {};
    if (stop.reason == StopReason::breakpoint) stop_.reset();
    return stop;
}

/// What a fetch meets that is no instruction ready to be executed.
void Processor::look_at(std::uint32_t address) {
    if (address == return_address) {
        // What is on its way arrives.
        for (std::uint64_t i = 0; i < memory_latency; ++i) {
            Write& write = writes_[(now_ + i) % memory_latency];
            if (write.due != never) commit(write);
            write.due = never;
        }
        if (!stop_) stop_ = Stop{StopReason::ended, address, 0, {}};
        return;
    }
    if (std::ranges::find(breakpoints_, address) != breakpoints_.end()) {
        stop_ = Stop{StopReason::breakpoint, address, 0, {}};
        return;
    }
    if (address % 4 != 0) return fail(StopReason::misaligned, address, 4);
    if (address / 4 >= program_.size()) return fail(StopReason::fault, address, 4);
    program_[address / 4] = decoded(node_.fast_memory().words()[address / 4]);
}

Stop Processor::run_freely(std::uint64_t steps) {
    for (const std::uint64_t end = now_ + steps; now_ != end;) {
        commit_due();
        if (stop_) [[unlikely]]
            return *stop_;
        if (pc_ % 4 != 0 || pc_ / 4 >= program_.size() || program_[pc_ / 4].step == Step::unknown)
            [[unlikely]] {
            look_at(pc_);
            if (stop_) return *stop_;
        }
        const Decoded& in = program_[pc_ / 4];
        if (load_due_ <= now_ + 1) [[unlikely]] {
            if (load_due_ == now_ + 1) {
                if ((in.reads >> loaded_register_ & 1U) != 0)
                    note_stale(StaleKind::loaded_register);
            } else {
                registers_[loaded_register_] = loaded_value_;
                load_due_ = never;
            }
        }
        after_next_ = next_ + 4;
        execute(in);
        if (stop_) [[unlikely]]
            return *stop_;
        data_.remember_flags(now_);
        pc_ = next_;
        next_ = after_next_;
        ++now_;
    }
    return {StopReason::steps_used, pc_, 0, {}};
}

void Processor::execute(const Decoded& in) {
    if (in.step >= Step::branch) return execute_control(in);
    if (in.step >= Step::to_float) return execute_special(in);
    if (in.step >= Step::add_product) return execute_data(in);
    fail(in.step == Step::illegal ? StopReason::illegal : StopReason::not_modelled, pc_, 4);
}

void Processor::fail(StopReason reason, std::uint32_t address, std::uint32_t bytes) {
    if (stop_) return;
    stop_ = Stop{reason, pc_, address, {}};
    if (reason != StopReason::fault && reason != StopReason::misaligned) return;
    const Reached to = reached(node_, shown_, address, bytes);
    stop_->fault = Fault{node_.index(), to.bank, to.end_bytes, to.limit_bytes};
}

void Processor::note_stale(StaleKind kind) noexcept {
    if (stale_.count++ == 0) {
        stale_.first_address = pc_;
        stale_.first_kind = kind;
    }
}

}  // namespace pxm::dsp32::processor
