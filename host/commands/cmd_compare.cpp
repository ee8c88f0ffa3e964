// `pxm compare A B`: what two renders of the same picture disagree about.
#include <fmt/format.h>

#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/output/comparison.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/terminal.hpp"

namespace pxm::host {

namespace {

struct CompareArguments {
    std::string a;
    std::string b;
    double tolerance = 0;
};

void print_share(const char* what, double share) {
    if (share < 0) {
        put_result(fmt::format("{:<28} -            (no such channel in both files)\n", what));
    } else {
        put_result(fmt::format("{:<28} {:.6f} %\n", what, share * 100));
    }
}

ExitCode compare(const CompareArguments& arguments) {
    ImageReader a(arguments.a, any_image);
    ImageReader b(arguments.b, any_image);
    ImageComparison comparison(a.header(), b.header());
    for (int y = 0; y < a.header().height; ++y) {
        if (stop_requested()) return exit_code_of_signal(received_signal());
        const float* row = a.next_row();
        comparison.add_row(row, b.next_row());
    }
    const Comparison c = comparison.result();
    print_share("different hits", c.hits);
    print_share("different words", c.words);
    print_share("depths over a pixel apart", c.depths);
    if (c.worst_depth >= 0)
        put_result(
            fmt::format("{:<28} {:.6g} pixels\n", "largest depth difference", c.worst_depth));
    print_share("colours over 1/255 apart", c.colors);
    if (c.other_cell_colors > 0) print_share("  of them in other cells", c.other_cell_colors);
    put_result(fmt::format("{:<28} {:.6g}\n", "RMSE of colour", c.rmse));
    const bool over = c.different > arguments.tolerance;
    put_result(fmt::format("{:<28} {:.6f} % ({} the tolerance of {:.6f} %)\n", "different pixels",
                           c.different * 100, over ? "over" : "within", arguments.tolerance * 100));
    return over ? ExitCode::over_tolerance : ExitCode::done;
}

}  // namespace

AddedCommand add_compare_command(CommandLine& line) {
    const auto a = std::make_shared<CompareArguments>();
    CommandOptions command = line.add_command("compare", "Compare two EXR renders");
    command.add_option("a", a->a, "The first render").required();
    command.add_option("b", a->b, "The second render").required();
    command
        .add_option(
            "--tolerance", a->tolerance,
            "Share of pixels that may differ (hit, depth by over a pixel, or colour by over "
            "1/255); over it the exit code is 6. Default 0")
        .transform(share());
    return {command, [a] { return compare(*a); }};
}

}  // namespace pxm::host
