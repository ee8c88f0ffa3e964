// Renders for Python: the frame stays where it was rendered, and Python sees its bytes.
#pragma once

#include <pybind11/pybind11.h>

namespace pxm::python {

void add_render(pybind11::module_& module);

}  // namespace pxm::python
