// Who may include whom, and what a room of the house must not know:
//   python/ --> host/ --> dsp_kernels/ --> pxm/    nothing points back, nothing includes tests/
// and so do the rooms of host/, by the list of floors below.
// The rules are a function of paths and texts, so that the tests can show that it sees what is
// wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/paths.hpp"
#include "tests/support/source_functions.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

struct SourceText {
    std::string path;  // from the top of the tree
    std::string text;
};

using Complaints = std::vector<std::string>;

/// A rule: text that matches `pattern` may stand only in files whose path matches `home`.
struct Rule {
    Rule(const char* a, const char* b, const char* c) : pattern(a), home(b), what(c) {}
    std::regex pattern;
    std::regex home;
    const char* what;
};

// Outside libraries, each known to one place.
const Rule library_rules[] = {
    {R"(#include\s*<OpenImageIO/)", "host/openimageio/.*", "OpenImageIO"},
    {R"(#include\s*<OpenEXR/)", "host/openexr/.*", "OpenEXR"},
    {R"(#include\s*<openvdb/)", "host/openvdb/.*", "OpenVDB"},
    {R"(#include\s*<zlib\.h>)", "host/(output/png|files/deflated)\\.cpp", "zlib"},
    {R"(#include\s*<CLI/)", "host/commands/options\\.cpp", "CLI11"},
    {R"(#include\s*<nlohmann/)", "host/(.*json[^/]*|output/.*|commands/.*|study/.*)",
     "nlohmann-json"},
    {R"(#include\s*<Eigen/)", "host/(math|fractal|import)/.*", "Eigen"},
    {R"(#include\s*<pugixml\.hpp>)", "host/import/flame/flame_xml\\.cpp", "pugixml"},
    {R"(#include\s*<omp\.h>)", "host/engine/(tiles|threads)\\..pp", "OpenMP"},
    {R"(#include\s*<hwy/)", "host/wide/.*", "Highway"},
    {R"(#include\s*<boost/multiprecision/)",
     "host/(math/precise\\.cpp|import/lsystem/long_number\\.hpp)", "Boost.Multiprecision"},
    {R"(#include\s*<(flint/|arb|antic/))", "host/fractal/exact/.*", "FLINT"},
    {R"(#include\s*<boost/(asio|beast)/)",
     "host/studio/(http_(server\\.cpp|connection\\..pp)|web_socket\\..pp)", "Boost.Beast"},
    {R"(#include\s*<pybind11/)", "python/module/.*", "pybind11"},
};

// The floors of a part of the house, from the ground up. A room may know what stands before it;
// rooms on one floor do not know each other.
struct Floors {
    const char* part;
    std::vector<std::vector<std::string>> rooms;
};
const Floors all_floors[] = {
    {"host/",
     {{"error.hpp"},
      {"text"},
      {"process"},
      {"files"},
      {"math"},
      {"fractal"},
      {"scene"},
      {"exact"},
      {"compiled"},
      {"node_program"},
      {"engine"},
      {"compile", "wide", "output", "openimageio", "openexr", "flint"},
      {"import", "export"},
      {"openvdb"},
      {"render"},
      {"parts"},
      {"inspect"},
      {"study"},
      {"studio"},
      {"commands"}}},
    {"host/fractal/", {{"system"}, {"exact"}, {"bounds"}, {"dimension", "measure", "neighbours"}}},
    {"host/wide/", {{"packet"}, {"tables"}, {"search"}, {"shade"}, {"area"}, {"tile"}}},
};

// What a node does not have: streams, threads, an allocator, exceptions.
const Rule node_rules[] = {
    {R"(#include\s*<(iostream|ostream|fstream|sstream|cstdio)>)", "(?!dsp_kernels/).*", "streams"},
    {R"(#include\s*<(thread|mutex|atomic|future)>)", "(?!dsp_kernels/).*", "threads"},
    {R"(\bstd::(vector|string|map|set|deque|list|function|unique_ptr|shared_ptr)\b)",
     "(?!dsp_kernels/).*", "a container that allocates"},
    {R"(\b(new|malloc)\b(?!>))", "(?!dsp_kernels/).*", "allocation"},
    {R"(\b(throw|try|catch)\b)", "(?!dsp_kernels/).*", "exceptions"},
    {R"(\bstd::c(out|err)\b|\bf?printf\b)", "(?!dsp_kernels/|pxm/).*", "printing"},
};

