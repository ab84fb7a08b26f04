// Shading interpolation on single triangles, and what methods on scanlines are made of.
#include "aktina/base/error.h"
#include "aktina/raster/shading/fast_phong.h"
#include "aktina/raster/shading/lin.h"
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

void slerp_rows(const py::buffer& a, const py::buffer& b, const py::buffer& t, const py::buffer& out) {
  const Input from(a, 3, "a"), to(b, 3, "b"), at(t, 1, "t");
  const Rows<float> result(out, 3, "out");
  for (size_t i = 0; i < result.size(); ++i) {
    const Vec3 n = slerp(vec3(from.row(i)), vec3(to.row(i)), at.row(i)[0]);
    for (int k = 0; k < 3; ++k) result.row(i)[k] = n[k];
  }
}

void arc_angles(const py::buffer& a, const py::buffer& b, const py::buffer& out) {
  const Input from(a, 3, "a"), to(b, 3, "b");
  const Rows<float> result(out, 1, "out");
  for (size_t i = 0; i < result.size(); ++i) result.row(i)[0] = Arc(vec3(from.row(i)), vec3(to.row(i))).angle;
}

float at(const Quadratics& q, float t) {
  const float(&c)[3] = t >= q.split ? q.right : q.left;
  return c[0] + t * (c[1] + t * c[2]);
}

float at(const Waves& w, float t) {
  float sum = 0;
  for (int k = 0; k < 2; ++k) sum += w.cosine[k] * std::cos(w.turn[k] * t) + w.sine[k] * std::sin(w.turn[k] * t);
  return sum;
}

/// @param ends  rows: p and q at the left end, p and q at the right end
void interpolate_cosine(const std::string& method, const py::buffer& ends, float steps, const py::buffer& t,
                        const py::buffer& out) {
  const Input rows(ends, 3, "ends"), points(t, 1, "t");
  const Rows<float> result(out, 1, "out");
  const TurningPair pair{{vec3(rows.row(0)), vec3(rows.row(2))}, {vec3(rows.row(1)), vec3(rows.row(3))}};
  const auto fill = [&](const auto& curve) {
    for (size_t i = 0; i < points.size(); ++i) result.row(i)[0] = at(curve, points.row(i)[0]);
  };
  if (method == "angular") return fill(turning_cosine(pair));
  if (method == "angular_decomposed") return fill(decomposed_cosine(pair));
  if (method == "angular_combined") return fill(CombinedPair(pair).cosine());
  if (method == "euler")
    return fill(steps > 0 ? plain_euler_curve(EulerSlopes(pair), steps) : euler_curve(EulerSlopes(pair)));
  if (method == "lin") {
    const auto peak = span_peak(CombinedPair(pair));
    return fill(peak ? peak_curve(*peak) : euler_curve(EulerSlopes(pair)));
  }
  no_such_method("cosine", method, "angular, angular_decomposed, angular_combined, euler, lin");
}

void fast_phong_series(const py::buffer& screen, const py::buffer& normals, const py::buffer& light,
                       const py::buffer& out) {
  const Input corners(screen, 2, "screen"), n(normals, 3, "normals");
  const Rows<double> result(out, 6, "out");
  const Vec2 at[3] = {{corners.row(0)[0], corners.row(0)[1]},
                      {corners.row(1)[0], corners.row(1)[1]},
                      {corners.row(2)[0], corners.row(2)[1]}};
  const Vec3 values[3] = {vec3(n.row(0)), vec3(n.row(1)), vec3(n.row(2))};
  const Vec2 e1 = at[1] - at[0], e2 = at[2] - at[0];
  if (e1.x * e2.y == e1.y * e2.x)
    throw Error(Code::bad_param, "screen", "the triangle has no area", "three corners that are not on a line");
  const Vec3 l = vec3(Input(light, 3, "l").row(0));
  const auto terms = bishop_weimer_terms(linear_vector(at, values), Vec3d(l));
  for (size_t k = 0; k < 6; ++k) result.row(0)[k] = terms[k];
}

}  // namespace

void bind_shading(py::module_& m) {
  m.def("interpolate", &interpolate);
  m.def("lagrange", &lagrange_weights);
  m.def("slerp", &slerp_rows);
  m.def("arc_angle", &arc_angles);
  m.def("interpolate_cosine", &interpolate_cosine);
  m.def("fast_phong_series", &fast_phong_series);
}

}  // namespace aktina::python
