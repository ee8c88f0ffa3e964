// Whole imports: what comes out is a readable scene, and it is what was meant.
#include "host/import/import.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "host/error.hpp"
#include "host/import/imported_scene.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "tests/support/paths.hpp"

namespace pxm::host {
namespace {

using testing::HasSubstr;

const std::string data = pxm::test::source_dir + "/tests/data/import/";

Imported imported(const std::string& file, const std::string& entry) {
    ImportRequest request;
    request.path = data + file;
    request.entry = entry;
    return import_file(request);
}

struct Refusal {
    std::optional<ErrorKind> kind;
    std::string text;
};

template <class Import>
Refusal refusal(const Import& import) {
    try {
        (void)import();
        return {};
    } catch (const Error& error) {
        return {error.kind(), error.what()};
    }
}

Refusal refusal_of(const std::string& text, FractintFormat format,
                   const std::optional<std::string>& entry = std::nullopt) {
    return refusal([&] { return import_fractint({"f", text}, format, entry); });
}

void expect_readable(const Imported& made) {
    Diagnostics diagnostics;
    const Scene read = parse_text("imported.pxm", made.text, diagnostics);
    check_scene(read, diagnostics);
    EXPECT_EQ(diagnostics.text(read.files), "");
    EXPECT_EQ(read, made.scene) << made.text;
}

class ImportedEntries : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(ImportedEntries, print_and_parse_are_the_identity) {
    expect_readable(imported(GetParam().first, GetParam().second));
}

INSTANTIATE_TEST_SUITE_P(
    Files, ImportedEntries,
    testing::Values(std::pair{"classic.ifs", "fern"}, std::pair{"classic.ifs", "TRIANGLE"},
                    std::pair{"classic.ifs", "dragon"}, std::pair{"classic.ifs", "3dfern"},
                    std::pair{"classic.l", "Koch"}, std::pair{"classic.l", "Snowflake"},
                    std::pair{"classic.l", "Dragon"}, std::pair{"classic.l", "Arrowhead"},
                    std::pair{"classic.l", "Tree"}, std::pair{"classic.l", "Plant"}));

TEST(Import, the_fern_is_barnsleys) {
    const Imported fern = imported("classic.ifs", "fern");
    EXPECT_EQ(fern.name, "fern");
    EXPECT_THAT(fern.text, testing::StartsWith(
                               "# fern: entry \"fern\" of classic.ifs (FRACTINT, 2-D: the plane "
                               "z = 0)\n# imported by pxm "));
    ASSERT_EQ(fern.scene.ifs[0].maps.size(), 4U);
    EXPECT_EQ(fern.scene.ifs[0].maps[1].weight, 0.85);
    const Affine second = compose(fern.scene.ifs[0].maps[1].commands);
    EXPECT_EQ(second.linear[0], glm::dvec3(.85, -.04, 0));
    EXPECT_EQ(second.linear[1], glm::dvec3(.04, .85, 0));
}

TEST(Import, what_does_not_contract_is_refused_with_the_map) {
    const Refusal r = refusal([] { return imported("classic.ifs", "grows"); });
    EXPECT_EQ(r.kind, ErrorKind::scene);
    EXPECT_THAT(r.text,
                HasSubstr("classic.ifs:20:1: error: \"grows\" is no linear fractal: it could "
                          "not be shown to contract: map 1 has Lipschitz constant 1.01"));
    EXPECT_EQ(refusal([] { return imported("classic.l", "Straight"); }).kind, ErrorKind::scene);
    EXPECT_EQ(refusal([] { return imported("classic.l", "Closed"); }).kind, ErrorKind::scene);
    EXPECT_EQ(refusal([] { return imported("classic.l", "Context"); }).kind, ErrorKind::scene);
}

TEST(Import, of_several_entries_one_must_be_chosen) {
    const std::string two = "a { .5 0 0 .5 0 0 1 } B { .5 0 0 .5 0 1 1 }";
    const Refusal none = refusal_of(two, FractintFormat::ifs);
    EXPECT_EQ(none.kind, ErrorKind::setting);
    EXPECT_EQ(none.text, "f has 2 entries; choose one with --entry NAME:\n  a\n  B");
    const Refusal other = refusal_of(two, FractintFormat::ifs, "c");
    EXPECT_EQ(other.kind, ErrorKind::setting);
    EXPECT_EQ(other.text, "f has no entry \"c\"; it has:\n  a\n  B");
    EXPECT_EQ(import_fractint({"f", two}, FractintFormat::ifs, "b").name, "B");
    EXPECT_EQ(refusal_of("", FractintFormat::ifs).kind, ErrorKind::scene);
    EXPECT_EQ(refusal_of("; nothing", FractintFormat::l).text, "f: no entries");
}

TEST(Import, a_file_that_is_not_there_is_a_file_error) {
    for (const char* name : {"none.ifs", "none.l", "none.png", "none.xy"}) {
        ImportRequest request;
        request.path = data + name;
        EXPECT_EQ(refusal([&] { return import_file(request); }).kind, ErrorKind::file) << name;
    }
}

TEST(Import, names_become_names_of_the_scene_language) {
    EXPECT_EQ(scene_name("fern"), "fern");
    EXPECT_EQ(scene_name("3d-fern's"), "_3d_fern_s");
    EXPECT_EQ(scene_name("light"), "light_");
    EXPECT_EQ(scene_name(""), "imported");
}

TEST(Import, what_is_none_of_its_formats_is_told_them) {
    const auto refusal = [](const std::string& path) {
        ImportRequest request;
        request.path = path;
        try {
            (void)import_file(request);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::scene);
            return std::string(error.what());
        }
        return std::string("it was imported");
    };
    const std::string readme = pxm::test::source_dir + "/README.md";
    EXPECT_EQ(refusal(readme), readme +
                                   " is no format that pxm imports: FRACTINT's .ifs and .l, flames "
                                   "(.flame), IFStile's .aifs, EisenScript (.es), "
                                   "IFSRenderer's .ifsjson, points (.xy, .txt), or a picture (PNG, "
                                   "JPEG, OpenEXR, TIFF, PNM)");
    const std::string scene = pxm::test::source_dir + "/scenes/tetra.pxm";
    EXPECT_EQ(refusal(scene), scene + " is a scene already: pxm render " + scene);
}

TEST(Import, numbers_alone_are_named_after_their_file) {
    const std::string numbers = ".5 0 0 .5 0 0 .5\n.5 0 0 .5 1 0 .5\n";
    EXPECT_EQ(import_fractint({"of/1988 set.ifs", numbers}, FractintFormat::ifs, {}).name,
              "_1988_set");
}

TEST(Import, what_cannot_be_bounded_is_refused) {
    const std::string far = "t { .5 0 0 .5 1e300 0 1  .5 0 0 .5 -1e300 0 1 }";
    try {
        (void)import_fractint({"far.ifs", far}, FractintFormat::ifs, {});
        FAIL() << "it was imported";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("far.ifs:1:1: error: \"t\" has no view: its points lie so "
                                       "far from the origin that they could not be bounded"));
    }
}

TEST(Import, any_bytes_end_in_a_scene_or_a_message) {
    const std::string alphabet = "fFgXY+-|![]@\\/iq0123456789.; \n\r\t{}=()3Dc<>,e\"\x80#";
    for (const auto& [file, format] : {std::pair{"classic.ifs", FractintFormat::ifs},
                                       std::pair{"classic.l", FractintFormat::l}}) {
        const std::string whole = read_file(data + file);
        for (unsigned seed = 0; seed < 150; ++seed) {
            SCOPED_TRACE(seed);
            std::mt19937 random(seed);
            const std::size_t begin = random() % whole.size();
            std::string text = "t {\n" + whole.substr(begin, random() % 200);
            for (int i = 0; i < 6; ++i) {
                const char c = alphabet[random() % alphabet.size()];
                const std::size_t at = random() % text.size();
                random() % 2 == 0 ? void(text[at] = c) : void(text.insert(at, 1, c));
            }
            try {
                expect_readable(import_fractint({"f", text}, format, "t"));
            } catch (const Error& error) {
                EXPECT_TRUE(error.kind() == ErrorKind::scene || error.kind() == ErrorKind::setting);
            }
        }
    }
}

}  // namespace
}  // namespace pxm::host
