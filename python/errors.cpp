// aktina::Error -> the classes of python/aktina/_errors.py, which are made from the table in base/error.cpp.
#include <pybind11/pybind11.h>

#include "aktina/base/error.h"
#include "rooms.h"

namespace aktina::python {
namespace {

py::list error_classes() {
  py::list rows;
  for (int i = 0; i <= int(Code::cancelled); ++i) {
    const CodeInfo& row = info(Code(i));
    rows.append(py::make_tuple(row.name, row.python_class));
  }
  return rows;
}

void raise(const Error& error) {
  const py::object type = py::module_::import("aktina._errors").attr(py::str(info(error.code()).python_class));
  const py::object value = type(error.message(), error.where(), error.hint());
  PyErr_SetObject(type.ptr(), value.ptr());
}

}  // namespace

void bind_errors(py::module_& m) {
  m.def("error_classes", &error_classes);
  py::register_exception_translator([](std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param)
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace aktina::python
