// Every example of docs/import.md (fenced as ```ifs, ```l, ```flame, ```aifs or ```es) imports,
// entry by entry.
#include <gtest/gtest.h>

#include <sstream>

#include "host/import/aifs/aifs_scene.hpp"
#include "host/import/eisenscript/eisen_scene.hpp"
#include "host/import/flame/flame.hpp"
#include "host/import/fractint/fractint_ifs.hpp"
#include "host/import/fractint/fractint_l.hpp"
#include "host/import/import.hpp"
#include "host/scene/parse/parser.hpp"
#include "tests/support/paths.hpp"

namespace pxm::host {
namespace {

/// The blocks of the document fenced with that word.
std::vector<std::string> examples(const std::string& fence) {
    std::istringstream file(read_file(pxm::test::source_dir + "/docs/import.md"));
    std::vector<std::string> list;
    bool inside = false;
    for (std::string line; std::getline(file, line);) {
        if (inside && line == "```") {
            inside = false;
        } else if (inside) {
            list.back() += line + '\n';
        } else if (line == "```" + fence) {
            inside = true;
            list.emplace_back();
        }
    }
    return list;
}

template <class Entry>
int import_all(const std::string& text, const std::vector<Entry>& entries, FractintFormat format) {
    int count = 0;
    for (const Entry& e : entries) {
        EXPECT_FALSE(import_fractint({"docs", text}, format, e.entry.name).text.empty());
        ++count;
    }
    return count;
}

TEST(ImportDocs, every_example_is_imported) {
    int ifs = 0;
    int l = 0;
    Diagnostics diagnostics;
    for (const std::string& text : examples("ifs"))
        ifs += import_all(text, parse_fractint_ifs(text, diagnostics), FractintFormat::ifs);
    for (const std::string& text : examples("l"))
        l += import_all(text, parse_fractint_l(text, diagnostics), FractintFormat::l);
    EXPECT_FALSE(diagnostics.has_errors());
    EXPECT_EQ(ifs, 1);
    EXPECT_EQ(l, 4);
}

TEST(ImportDocs, examples_of_other_programs_are_imported) {
    ASSERT_EQ(examples("flame").size(), 1U);
    EXPECT_EQ(import_flame({"docs", examples("flame")[0]}, {}).scene.ifs[0].maps.size(), 3U);
    ASSERT_EQ(examples("aifs").size(), 1U);
    EXPECT_EQ(import_aifs({"docs", examples("aifs")[0]}, "Koch curve").scene.ifs[0].maps.size(),
              4U);
    EXPECT_EQ(
        import_aifs({"docs", examples("aifs")[0]}, "Robinson triangles").scene.ifs[0].maps.size(),
        5U);
    ASSERT_EQ(examples("es").size(), 1U);
    EXPECT_GT(import_eisenscript({"docs", examples("es")[0]}, 1).scene.ifs[0].maps.size(), 40U);
}

}  // namespace
}  // namespace pxm::host