/// The text with comments removed and strings emptied, except in include lines.
std::string code_of(const std::string& text) {
    static const std::regex noise(
        R"((#include[^\n]*)|//[^\n]*|/\*[^]*?\*/|"(?:\\.|[^"\\\n])*"|('(?:\\.|[^'\\\n])'))");
    return std::regex_replace(text, noise, "$1");
}

/// The lines that include something: a hundredth of a tree, which is searched many times.
std::string include_lines(const std::string& code) {
    std::istringstream all(code);
    std::string lines;
    for (std::string line; std::getline(all, line);)
        if (line.find("#include") != std::string::npos) lines += line + "\n";
    return lines;
}

std::vector<std::string> included(const std::string& code, char open, char close) {
    const std::regex line(std::string(R"(#include\s*)") + open + "([^" + close + "\n]*)" + close);
    std::vector<std::string> paths;
    for (std::sregex_iterator it(code.begin(), code.end(), line), end; it != end; ++it)
        paths.push_back((*it)[1]);
    return paths;
}

std::string room(const std::string& path) { return path.substr(0, path.find('/')); }

/// Lower is nearer to the machine: a room may include itself and what is lower.
int height(const std::string& path) {
    static const std::vector<std::string> rooms{"pxm", "dsp_kernels", "host", "python", "tests"};
    return static_cast<int>(std::ranges::find(rooms, room(path)) - rooms.begin());
}

/// The room of a path in a part of the house; empty if it is not in that part.
std::string room_in(const Floors& floors, const std::string& path) {
    const std::string part = floors.part;
    if (!path.starts_with(part)) return "";
    return path.substr(part.size(), path.find('/', part.size()) - part.size());
}

/// The floor that a room is on; beyond the highest if the list does not have it.
std::size_t floor_of(const Floors& floors, const std::string& room) {
    for (std::size_t i = 0; i < floors.rooms.size(); ++i)
        if (std::ranges::find(floors.rooms[i], room) != floors.rooms[i].end()) return i;
    return floors.rooms.size();
}

void check_floors(const SourceText& source, const std::string& target, Complaints& complaints) {
    for (const Floors& floors : all_floors) {
        const std::string own = room_in(floors, source.path), other = room_in(floors, target);
        if (own.empty()) continue;
        if (floor_of(floors, own) == floors.rooms.size())
            complaints.push_back(source.path + ": \"" + own + "\" is no room of " + floors.part);
        if (other.empty() || own == other) continue;
        if (floor_of(floors, other) >= floor_of(floors, own))
            complaints.push_back(source.path + ": must not include " + target);
    }
}

void check_includes(const SourceText& source, const std::string& code,
                    const std::set<std::string>& paths, Complaints& complaints) {
    for (const std::string& target : included(code, '"', '"')) {
        if (!paths.contains(target)) {
            complaints.push_back(source.path + ": no file \"" + target +
                                 "\" (paths are from the top of the tree)");
        } else if (height(target) > height(source.path)) {
            complaints.push_back(source.path + ": must not include " + target);
        } else {
            check_floors(source, target, complaints);
        }
    }
    if (height(source.path) > height("dsp_kernels/")) return;
    static const std::regex standard("[a-z0-9_]+");
    for (const std::string& target : included(code, '<', '>'))
        if (!std::regex_match(target, standard))
            complaints.push_back(source.path + ": <" + target + "> is not the standard library");
}

template <std::size_t n>
void check_rules(const SourceText& source, const std::string& code, const Rule (&rules)[n],
                 Complaints& complaints) {
    for (const Rule& rule : rules)
        if (!std::regex_match(source.path, rule.home) && std::regex_search(code, rule.pattern))
            complaints.push_back(source.path + ": " + rule.what + " does not belong here");
}

Complaints check(const std::vector<SourceText>& sources) {
    std::set<std::string> paths;
    for (const SourceText& source : sources) paths.insert(source.path);
    Complaints complaints;
    for (const SourceText& source : sources) {
        if (room(source.path) == "tests") continue;
        const std::string code = code_of(source.text);
        const std::string includes = include_lines(code);
        check_includes(source, includes, paths, complaints);
        check_rules(source, includes, library_rules, complaints);
        check_rules(source, code, node_rules, complaints);
        if (source.path.ends_with(".hpp") && code.find("#pragma once") == std::string::npos)
            complaints.push_back(source.path + ": no #pragma once");
    }
    return complaints;
}

/// Types that two headers define by one name in one namespace: what the compiler makes of them on
/// its own, destructors among them, the linker may take from the wrong one.
Complaints types_defined_twice(const std::vector<SourceText>& sources) {
    static const std::regex space(R"(^namespace ([\w:]+) \{)");
    static const std::regex type(
        R"(^(?:class|struct|enum class|using) (?:alignas\(\d+\) )?(\w+)(?: = .*;|[^;:<]*(:[^:;]*)?\{))");
    std::map<std::string, std::string> homes;
    Complaints complaints;
    for (const SourceText& source : sources) {
        if (!source.path.ends_with(".hpp") || room(source.path) == "tests") continue;
        std::istringstream lines(source.text);
        std::string current, line;
        for (std::smatch found; std::getline(lines, line);) {
            if (std::regex_search(line, found, space)) current = found[1];
            if (!std::regex_search(line, found, type)) continue;
            const std::string name = current + "::" + found[1].str();
            const auto [home, is_new] = homes.emplace(name, source.path);
            if (!is_new)
                complaints.push_back(source.path + ": " + name + " is defined in " + home->second);
        }
    }
    return complaints;
}

constexpr int most_lines = 60;
constexpr int most_parameters = 5;  // of the rooms below: beyond, a struct says what they are

/// What is too long in a source, and in host/wide what has too many parameters. Returns how many
/// functions there are.
std::size_t check_functions(const SourceText& source, Complaints& complaints) {
    const bool few = source.path.starts_with("host/wide/");
    const std::vector<SourceFunction> functions = functions_of(source.text);
    for (const SourceFunction& function : functions) {
        const std::string where =
            source.path + ":" + std::to_string(function.line) + ": " + function.name + " has ";
        if (function.lines > most_lines)
            complaints.push_back(where + std::to_string(function.lines) + " lines");
        if (few && function.parameters > most_parameters)
            complaints.push_back(where + std::to_string(function.parameters) + " parameters");
    }
    return functions.size();
}

std::vector<SourceText> sources_of_the_tree() {
    std::vector<SourceText> sources;
    for (const char* top : {"pxm", "dsp_kernels", "host", "python", "tests"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir) / top)) {
            const fs::path& path = entry.path();
            const std::set<fs::path> kinds{".hpp", ".cpp", ".inl"};
            if (!kinds.contains(path.extension())) continue;
            std::ostringstream text;
            text << std::ifstream(path).rdbuf();
            sources.push_back({fs::relative(path, source_dir).generic_string(), text.str()});
        }
    }
    return sources;
}

