#include "python/module/errors.hpp"

#include <exception>

#include "host/error.hpp"

namespace pxm::python {

namespace py = pybind11;

namespace {

const char* kind_word(host::ErrorKind kind) {
    switch (kind) {
        case host::ErrorKind::failed:
            return "failed";
        case host::ErrorKind::setting:
            return "setting";
        case host::ErrorKind::scene:
            return "scene";
        case host::ErrorKind::file:
            return "file";
        case host::ErrorKind::machine_limit:
            return "machine_limit";
    }
    return "failed";
}

/// Sets the exception that pxm._errors makes of it.
void set_exception(const host::Error& error) {
    py::list mistakes;
    for (const host::Mistake& mistake : error.mistakes())
        mistakes.append(
            py::make_tuple(mistake.file, mistake.line, mistake.column, mistake.message));
    const py::object made = py::module_::import("pxm._errors")
                                .attr("error_of")(kind_word(error.kind()), error.what(), mistakes);
    PyErr_SetObject(py::type::of(made).ptr(), made.ptr());
}

}  // namespace

void translate_errors(py::module_&) {
    py::register_local_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const host::Error& error) {
            set_exception(error);
        }
    });
}

}  // namespace pxm::python
