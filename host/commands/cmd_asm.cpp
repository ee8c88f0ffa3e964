// `pxm asm FILE...`: a program in DSP32 assembler as words, back as text, or run on a node
// (docs/dsp32.md).
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/error.hpp"
#include "host/files/regular_file.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/terminal.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/text/printable.hpp"
#include "pxm/dsp32/assembler/assembler.hpp"
#include "pxm/dsp32/isa/disassemble.hpp"
#include "pxm/dsp32/processor/processor.hpp"

namespace pxm::host {

namespace {

using dsp32::Word;
using dsp32::assembler::Assembly;
using dsp32::assembler::Object;
using dsp32::processor::Processor;
using dsp32::processor::ProcessorNode;
using dsp32::processor::Stop;
using dsp32::processor::StopReason;

struct AsmArguments {
    std::vector<std::string> files;
    std::string out;
    bool list = false;
    bool disassemble = false;
    bool dsp32c = false;
    std::string run;
    bool trace = false;
    std::uint64_t steps = 10'000'000;
    std::vector<std::string> breakpoints;
};

constexpr std::string_view object_start = "pxm-object ";

/// Several files, read as one behind the other.
struct Source {
    std::string text;
    std::vector<SourceFile> files;
    std::vector<int> first_lines;  // of each file, in the text

    [[nodiscard]] Position position(const dsp32::assembler::Place& place) const {
        const auto after = std::ranges::upper_bound(first_lines, place.line);
        const auto file = static_cast<int>(after - first_lines.begin()) - 1;
        return {file, place.line - first_lines[static_cast<std::size_t>(file)] + 1, place.column};
    }
};

Source read_source(const std::vector<std::string>& paths) {
    Source source;
    int line = 1;
    for (const std::string& path : paths) {
        source.files.push_back({path, read_file(path)});
        source.first_lines.push_back(line);
        std::string text = source.files.back().text;
        if (!text.ends_with('\n')) text += '\n';
        line += static_cast<int>(std::ranges::count(text, '\n'));
        source.text += text;
    }
    return source;
}

/// All mistakes of a source, as those of a scene are shown.
void refuse_mistakes(const Assembly& assembly, const Source& source) {
    Diagnostics diagnostics;
    for (const dsp32::assembler::Mistake& mistake : assembly.mistakes)
        diagnostics.error(source.position(mistake.place), mistake.message);
    diagnostics.throw_if_errors(source.files);
}

void refuse_size(std::size_t words) {
    constexpr std::size_t limit = fast_memory_bytes / sizeof(Word);
    if (words <= limit) return;
    throw Error(
        ErrorKind::machine_limit,
        fmt::format("the program takes {} words of fast memory, {} are there", words, limit));
}

Object read_object(const std::string& path, const std::string& text) {
    auto object = dsp32::assembler::object_of(text);
    if (!object)
        throw Error(ErrorKind::scene, printable_path(path) + ": no object of this version");
    refuse_size(object->words());
    return *std::move(object);
}

Object assemble_source(const AsmArguments& arguments, const Source& source) {
    const auto dialect =
        arguments.dsp32c ? dsp32::isa::Dialect::dsp32c : dsp32::isa::Dialect::dsp32;
    const Assembly assembly = dsp32::assembler::assemble(source.text, dialect);
    refuse_mistakes(assembly, source);
    refuse_size(static_cast<std::size_t>(assembly.words));
    if (arguments.list)
        put_result(printable_lines(dsp32::assembler::listing(assembly, source.text)));
    return assembly.object;
}

std::uint32_t address_of(const Object& object, const std::string& label) {
    if (const auto address = object.address_of(label)) return *address;
    throw Error(ErrorKind::setting, "there is no label " + printable(label) + " in the program");
}

std::string number_of(const dsp32::Accumulator& accumulator) {
    const Word word = dsp32::store(accumulator);
    return fmt::format("{:.9g} ({:08x})", dsp32::double_of(word), word);
}

constexpr unsigned register_codes = dsp32::isa::register_count;

/// A processor's registers, to be compared with what they become.
struct Registers {
    std::array<std::uint16_t, register_codes> whole{};
    std::array<dsp32::Accumulator, 4> accumulators;