/// What is wrong with one file among a few others.
Complaints complaints_about(const std::string& path, const std::string& text) {
    const std::string once = "#pragma once\n";
    return check({{path, (path.ends_with(".hpp") ? once : "") + text},
                  {"pxm/node.hpp", once},
                  {"dsp_kernels/ray.hpp", once},
                  {"host/scene/scene.hpp", once},
                  {"host/error.hpp", once},
                  {"host/fractal/system/rifs.hpp", once},
                  {"host/fractal/bounds/bounds.hpp", once},
                  {"host/wide/packet/lanes.inl", ""},
                  {"host/wide/shade/hit.hpp", once},
                  {"host/output/image.hpp", once},
                  {"tests/support/paths.hpp", once}});
}

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Architecture, the_tree_obeys) {
    const auto sources = sources_of_the_tree();
    ASSERT_GT(sources.size(), 10U);
    EXPECT_THAT(check(sources), IsEmpty());
}

TEST(Architecture, a_type_is_defined_once) {
    EXPECT_THAT(types_defined_twice(sources_of_the_tree()), IsEmpty());
    const SourceText one{"host/a.hpp", "namespace pxm::host {\nstruct A {\n};\n"};
    const SourceText other{"host/b.hpp", "namespace pxm::host {\nclass A : public B {\n};\n"};
    const SourceText another{"pxm/b.hpp", "namespace pxm {\nstruct A {\n};\n"};
    const SourceText said{"host/c.hpp", "namespace pxm::host {\nstruct A;\n"};
    EXPECT_THAT(types_defined_twice({one, said, another}), IsEmpty());
    EXPECT_THAT(types_defined_twice({one, other}),
                ElementsAre("host/b.hpp: pxm::host::A is defined in host/a.hpp"));
}

