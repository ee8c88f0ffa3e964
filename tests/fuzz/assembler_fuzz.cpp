// Any bytes as a program for a DSP32, as source and as an object: mistakes have places; what is
// assembled is written and read back the same, can be printed, and runs on a node until it stops.
#include "pxm/dsp32/assembler/assembler.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

#include "pxm/dsp32/processor/processor.hpp"

using namespace pxm::dsp32;

namespace {

void run(const assembler::Object& object) {
    constexpr std::uint64_t steps = 2000;
    if (object.dialect != isa::Dialect::dsp32) return;
    processor::ProcessorNode node({}, 0);
    processor::Processor processor(node);
    std::vector<Word> words = object.text;
    words.insert(words.end(), object.data.begin(), object.data.end());
    if (processor.load(words)) return;  // it is too large
    processor.start(0);
    (void)processor.run(steps);
}

void take(const assembler::Object& object) {
    const auto copy = assembler::object_of(assembler::text_of(object));
    if (!copy || !(*copy == object)) std::abort();
    (void)assembler::disassembly(object);
    run(object);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    if (const auto object = assembler::object_of(text)) take(*object);
    for (const isa::Dialect dialect : {isa::Dialect::dsp32, isa::Dialect::dsp32c}) {
        const assembler::Assembly assembly = assembler::assemble(text, dialect);
        for (const assembler::Mistake& mistake : assembly.mistakes)
            if (mistake.place.line < 1 || mistake.place.column < 1) std::abort();
        if (!assembly.mistakes.empty() || assembly.too_large()) continue;
        (void)assembler::listing(assembly, text);
        take(assembly.object);
    }
    return 0;
}