    static Registers of(const Processor& processor) {
        Registers result;
        for (unsigned i = 0; i < register_codes; ++i) result.whole[i] = processor.register_value(i);
        for (std::size_t i = 0; i < 4; ++i) result.accumulators[i] = processor.accumulator(i);
        return result;
    }
    [[nodiscard]] std::string changes_to(const Registers& later) const {
        std::string text;
        for (unsigned i = 0; i < register_codes; ++i)
            if (whole[i] != later.whole[i])
                text += fmt::format("  {} = {:04x}", dsp32::isa::register_names[i], later.whole[i]);
        for (std::size_t i = 0; i < 4; ++i)
            if (!(accumulators[i] == later.accumulators[i]))
                text += fmt::format("  a{} = {}", i, number_of(later.accumulators[i]));
        return text;
    }
};

bool holds(const std::vector<std::uint32_t>& breakpoints, const Processor& processor) {
    return std::ranges::find(breakpoints, processor.program_counter()) != breakpoints.end();
}

/// Executes one instruction after the other and prints each with what it changed.
Stop traced(Processor& processor, const Object& object, std::uint64_t steps,
            const std::vector<std::uint32_t>& breakpoints) {
    const auto label_of = [&](std::uint32_t address) { return object.name_of(address); };
    for (std::uint64_t i = 0; i < steps && !stop_requested(); ++i) {
        const std::uint32_t address = processor.program_counter();
        if (i > 0 && holds(breakpoints, processor)) return {StopReason::breakpoint, address, 0, {}};
        const Registers before = Registers::of(processor);
        const bool there = address % 4 == 0 && address < fast_memory_bytes;
        const Word word = there ? processor.fast_word(address) : 0;
        const Stop stop = processor.run(1);
        if (stop.reason != StopReason::steps_used) return stop;
        put_result(fmt::format("{:04x}  {:<40}{}\n", address,
                               dsp32::isa::text_of(word, address, object.dialect, label_of),
                               before.changes_to(Registers::of(processor))));
    }
    return {StopReason::steps_used, processor.program_counter(), 0, {}};
}

/// Runs in parts, so that a signal is heard.
Stop run_in_parts(Processor& processor, std::uint64_t steps,
                  const std::vector<std::uint32_t>& breakpoints) {
    constexpr std::uint64_t part = 1'000'000;
    Stop stop{StopReason::steps_used, processor.program_counter(), 0, {}};
    while (steps > 0 && stop.reason == StopReason::steps_used && !stop_requested()) {
        const std::uint64_t some = std::min(steps, part);
        stop = processor.run(some, breakpoints);
        steps -= some;
        // The next part would not stop in front of its first instruction.
        if (stop.reason == StopReason::steps_used && holds(breakpoints, processor))
            stop.reason = StopReason::breakpoint;
    }
    return stop;
}

constexpr std::array<const char*, 4> stale_kinds{"an accumulator", "a condition", "memory",
                                                 "a register just loaded"};

void print_state(const Processor& processor, const Stop& stop) {
    put_result(fmt::format("{} at {:04x}: {} instructions, {} cycles, {:.6g} ms\n",
                           text_of(stop.reason), stop.instruction_address, processor.instructions(),
                           processor.cycles(),
                           static_cast<double>(processor.cycles()) * instruction_seconds * 1e3));
    const auto& stale = processor.stale_reads();
    if (stale.count > 0)
        put_result(fmt::format(
            "{} reads got an old value from the pipeline, the first {} at {:04x}\n", stale.count,
            stale_kinds[static_cast<std::size_t>(stale.first_kind)], stale.first_address));
    const std::string registers = Registers{}.changes_to(Registers::of(processor));
    if (!registers.empty()) put_result(registers.substr(2) + "\n");
}

/// A program that was stopped by its machine is a failure of the run, or a limit of the machine.
void refuse_stop(const Stop& stop) {
    if (stop.reason == StopReason::ended || stop.reason == StopReason::breakpoint) return;
    std::string message =
        fmt::format("the program {} at {:04x}", text_of(stop.reason), stop.instruction_address);
    if (!stop.fault) throw Error(ErrorKind::failed, message);
    message += fmt::format(": address {:04x}, {} of node {}: {} bytes wanted, {} there",
                           stop.access_address, stop.fault->bank, stop.fault->node,
                           stop.fault->wanted_bytes, stop.fault->limit_bytes);
    throw Error(ErrorKind::machine_limit, message);
}

ExitCode run_object(const AsmArguments& arguments, const Object& object) {
    if (object.dialect != dsp32::isa::Dialect::dsp32)
        throw Error(ErrorKind::setting, "--run: the nodes have the first DSP32, no DSP32C");
    std::vector<std::uint32_t> breakpoints;
    for (const std::string& label : arguments.breakpoints)
        breakpoints.push_back(address_of(object, label));
    ProcessorNode node({}, 0);
    Processor processor(node);
    std::vector<Word> words = object.text;
    words.insert(words.end(), object.data.begin(), object.data.end());
    if (processor.load(words)) refuse_size(words.size());
    processor.start(address_of(object, arguments.run));
    const Stop stop = arguments.trace ? traced(processor, object, arguments.steps, breakpoints)
                                      : run_in_parts(processor, arguments.steps, breakpoints);
    if (stop_requested()) return exit_code_of_signal(received_signal());
    print_state(processor, stop);
    refuse_stop(stop);
    return ExitCode::done;
}

/// Throws Error unless the object can be written there, and there is nothing that was read.
void require_object_place(const AsmArguments& arguments, const std::string& out) {
    std::vector<InputFile> inputs;
    for (const std::string& file : arguments.files) inputs.push_back({file, "what is assembled"});
    require_spared({out}, inputs);
    require_writable(out);
}

ExitCode assemble(const AsmArguments& arguments) {
    const Source source = read_source(arguments.files);
    const bool is_object = source.text.starts_with(object_start);
    const bool only_shown = arguments.list || arguments.disassemble || !arguments.run.empty();
    std::string out = arguments.out;
    if (out.empty() && !only_shown && !is_object)
        out = std::filesystem::path(arguments.files.front()).stem().string() + ".o";
    if (!out.empty()) require_object_place(arguments, out);
    const Object object = is_object ? read_object(arguments.files.front(), source.text)
                                    : assemble_source(arguments, source);
    if (arguments.disassemble || (is_object && arguments.run.empty()))
        put_result(printable_lines(dsp32::assembler::disassembly(object)));
    if (!out.empty()) {
        write_text_safely(out, dsp32::assembler::text_of(object));
        tell(fmt::format("{}: {} words of {}\n", printable_path(out), object.words(),
                         fast_memory_bytes / sizeof(Word)));
    }
    return arguments.run.empty() ? ExitCode::done : run_object(arguments, object);
}

}  // namespace

AddedCommand add_asm_command(CommandLine& line) {
    const auto a = std::make_shared<AsmArguments>();
    CommandOptions command =
        line.add_command("asm", "Assemble a program for a node's DSP32, list it, or run it");
    command.add_option("files", a->files, "Assembler source, of several files as one; or an object")
        .required();
    command.add_option(
        "-o,--out", a->out,
        "The object; default: the first file's name + .o, unless something is only shown");
    command.add_flag("--list", a->list, "Print addresses and words beside the source");
    command.add_flag("--disassemble", a->disassemble, "Print the program as source, with labels");
    command.add_flag("--dsp32c", a->dsp32c, "Allow the instructions that the DSP32C added");
    command.add_option("--run", a->run, "Call the routine with this label on a node of its own");
    command.add_flag("--trace", a->trace,
                     "With --run: print each instruction and the registers that it changed");
    command.add_option("--steps", a->steps, "With --run: instructions at most; default 10000000")
        .transform(any_whole_number());
    command.add_option("--break", a->breakpoints, "With --run: stop in front of this label")
        .one_value();
    command.check_all(some_text());
    return {command, [a] { return assemble(*a); }};
}

}  // namespace pxm::host
