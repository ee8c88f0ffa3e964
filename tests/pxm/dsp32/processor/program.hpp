// A program in assembler on a node of its own, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "pxm/dsp32/assembler/assembler.hpp"
#include "pxm/dsp32/processor/processor.hpp"

namespace pxm::dsp32::processor {

class Program {
  public:
    explicit Program(const std::string& source) : node({}, 7), processor(node) {
        assembler::Assembly assembly = assembler::assemble(source, isa::Dialect::dsp32);
        for (const auto& mistake : assembly.mistakes)
            ADD_FAILURE() << mistake.place.line << ":" << mistake.place.column << ": "
                          << mistake.message;
        object_ = std::move(assembly.object);
        std::vector<Word> words = object_.text;
        words.insert(words.end(), object_.data.begin(), object_.data.end());
        EXPECT_FALSE(processor.load(words));
        processor.start(0);
    }

    /// Runs to the end from where the processor stands.
    Stop run(std::uint64_t steps = 10'000) { return processor.run(steps); }
    /// Calls a routine; it must end.
    void call(const std::string& label, std::uint64_t steps = 10'000) {
        processor.start(at(label));
        const Stop stop = run(steps);
        EXPECT_EQ(stop.reason, StopReason::ended)
            << label << " " << text_of(stop.reason) << " at " << stop.instruction_address;
    }
    [[nodiscard]] std::uint32_t at(const std::string& label) const {
        const auto address = object_.address_of(label);
        EXPECT_TRUE(address) << label;
        return address.value_or(0);
    }
    /// A word of memory behind a label.
    Word& word(const std::string& label, std::uint32_t index = 0) {
        return processor.fast_word(at(label) + 4 * index);
    }
    [[nodiscard]] const assembler::Object& object() const { return object_; }
    [[nodiscard]] std::uint16_t r(unsigned code) const { return processor.register_value(code); }
    [[nodiscard]] Word a(std::size_t number) const { return store(processor.accumulator(number)); }

  private:
    assembler::Object object_;

  public:
    ProcessorNode node;
    Processor processor;
};

}  // namespace pxm::dsp32::processor
