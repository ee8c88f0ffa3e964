// Laws of the choice among settings.
#include "host/study/pareto.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pxm::host {
namespace {

Json point(const char* name, const Json& seconds, double rmse) {
    return {{"settings", {{"name", name}}}, {"machine_seconds", seconds}, {"rmse", rmse}};
}

/// `slow` and `poor` are beaten; `twin` is as good as `base`.
Json points() {
    return Json::array({point("base", 1.0, 0.10), point("twin", 1.0, 0.10),
                        point("fine", 4.0, 0.05), point("slow", 2.0, 0.10),
                        point("poor", 4.0, 0.20), point("coarse", 0.5, 0.30),
                        point("too large", nullptr, 0.01)});
}

Json marked() {
    Json all = points();
    mark_pareto(all, "machine_seconds", "pareto", "dominated_by");
    Json by_name;
    for (const Json& one : all) by_name[one["settings"]["name"].get<std::string>()] = one;
    return by_name;
}

TEST(Pareto, a_point_is_best_for_its_time_unless_another_is_no_slower_and_no_worse) {
    const Json p = marked();
    for (const char* name : {"base", "twin", "fine", "coarse"}) {
        EXPECT_TRUE(p[name]["pareto"].get<bool>()) << name;
        EXPECT_TRUE(p[name]["dominated_by"].is_null()) << name;
    }
    for (const char* name : {"slow", "poor"}) EXPECT_FALSE(p[name]["pareto"].get<bool>()) << name;
    EXPECT_EQ(p["slow"]["dominated_by"], "base");
    EXPECT_EQ(p["poor"]["dominated_by"], "base");
}

TEST(Pareto, what_has_no_time_neither_wins_nor_loses) {
    const Json p = marked();
    EXPECT_FALSE(p["too large"]["pareto"].get<bool>());
    EXPECT_TRUE(p["too large"]["dominated_by"].is_null());
    EXPECT_TRUE(p["fine"]["pareto"].get<bool>());
}

std::string best(const char* least, const char* bounded, double bound) {
    const Json all = points();
    const Json* found = best_point(all, least, bounded, bound);
    return found ? (*found)["settings"]["name"].get<std::string>() : "";
}

TEST(Pareto, a_budget_takes_the_best_that_fits_and_a_target_the_fastest_that_reaches_it) {
    EXPECT_EQ(best("rmse", "machine_seconds", 1.5), "base");
    EXPECT_EQ(best("rmse", "machine_seconds", 100), "fine");
    EXPECT_EQ(best("rmse", "machine_seconds", 0.1), "");
    EXPECT_EQ(best("machine_seconds", "rmse", 0.06), "fine");
    EXPECT_EQ(best("machine_seconds", "rmse", 0.5), "coarse");
    EXPECT_EQ(best("machine_seconds", "rmse", 0.02), "") << "what has no time cannot be fastest";
}

TEST(Pareto, the_advice_names_the_fastest_as_good_and_the_best) {
    Json all = points();
    EXPECT_THAT(advice_for(all), testing::HasSubstr("as good as the default, fastest: `base`"));
    EXPECT_THAT(advice_for(all), testing::HasSubstr("the best: `fine`"));
    all.push_back(point("quick", 0.7, 0.09));
    EXPECT_THAT(advice_for(all), testing::HasSubstr("as good as the default, fastest: `quick`"));
}

}  // namespace
}  // namespace pxm::host
