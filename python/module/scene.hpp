// A scene as Python holds it: what was read, and of what, so that it can be read again for another
// frame of its animation.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <vector>

#include "host/render/render.hpp"
#include "host/scene/check/settings.hpp"
#include "host/scene/scene.hpp"

namespace pxm::python {

struct ReadScene {
    std::string path;                 // or a name for messages, of a text
    std::optional<std::string> text;  // nothing: it is a file
    std::vector<std::string> allowed;
    host::Settings settings;
    host::Scene scene;  // its first frame

    /// What renders it at a frame.
    [[nodiscard]] host::RenderRequest request(double frame) const;
};

/// Adds the class and the functions that ask it.
void add_scene(pybind11::module_& module);

}  // namespace pxm::python
