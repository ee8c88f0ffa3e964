// The campaigns about text: random FRACTINT entries and random scenes keep their meaning through
// import, print and parse.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <random>

#include "host/import/import.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/print/print.hpp"
#include "tests/host/scene/random_scene.hpp"
#include "tests/host/scene/scene_text.hpp"

namespace pxm::host {
namespace {

/// An entry of 1 to 50 maps of the plane or of space that contract: every row's numbers sum up to
/// less than 1, some maps are singular, some are written with exponents.
std::string random_entry(unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const bool solid = seed % 2 == 0;
    const int dimension = solid ? 3 : 2;
    std::string text = solid ? "e (3D) {\n" : "e {\n";
    for (int m = 1 + static_cast<int>(random() % 50); m > 0; --m) {
        const double most = random() % 10 == 0 ? 0.99 : 0.8;
        for (int i = 0; i < dimension * dimension; ++i) {
            const double value = random() % 5 == 0 ? 0 : most * unit(random) / dimension;
            text += random() % 3 == 0 ? fmt::format("{:.3e} ", value) : fmt::format("{} ", value);
        }
        for (int i = 0; i < dimension; ++i) text += fmt::format("{} ", 10 * unit(random));
        text += fmt::format("{} ; map\n", std::abs(unit(random)));
    }
    return text + "}\n";
}

TEST(ImportCampaign, thousands_of_entries_keep_through_import_print_and_parse) {
    for (unsigned seed = 0; seed < 3000; ++seed) {
        const std::string entry = random_entry(seed);
        const Imported made = import_fractint({"f.ifs", entry}, FractintFormat::ifs, std::nullopt);
        Diagnostics diagnostics;
        const Scene read = parse_text("imported.pxm", made.text, diagnostics);
        check_scene(read, diagnostics);
        ASSERT_EQ(diagnostics.text(read.files), "") << "seed " << seed << "\n" << entry;
        ASSERT_TRUE(read == made.scene) << "seed " << seed << "\n" << made.text;
    }
}

TEST(PrintCampaign, thousands_of_scenes_are_read_back_as_they_were) {
    for (unsigned seed = 1000; seed < 21'000; ++seed) {
        const Scene scene = test::RandomScene(seed).scene();
        const std::string text = print_scene(scene);
        Diagnostics diagnostics;
        const Scene again = parse_text("s.pxm", text, diagnostics);
        ASSERT_EQ(diagnostics.text(again.files), "") << "seed " << seed << "\n" << text;
        ASSERT_TRUE(again == scene) << "seed " << seed << "\n" << text;
        ASSERT_EQ(print_scene(again), text) << "seed " << seed;
    }
}

}  // namespace
}  // namespace pxm::host
