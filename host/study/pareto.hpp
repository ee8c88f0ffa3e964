// The choice among settings: which no other beats, and what to advise. A point is the JSON of a
// setting with its times and its error (docs/studies-format.md); a time of null is no time.
#pragma once

#include <string>

#include "host/study/study.hpp"

namespace pxm::host {

/// Sets `mark` at the points that no other beats in both time and RMSE, and `by` at the others to
/// the name of one that does.
void mark_pareto(Json& points, const char* time, const char* mark, const char* by);

/// The point of least `least` among those whose `bounded` is at most `bound`; null if none is.
[[nodiscard]] const Json* best_point(const Json& points, const char* least, const char* bounded,
                                     double bound);

/// One line: what is as good as the first point and fastest, what halves the way to the best, and
/// the best.
[[nodiscard]] std::string advice_for(const Json& points);

}  // namespace pxm::host
