// Shading interpolation on single triangles.
#include "aktina/raster/shading/shade_triangle.h"
#include "arrays.h"
#include "fields.h"
#include "light_dict.h"
#include "rooms.h"
#include "surface_row.h"

namespace aktina::python {
namespace {

using Input = Rows<const float>;

std::vector<Light> lights_from(const py::list& dicts) {
  std::vector<Light> lights;
  for (const py::handle& dict : dicts) lights.push_back(light_from(py::cast<py::dict>(dict)));
  return lights;
}

/// @param corners  three rows of position, normal, screen and weight (9 numbers)
void interpolate(const std::string& method, const std::string& model, const py::buffer& surface_row,
                 const py::list& light_dicts, const py::buffer& ambient, const py::buffer& viewer, bool distant,
                 const py::buffer& corners, const py::buffer& barycentric, const py::buffer& out) {
  const Input rows(corners, 9, "corners"), points(barycentric, 3, "barycentric");
  const Rows<float> result(out, 3, "out");
  expect_rows(result, points.size(), "out");
  ShadedTriangle t;
  for (size_t v = 0; v < 3; ++v) {
    const float* row = rows.row(v);
    t.position[v] = vec3(row), t.normal[v] = vec3(row + 3);
    t.screen[v] = {row[6], row[7]}, t.weight[v] = row[8];
  }
  const std::vector<Light> lights = lights_from(light_dicts);
  const Illuminator light(make_method(illumination_models(), "illumination", model),
                          surface(Input(surface_row, surface_row_size(), "material").row(0)), lights,
                          rgb(Input(ambient, 3, "ambient").row(0)), {vec3(Input(viewer, 3, "viewer").row(0)), distant});
  std::vector<Vec3> at;
  for (size_t i = 0; i < points.size(); ++i) at.push_back(vec3(points.row(i)));
  const auto lit = shade(*make_method(shading_methods(), "shading", method), light, t, at);
  for (size_t i = 0; i < lit.size(); ++i)
    for (int k = 0; k < 3; ++k) result.row(i)[k] = lit[i].total()[k];
}

void lagrange_weights(int degree, const py::buffer& barycentric, const py::buffer& out) {
  const Input points(barycentric, 3, "barycentric");
  const auto count = lattice(degree).size();
  const Rows<float> result(out, py::ssize_t(count), "out");
  for (size_t i = 0; i < points.size(); ++i) lagrange(degree, vec3(points.row(i)), std::span(result.row(i), count));
}

}  // namespace

void bind_shading(py::module_& m) {
  m.def("interpolate", &interpolate);
  m.def("lagrange", &lagrange_weights);
}

}  // namespace aktina::python