TEST(Architecture, nothing_points_back) {
    EXPECT_THAT(complaints_about("host/engine/a.cpp", "#include \"dsp_kernels/ray.hpp\"\n"),
                IsEmpty());
    EXPECT_THAT(complaints_about("dsp_kernels/a.hpp", "#include \"pxm/node.hpp\"\n"), IsEmpty());
    EXPECT_THAT(complaints_about("pxm/a.cpp", "#include \"dsp_kernels/ray.hpp\"\n"),
                ElementsAre("pxm/a.cpp: must not include dsp_kernels/ray.hpp"));
    EXPECT_THAT(complaints_about("dsp_kernels/a.hpp", "#include \"host/scene/scene.hpp\"\n"),
                ElementsAre("dsp_kernels/a.hpp: must not include host/scene/scene.hpp"));
    EXPECT_THAT(complaints_about("host/engine/a.cpp", "#include \"tests/support/paths.hpp\"\n"),
                ElementsAre("host/engine/a.cpp: must not include tests/support/paths.hpp"));
    EXPECT_THAT(complaints_about("python/module/a.cpp", "#include \"host/error.hpp\"\n"),
                IsEmpty());
}

TEST(Architecture, rooms_of_the_host_only_point_down) {
    const auto including = [](const std::string& path, const std::string& target) {
        return complaints_about(path, "#include \"" + target + "\"\n");
    };
    EXPECT_THAT(including("host/scene/a.cpp", "host/fractal/system/rifs.hpp"), IsEmpty());
    EXPECT_THAT(including("host/fractal/bounds/a.cpp", "host/scene/scene.hpp"),
                ElementsAre("host/fractal/bounds/a.cpp: must not include host/scene/scene.hpp"));
    EXPECT_THAT(including("host/wide/tile/a.cpp", "host/output/image.hpp"),
                ElementsAre("host/wide/tile/a.cpp: must not include host/output/image.hpp"));
    EXPECT_THAT(including("host/fractal/bounds/a.cpp", "host/fractal/system/rifs.hpp"), IsEmpty());
    EXPECT_THAT(including("host/fractal/system/a.cpp", "host/fractal/bounds/bounds.hpp"),
                SizeIs(1));
    EXPECT_THAT(including("host/wide/shade/a.inl", "host/wide/packet/lanes.inl"), IsEmpty());
    EXPECT_THAT(including("host/wide/search/a.inl", "host/wide/shade/hit.hpp"), SizeIs(1));
    EXPECT_THAT(including("host/attic/a.cpp", "host/error.hpp"),
                Contains(HasSubstr("\"attic\" is no room of host/")));
}

TEST(Architecture, quoted_paths_are_from_the_top_and_exist) {
    EXPECT_THAT(complaints_about("host/scene/a.cpp", "#include \"scene.hpp\"\n"),
                ElementsAre(HasSubstr("no file \"scene.hpp\"")));
    EXPECT_THAT(complaints_about("host/a.cpp", "#include \"host/gone.hpp\"\n"), SizeIs(1));
}

TEST(Architecture, machine_and_kernels_know_the_standard_library_alone) {
    for (const char* header : {"glm/vec3.hpp", "fmt/core.h", "boost/version.hpp", "unistd.h"}) {
        const std::string include = "#include <" + std::string(header) + ">\n";
        EXPECT_THAT(complaints_about("pxm/a.hpp", include), SizeIs(1)) << header;
        EXPECT_THAT(complaints_about("dsp_kernels/a.hpp", include), SizeIs(1)) << header;
        EXPECT_THAT(complaints_about("host/a.hpp", include), IsEmpty()) << header;
    }
    EXPECT_THAT(complaints_about("pxm/a.hpp", "#include <cstdint>\n"), IsEmpty());
}

