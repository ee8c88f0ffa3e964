// Points of attractors, drawn into memory that Python has.
#pragma once

#include <pybind11/pybind11.h>

namespace pxm::python {

void add_points(pybind11::module_& module);

}  // namespace pxm::python
