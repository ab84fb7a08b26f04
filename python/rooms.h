// What each file binds, called once by core.cpp.
#pragma once

#include <pybind11/pybind11.h>

namespace aktina::python {

namespace py = pybind11;

void bind_errors(py::module_& m);
void bind_form_factors(py::module_& m);
void bind_view_factors(py::module_& m);
void bind_geometry(py::module_& m);
void bind_illumination(py::module_& m);
void bind_images(py::module_& m);
void bind_lights(py::module_& m);
void bind_scene(py::module_& m);
void bind_shading(py::module_& m);
void bind_jobs(py::module_& m);
void bind_lightmaps(py::module_& m);
void bind_study(py::module_& m);
void bind_catalogue(py::module_& m);
void bind_radiosity(py::module_& m);

}  // namespace aktina::python
