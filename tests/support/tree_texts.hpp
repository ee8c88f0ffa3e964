// What stands written in the tree: documents, sources, scenes and scripts, by their paths.
#pragma once

#include <map>
#include <string>

namespace pxm::test {

using Texts = std::map<std::string, std::string>;  // path from the top of the tree: text

/// Every text that people wrote here. What is built or fetched into the tree is not among them.
[[nodiscard]] Texts texts_of_the_tree();

[[nodiscard]] bool is_document(const std::string& path);

}  // namespace pxm::test
