// The DSP32 of a node: executes the words in its fast memory. Arithmetic is pxm/dsp32's, bit for
// bit; the pipeline's latencies are those of the successors, with the old values that a read gets
// that comes too early; cycles are instructions and waits for the slow banks. What is assumed:
// docs/dsp32.md, "The processor".
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pxm/dsp32/processor/address_map.hpp"
#include "pxm/dsp32/processor/data_unit.hpp"
#include "pxm/dsp32/processor/decoded.hpp"
#include "pxm/dsp32/processor/stop.hpp"

namespace pxm::dsp32::processor {

/// Of the control unit.
struct Flags {
    bool negative = false;  // below zero
    bool zero = false;      // zero
    bool carry = false;     // a bit was carried out of the highest
    bool overflow = false;  // above the range of 16 bits
    bool operator==(const Flags&) const = default;
};

class Processor {  // executes programs on a node
  public:
    /// Precondition: the node outlives the processor.
    explicit Processor(ProcessorNode& node);

    /// Puts a program into fast memory from address 0 on; what is left of it is for data and stack.
    /// A Fault if the program is too large.
    [[nodiscard]] std::optional<Fault> load(std::span<const Word> program);

    /// Starts at an address, as a routine that was called with the link register r14.
    void start(std::uint32_t address) noexcept;
    /// Executes until something stops it, at most `steps` instructions; a breakpoint stops in front
    /// of its instruction, unless that is the first.
    [[nodiscard]] Stop run(std::uint64_t steps, std::span<const std::uint32_t> breakpoints = {});

    /// The address of the next instruction.
    [[nodiscard]] std::uint32_t program_counter() const noexcept { return pc_; }
    /// Of the register with this code.
    [[nodiscard]] std::uint16_t register_value(unsigned code) const noexcept {
        return registers_[code];
    }
    /// Changes the register with this code.
    void set_register(unsigned code, std::uint16_t value) noexcept { registers_[code] = value; }
    /// As the adder sees it, 0 to 3.
    [[nodiscard]] const Accumulator& accumulator(std::size_t number) const noexcept {
        return data_.value(number);
    }
    [[nodiscard]] const Flags& flags() const noexcept { return flags_; }  // of the control unit
    /// Of the data unit's last result.
    [[nodiscard]] DataFlags data_flags() const noexcept { return data_.flags(); }
    /// A word of fast memory, by its address in bytes. Precondition: it is there.
    [[nodiscard]] Word& fast_word(std::uint32_t address) noexcept;

    /// Executed since it was made.
    [[nodiscard]] std::uint64_t instructions() const noexcept { return now_ - first_instruction; }
    /// Instructions and waits.
    [[nodiscard]] std::uint64_t cycles() const noexcept { return instructions() + waits_; }
    [[nodiscard]] const StaleReads& stale_reads() const noexcept { return stale_; }  // of all runs

  private:
    // So that what was there at the start is older than every latency.
    static constexpr std::uint64_t first_instruction = 8;
    static constexpr std::uint64_t never = ~std::uint64_t{0};
    static constexpr std::uint64_t memory_latency = 4;  // of a result written [S7, S8]

    /// A result of the data unit on its way to memory.
    struct Write {
        std::uint32_t address = 0;
        Word value = 0;
        bool half = false;
        std::uint64_t due = never;
    };

    [[nodiscard]] Stop run_freely(std::uint64_t steps);
    void look_at(std::uint32_t address);
    void execute(const Decoded& in);
    void execute_data(const Decoded& in);
    void execute_special(const Decoded& in);
    void execute_control(const Decoded& in);

    [[nodiscard]] Addend operand_addend(const DecodedOperand& operand);
    [[nodiscard]] Word operand_word(const DecodedOperand& operand);
    [[nodiscard]] Word multiplier_word(const DecodedOperand& operand);
    [[nodiscard]] Word multiplier_accumulator(unsigned number);
    [[nodiscard]] Addend adder_input(unsigned m);
    [[nodiscard]] std::uint32_t address_and_step(const DecodedOperand& operand) noexcept;
    void finish(const Decoded& in, Addend first, Addend second);
    void write_result(const DecodedOperand& z, Word value, bool half);
    void commit(const Write& write);
    void commit_due();

    void branch_to(std::uint32_t address) noexcept { after_next_ = address; }
    [[nodiscard]] std::uint32_t branch_address(const Decoded& in) const noexcept;
    [[nodiscard]] bool holds(unsigned condition);
    [[nodiscard]] bool holds_for_data(unsigned condition, DataFlags flags) const noexcept;
    [[nodiscard]] std::uint16_t source(unsigned code) const noexcept;
    [[nodiscard]] std::uint16_t integer_sum(std::uint32_t a, std::uint32_t b) noexcept;
    [[nodiscard]] std::uint16_t integer_difference(std::uint32_t a, std::uint32_t b) noexcept;
    [[nodiscard]] std::uint16_t logical(std::uint32_t result, bool carry = false) noexcept;
    void calculate(isa::Alu function, unsigned d, std::uint16_t a, std::uint16_t b);
    void load_register(const Decoded& in);
    void store_register(const Decoded& in);

    [[nodiscard]] Word* find(std::uint32_t address, std::uint32_t bytes);
    [[nodiscard]] Word read_word(std::uint32_t address);
    [[nodiscard]] std::uint32_t read_part(std::uint32_t address, std::uint32_t bytes);
    void write_word(std::uint32_t address, Word value);
    void write_part(std::uint32_t address, std::uint32_t bytes, std::uint32_t value);
    void look_for_pending(std::uint32_t address, std::uint32_t bytes);
    void changed(std::uint32_t address) noexcept;
    void fail(StopReason reason, std::uint32_t address, std::uint32_t bytes);
    void note_stale(StaleKind kind) noexcept;

    ProcessorNode& node_;
    PageTable pages_{};
    std::array<std::uint16_t, window_count> shown_{};
    std::vector<Decoded> program_;
    std::span<const std::uint32_t> breakpoints_;  // while it runs

    std::uint32_t pc_ = return_address;
    std::uint32_t next_ = return_address;        // after the one at pc_
    std::uint32_t after_next_ = return_address;  // a branch has a slot behind it
    std::array<std::uint16_t, isa::register_count> registers_{};
    Flags flags_;
    DataUnit data_;

    std::uint64_t now_ = first_instruction;  // instructions
    std::uint64_t waits_ = 0;
    std::array<Write, memory_latency> writes_{};  // by instruction, modulo the latency
    std::uint64_t last_due_ = 0;
    std::uint64_t load_due_ = never;  // when a register gets what was loaded
    unsigned loaded_register_ = 0;
    std::uint16_t loaded_value_ = 0;
    StaleReads stale_;
    std::optional<Stop> stop_;
};

}  // namespace pxm::dsp32::processor
