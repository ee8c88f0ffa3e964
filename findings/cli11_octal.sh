#!/usr/bin/env bash
# libcli11-dev 2.1.2+ds-1 (Debian 12), g++ 12.
#
# An option that is bound to a whole number takes a leading 0 for octal, one that is bound to a floating-point number does
# not: of the same program `--count 010` is 8 and `--factor 010` is 10, and `--count 08` is refused while `--factor 08`
# is 8. A good engineer expects what people write on a command line (frames 007, 008, 009 out of a script) to be decimal,
# and at the very least the same for every option: the option's type in the source is nothing that a user can see.
#
# For a program: read a whole number as text and convert it in base 10 by one function of one's own, or give every such
# option a transform. The worse of the two results is the silent one.
#
# Seen on 2026-11-30:
#   --count 010, a long                                          8
#   --factor 010, a double                                       10
#   --count 08                                                   refused
#   --factor 08                                                  8
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

command -v g++ >/dev/null || { echo "not tried: no g++" >&2; exit 77; }
fetch libcli11-dev=2.1.2+ds-1
cat >"$work/options.cpp" <<'CPP'
#include <CLI/CLI.hpp>
#include <iostream>

int main(int argc, char** argv) {
    CLI::App app;
    long count = 0;
    double factor = 0;
    app.add_option("--count", count);
    app.add_option("--factor", factor);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError&) {
        std::cout << "refused\n";
        return 0;
    }
    std::cout << (app.count("--count") > 0 ? static_cast<double>(count) : factor) << '\n';
}
CPP
g++ -std=c++17 -isystem "$work/root/usr/include" "$work/options.cpp" -o "$work/options"

same "--count 010, a long" "$("$work/options" --count 010)" 8
same "--factor 010, a double" "$("$work/options" --factor 010)" 10
same "--count 08" "$("$work/options" --count 08)" refused
same "--factor 08" "$("$work/options" --factor 08)" 8
holds
