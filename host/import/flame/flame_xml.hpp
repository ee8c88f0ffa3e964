// The XML of a .flame file as plain elements; the one place that knows pugixml. Entities beyond the
// five of XML and numbers of characters are never expanded, nothing is fetched, and a file of more
// elements or attributes than such files have is refused before any of it is built.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/scene/scene.hpp"

namespace pxm::host {

struct XmlElement {
    std::string name;
    std::vector<std::pair<std::string, std::string>> attributes;
    std::string text;  // directly inside it
    std::vector<XmlElement> children;
    Position position;

    /// The attribute's value; null if it is not there.
    [[nodiscard]] const std::string* attribute(std::string_view attribute) const;
};

/// The <flame> of the file that is asked for (as choose_entry takes it), with its children but not
/// theirs; its attribute `name` is there: "flame 3" where it has none. Throws Error(scene): not
/// XML, with the place, or no flame in it; and as choose_entry does.
[[nodiscard]] XmlElement read_flame(const SourceFile& source,
                                    const std::optional<std::string>& entry);

/// The names of all flames of the file, as read_flame calls them. Throws Error(scene) as it does.
[[nodiscard]] std::vector<std::string> flame_names(const SourceFile& source);

}  // namespace pxm::host
