#include "host/study/study.hpp"
namespace pxm::host {
StudyPlan plan_stability(const StudyRequest&) { return {}; }
StudyPlan plan_error(const StudyRequest&) { return {}; }
}  // namespace pxm::host