TEST(Architecture, an_outside_library_is_known_to_one_place) {
    const std::vector<std::pair<std::string, std::string>> homes{
        {"OpenImageIO/imageio.h", "host/openimageio/picture_library.cpp"},
        {"OpenEXR/ImfHeader.h", "host/openexr/exr_output.cpp"},
        {"CLI/CLI.hpp", "host/commands/options.cpp"},
        {"nlohmann/json.hpp", "host/output/statistics_json.cpp"},
        {"Eigen/SVD", "host/math/lipschitz.cpp"},
        {"pugixml.hpp", "host/import/flame/flame_xml.cpp"},
        {"omp.h", "host/engine/tiles.hpp"},
        {"boost/multiprecision/cpp_bin_float.hpp", "host/math/precise.cpp"},
        {"boost/beast/http.hpp", "host/studio/http_server.cpp"},
        {"pybind11/stl.h", "python/module/scene.cpp"},
        {"hwy/highway.h", "host/wide/search/packet_search.cpp"}};
    for (const auto& [header, home] : homes) {
        const std::string include = "#include <" + header + ">\n";
        EXPECT_THAT(complaints_about(home, include), IsEmpty()) << header;
        EXPECT_THAT(complaints_about("host/scene/a.cpp", include), SizeIs(1)) << header;
    }
}

TEST(Architecture, a_node_has_no_allocator_no_exceptions_no_streams_no_threads) {
    for (const char* text :
         {"int* p = new int;", "throw 1;", "std::vector<int> v;", "#include <iostream>\n",
          "#include <thread>\n", "std::cout << 1;", "printf(x);", "try { f(); } catch (...) {}"}) {
        EXPECT_GE(complaints_about("dsp_kernels/a.hpp", text).size(), 1U) << text;
    }
    EXPECT_THAT(complaints_about("pxm/a.cpp", "std::cout << 1;"), SizeIs(1));
}

TEST(Architecture, comments_and_strings_are_not_code) {
    EXPECT_THAT(complaints_about("dsp_kernels/a.hpp",
                                 "// a new cell\n/* throw\n */ constexpr auto s = \"printf\";\n"
                                 "char c = '\"'; int renewed = 1;\n"),
                IsEmpty());
}

TEST(Architecture, a_header_is_read_once) {
    EXPECT_THAT(check({{"pxm/a.hpp", "// #pragma once\nint a();\n"}}),
                ElementsAre("pxm/a.hpp: no #pragma once"));
}

TEST(Architecture, functions_are_short_and_few_things_are_told_one_by_one) {
    const auto sources = sources_of_the_tree();
    Complaints complaints;
    std::size_t functions = 0;
    for (const SourceText& source : sources) functions += check_functions(source, complaints);
    EXPECT_THAT(complaints, IsEmpty());
    EXPECT_GT(functions, 5 * sources.size());  // the parser finds them
}

TEST(Architecture, it_sees_functions_that_are_too_long_or_take_too_much) {
    const auto about = [](const char* path, const std::string& text) {
        Complaints complaints;
        (void)check_functions({path, text}, complaints);
        return complaints;
    };
    const std::string six = "void f(int a, int b, int c, int d, int e, int g);\n";
    EXPECT_THAT(about("host/wide/a.hpp", six),
                ElementsAre("host/wide/a.hpp:1: f has 6 parameters"));
    EXPECT_THAT(about("host/math/a.hpp", six), IsEmpty());
    const std::string body = "int f() {\n" + std::string(59, '\n') + "}\n";
    EXPECT_THAT(about("pxm/a.cpp", body), ElementsAre("pxm/a.cpp:1: f has 61 lines"));
    EXPECT_THAT(about("pxm/a.cpp", "int f() {" + std::string(59, '\n') + "}\n"), IsEmpty());
}

}  // namespace
}  // namespace pxm::test
