// Laws of a report's parts. What a browser makes of them: tests/browser/.
#include "host/study/page/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "host/study/page/plot.hpp"
#include "host/study/page/plot_labels.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Page, text_cannot_become_markup) {
    Page page("a < b");
    page.paragraph("<script>x & y</script>");
    page.table({{"\"n\""}, {{"<i>"}}});
    EXPECT_THAT(page.html(), HasSubstr("<p>&lt;script&gt;x &amp; y&lt;/script&gt;</p>"));
    EXPECT_THAT(page.html(), HasSubstr("<th>&quot;n&quot;</th>"));
    EXPECT_THAT(page.html(), HasSubstr("<title>a &lt; b</title>"));
    EXPECT_THAT(page.html(), Not(HasSubstr("<i>")));
}

TEST(Page, a_page_asks_for_nothing_else) {
    test::Folder folder;
    folder.write("p.png", "Man");
    Page page("p");
    page.row({Page::figure({"map", folder.path("p.png"), 2, 1, {3, 4.5}, "cycles"})});
    EXPECT_THAT(page.html(), HasSubstr("base64,TWFu\""));
    EXPECT_THAT(page.html(), HasSubstr("data-values=\"3 4.5\""));
    EXPECT_THAT(page.html(), Not(HasSubstr("src=\"http")));
    folder.write("p.png", "Ma");
    EXPECT_THAT(Page::figure({"", folder.path("p.png"), 0, 0, {}, ""}), HasSubstr("base64,TWE=\""));
}

TEST(Page, csv_quotes_what_needs_it) {
    EXPECT_EQ(csv_of({{"a", "b"}, {{"1,2", "say \"x\""}, {"3", "4"}}}),
              "a,b\n\"1,2\",\"say \"\"x\"\"\"\n3,4\n");
}

TEST(Plot, numbers_are_written_for_people) {
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(0.97312), "0.9731");
    EXPECT_EQ(number_text(1234567), "1,234,567");
    EXPECT_EQ(number_text(-65536), "-65,536");
    EXPECT_EQ(number_text(1.25e-7), "1.25e-07");
    EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(Plot, what_an_axis_cannot_show_is_left_out) {
    LinePlot plot;
    plot.x.scale = AxisScale::logarithmic;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    plot.series = {{"s", {{0, 1, "zero"}, {10, nan, "none"}, {10, 2, "ten"}, {1000, 3, "more"}}}};
    const std::string svg = svg_of(plot);
    EXPECT_THAT(svg, HasSubstr("data-tip=\"ten\""));
    EXPECT_THAT(svg, Not(HasSubstr("data-tip=\"zero\"")));
    EXPECT_THAT(svg, Not(HasSubstr("data-tip=\"none\"")));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Plot, a_label_stands_beside_its_mark_and_on_no_other) {
    LabelPlacer placer({0, 0, 300, 100});
    placer.mark(50, 50);
    placer.mark(120, 50);
    const auto first = placer.place(50, 50, "seven l");
    const auto second = placer.place(50, 50, "seven l");
    ASSERT_TRUE(first && second);
    EXPECT_FALSE(first->x == second->x && first->y == second->y);
    EXPECT_GT(first->x, 50);
    EXPECT_NEAR(first->y, 50, 5);
    const auto at_the_edge = placer.place(295, 50, "seven l");
    ASSERT_TRUE(at_the_edge);
    EXPECT_STREQ(at_the_edge->anchor, "end");
}

TEST(Plot, a_label_without_room_is_left_out) {
    LabelPlacer placer({0, 0, 300, 10});
    placer.mark(150, 5);
    EXPECT_FALSE(placer.place(150, 5, std::string(100, 'x')));
    EXPECT_FALSE(LabelPlacer({0, 0, 300, 8}).place(20, 4, "higher than the room"));
}

TEST(Plot, a_label_stays_out_of_what_is_kept_clear) {
    LabelPlacer placer({0, 0, 300, 100});
    placer.mark(150, 50);
    placer.keep_clear({150, 0, 300, 100});
    const auto place = placer.place(150, 50, "levels 6");
    ASSERT_TRUE(place);
    EXPECT_STREQ(place->anchor, "end");
}

// A point at the right edge of the axes, at the height of any name of the legend: its label stands
// left of it, wherever a measured time has put it.
TEST(Plot, no_label_lies_on_the_legend) {
    for (int row = 0; row <= 60; ++row) {
        LinePlot plot;
        plot.series = {{"corner", {{0, 0, ""}, {10, 60, ""}}},
                       {"numeric double", {{10, static_cast<double>(row), "", false, "levels 6"}}}};
        const std::string svg = svg_of(plot);
        const auto label = svg.find("class=\"label\">levels 6");
        ASSERT_NE(label, std::string::npos) << row;
        const auto name = svg.find(">numeric double<");
        const auto number = [&](std::size_t before, const char* key) {
            return std::stod(svg.substr(svg.rfind(key, before) + std::string(key).size()));
        };
        const bool starts = svg.rfind("\"start\"", label) > svg.rfind("<text", label) &&
                            svg.rfind("\"start\"", label) != std::string::npos;
        const double x = number(label, " x=\"");
        const double right = starts ? x + 8 * 6.7 : x;
        const bool same_height = std::abs(number(label, " y=\"") - number(name, " y=\"")) < 12;
        EXPECT_FALSE(same_height && right > number(name, " x=\"")) << row;
    }
}

TEST(Plot, only_labelled_points_are_named) {
    LinePlot plot;
    plot.series = {{"s", {{0, 1, "a", false, "alpha"}, {10, 2, "b"}}}};
    EXPECT_THAT(svg_of(plot), HasSubstr("class=\"label\">alpha</text>"));
}

TEST(Plot, a_short_logarithmic_axis_has_more_than_powers_of_ten) {
    LinePlot plot;
    plot.y.scale = AxisScale::logarithmic;
    plot.series = {{"s", {{0, 0.03, ""}, {1, 0.3, ""}}}};
    for (const char* tick : {">0.05<", ">0.1<", ">0.2<"})
        EXPECT_THAT(svg_of(plot), HasSubstr(tick));
    plot.series = {{"s", {{0, 1e-8, ""}, {1, 1e8, ""}}}};
    EXPECT_THAT(svg_of(plot), HasSubstr(">1e8<"));
    EXPECT_THAT(svg_of(plot), Not(HasSubstr(">2<")));
}

TEST(Plot, large_numbers_beside_an_axis_are_short) {
    BarPlot plot;
    plot.bars = {{2e8, ""}};
    const std::string svg = svg_of(plot);
    EXPECT_THAT(svg, HasSubstr(">200e6<"));
    EXPECT_THAT(svg, Not(HasSubstr(">200,000,000<")));
}

TEST(Plot, a_plot_without_values_is_still_a_plot) {
    EXPECT_THAT(svg_of(LinePlot{}), HasSubstr("</svg>"));
    EXPECT_THAT(svg_of(BarPlot{}), Not(HasSubstr("nan")));
    EXPECT_THAT(svg_of(HeatMap{"", "", 1, 1, {5}}), Not(HasSubstr("nan")));
}

TEST(Plot, the_scale_gets_darker_all_the_way) {
    double before = 1000;
    for (int i = 0; i <= 100; ++i) {
        const ScaleColor c = scale_color(i / 100.0);
        const double lightness = 0.299 * c.red + 0.587 * c.green + 0.114 * c.blue;
        EXPECT_LT(lightness, before) << i;
        before = lightness;
    }
}

}  // namespace
}  // namespace pxm::host
