// Errors of pxm as exceptions of Python: pxm._errors has their classes.
#pragma once

#include <pybind11/pybind11.h>

namespace pxm::python {

/// What pxm throws from now on becomes an exception of Python.
void translate_errors(pybind11::module_& module);

}  // namespace pxm::python
