// What a study writes into its folder, by name, known before it measures anything.
#pragma once

#include <string>
#include <vector>

#include "host/study/study.hpp"

namespace pxm::host {

/// The paths of all files that the study may write.
[[nodiscard]] std::vector<std::string> files_of(const StudyRequest& request, const StudyPlan& plan);

/// Throws Error(ErrorKind::setting) if one of them is a file that a scene of the study is read
/// from.
void require_spared_scenes(const StudyRequest& request, const StudyPlan& plan);

}  // namespace pxm::host
