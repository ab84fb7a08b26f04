// Form factors: of polygons by any method, of simple shapes in closed form.
#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/radiosity/formfactor/closed_forms.h"
#include "aktina/radiosity/formfactor/matrix.h"
#include "arrays.h"
#include "rooms.h"
#include "work.h"

namespace aktina::python {
namespace {

Polygon read_polygon(const py::buffer& vertices, const char* name) {
  const Rows<const double> rows(vertices, 3, name);
  Polygon polygon;
  for (size_t i = 0; i < rows.size(); ++i) polygon.vertices.push_back(vec3d(rows.row(i)));
  return polygon;
}

std::vector<Polygon> polygons(const py::list& list, const char* name) {
  std::vector<Polygon> result;
  for (const py::handle& item : list) result.push_back(read_polygon(py::cast<py::buffer>(item), name));
  return result;
}

FormFactorScene scene(const py::list& surfaces, const py::list& occluders) {
  return {polygons(surfaces, "surfaces"), polygons(occluders, "occluders")};
}

void matrix(const py::list& surfaces, const py::list& occluders, const std::string& method, const py::object& report,
            const py::buffer& factors, const py::buffer& errors) {
  const FormFactorScene polygons = scene(surfaces, occluders);
  const Rows<double> f(factors, 1, "factors"), e(errors, 1, "errors");
  const FormFactorMatrix result =
      run(report, [&](Progress& progress) { return form_factor_matrix(polygons, method, &progress); });
  std::copy(result.factors.begin(), result.factors.end(), f.data());
  std::copy(result.errors.begin(), result.errors.end(), e.data());
}

/// The factor from surface 0 to surface 1.
double pair(const py::list& surfaces, const py::list& occluders, const std::string& method) {
  const auto estimator = make_method(formfactors(), "formfactor", method);
  const FormFactorScene polygons = scene(surfaces, occluders);
  return run(py::none(), [&](Progress&) {
    estimator->build(polygons);
    return estimator->row(0).factors[1];
  });
}

/// The factor from a differential area to surface 0.
double from_point(const py::buffer& point, const py::buffer& normal, const py::list& surfaces,
                  const py::list& occluders, const std::string& method) {
  const auto estimator = make_method(formfactors(), "formfactor", method);
  const FormFactorScene polygons = scene(surfaces, occluders);
  const Point3d x = vec3d(Rows<const double>(point, 3, "position").row(0));
  const Vec3d n = vec3d(Rows<const double>(normal, 3, "normal").row(0));
  return run(py::none(), [&](Progress&) {
    estimator->build(polygons);
    return estimator->row(x, n).factors[0];
  });
}

double disc(const py::buffer& point, const py::buffer& normal, const py::buffer& centre, const py::buffer& disc_normal,
            double radius) {
  const auto read = [](const py::buffer& values) { return vec3d(Rows<const double>(values, 3, "shape").row(0)); };
  return point_to_disc(read(point), read(normal), read(centre), read(disc_normal), radius);
}

}  // namespace

void bind_form_factors(py::module_& m) {
  m.def("form_factor_matrix", &matrix);
  m.def("form_factor_pair", &pair);
  m.def("form_factor_from_point", &from_point);
  m.def("polygon_area",
        [](const py::buffer& vertices) { return length(newell_normal(read_polygon(vertices, "polygon"))); });
  m.def("point_to_disc", &disc);
  m.def("point_to_sphere", &point_to_sphere);
  m.def("coaxial_discs", &coaxial_discs);
  m.def("sphere_to_inner_sphere", &sphere_to_inner_sphere);
  m.def("sphere_band", &sphere_band);
  m.def("spherical_cap", [](double half_angle) {
    const CapFactors f = spherical_cap(half_angle);
    return py::make_tuple(f.cap_cap, f.cap_base, f.base_cap);
  });
}

}  // namespace aktina::python
