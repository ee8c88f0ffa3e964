// What tests/support/source_functions.hpp finds, and what it must not take for a function.
#include "tests/support/source_functions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pxm::test {
namespace {

/// The functions of a text as "name/parameters/lines".
std::vector<std::string> found(const std::string& text) {
    std::vector<std::string> result;
    for (const SourceFunction& f : functions_of(text))
        result.push_back(f.name + "/" + std::to_string(f.parameters) + "/" +
                         std::to_string(f.lines));
    return result;
}

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SourceFunctions, have_the_parameters_and_lines_that_one_counts) {
    EXPECT_THAT(found("int f() { return 1; }"), ElementsAre("f/0/1"));
    EXPECT_THAT(found("int f(int a, long b)\n{\n}\n"), ElementsAre("f/2/3"));
    EXPECT_THAT(found("void f(const A& a, std::map<int, B<C>> b = {{1, 2}}, char* c);"),
                ElementsAre("f/3/0"));
    EXPECT_THAT(found("template <class D, class V = F<D>>\ninline V f(D d, V v) noexcept {\n}"),
                ElementsAre("f/2/2"));
    EXPECT_THAT(found("auto f(int (*g)(int, int)) -> std::vector<int> {}"), ElementsAre("f/1/1"));
    EXPECT_THAT(found("[[nodiscard]] bool f(const A& /*unused, yes*/, T (&table)[3]) const {}"),
                ElementsAre("f/2/1"));
}

TEST(SourceFunctions, are_members_constructors_and_lambdas_too) {
    EXPECT_THAT(found("struct A {\n  A(int b, int c) : b_(b), c_{c} {}\n  int f(int x) const;\n};"),
                ElementsAre("A/2/1", "f/1/0"));
    EXPECT_THAT(found("const auto clip = [&](V c, V q) HWY_ATTR {\n g(c, q);\n};"),
                ElementsAre("lambda/2/3"));
    EXPECT_THAT(found("void A::f(int a) {\n if (a > 0) {\n g(a);\n }\n}"), ElementsAre("f/1/5"));
}

TEST(SourceFunctions, are_no_calls_conditions_or_texts) {
    EXPECT_THAT(found("f(a, b, c, d, e, g); x = f(a, b * c); return f(a) ? 1 : 2;"), IsEmpty());
    EXPECT_THAT(found("if (f(a, b)) { g(c); } for (int i = 0; i < n; ++i) {}"), IsEmpty());
    EXPECT_THAT(found("// int f() {}\n/* int f() {} */ \"int f() {}\" R\"x(int f() {)\" })x\""),
                IsEmpty());
    EXPECT_THAT(found("#define F(a, b) \\\n  int f(int a) {}\n'('; 1'000;"), IsEmpty());
}

}  // namespace
}  // namespace pxm::test
