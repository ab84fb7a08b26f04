// Lights: what arrives at points, and the factors that light is made of.
#include <cmath>

#include "aktina/base/parallel.h"
#include "arrays.h"
#include "fields.h"
#include "light_dict.h"
#include "rooms.h"

namespace aktina::python {
namespace {

template <class Visitor>
void fields_of(Attenuation& a, Visitor& field) {
  Vec3 coefficients(a.a0, a.a1, a.a2);
  field("attenuation", coefficients);
  field("clamp", a.clamp);
  a.a0 = coefficients.x, a.a1 = coefficients.y, a.a2 = coefficients.z;
}
template <class Visitor>
void fields_of(PointLight& light, Visitor& field) {
  field("position", light.position);
  field("intensity", light.intensity);
  fields_of(light.attenuation, field);
}
template <class Visitor>
void fields_of(SpotLight& light, Visitor& field) {
  field("position", light.position);
  field("direction", light.direction);
  field("intensity", light.intensity);
  field("inner_angle", light.inner_angle);
  field("outer_angle", light.outer_angle);
  field("exponent", light.exponent);
  fields_of(light.attenuation, field);
}
template <class Visitor>
void fields_of(DirectionalLight& light, Visitor& field) {
  field("direction", light.direction);
  field("illuminance", light.e_perp);
}
template <class Visitor>
void fields_of(WarnLight& light, Visitor& field) {
  field("position", light.position);
  field("direction", light.direction);
  field("intensity", light.intensity);
  field("exponent", light.exponent);
  field("cone_angle", light.cone_angle);
  field("flap_low", light.flap_low);
  field("flap_high", light.flap_high);
  fields_of(light.attenuation, field);
}
template <class Visitor>
void fields_of(RectangleLight& light, Visitor& field) {
  field("corner", light.corner);
  field("edge_u", light.edge_u);
  field("edge_v", light.edge_v);
  field("radiance", light.radiance);
  field("both_sides", light.both_sides);
}
template <class Visitor>
void fields_of(DiscLight& light, Visitor& field) {
  field("position", light.position);
  field("direction", light.direction);
  field("radius", light.radius);
  field("radiance", light.radiance);
  field("both_sides", light.both_sides);
}
/// Its table is spread out: angles "c" and "gamma" in degrees, "candela" of each, plane by plane.
template <class Visitor>
void fields_of(LuminaireLight& light, Visitor& field) {
  PhotometricTable table = light.table ? *light.table : PhotometricTable{{0}, {0, 180}, {1, 1}};
  field("position", light.position);
  field("direction", light.direction);
  field("c0", light.c0);
  field("colour", light.colour);
  if constexpr (std::is_same_v<Visitor, FromDict>) table = {};
  field("c", table.c);
  field("gamma", table.gamma);
  field("candela", table.candela);
  if (table.candela.empty()) return;
  check(table);
  light.table = std::make_shared<const PhotometricTable>(std::move(table));
}

/// Refuses what is no light: values below 0, no attenuation at all, no size.
struct LightCheck {
  template <class Tag>
  void operator()(const char* name, const Quantity<Tag>& value) const {
    (*this)(name, value.v);
  }
  void operator()(const char* name, const Rgb& value) const {
    if (min_channel(value) < 0) fail(name, "has a value below 0");
  }
  void operator()(const char* name, const Vec3& value) const {
    if (std::string_view(name) != "attenuation") return;
    if (!(value.x >= 0 && value.y >= 0 && value.z >= 0 && value != Vec3(0)))
      fail(name, "should be three numbers not below 0, not all of them 0");
  }
  void operator()(const char* name, float value) const {
    if (std::string_view(name) == "radius" && !(value > 0)) fail(name, "should be above 0");
  }
  template <class T>
  void operator()(const char* /*name*/, const T& /*value*/) const {}

  [[noreturn]] static void fail(const char* name, const char* what) {
    throw Error(Code::bad_param, std::string("light.") + name, what);
  }
};

void normalize_direction(PointLight& /*light*/) {}
void normalize_direction(RectangleLight& /*light*/) {}
template <class L>
void normalize_direction(L& light) {
  light.direction = normalize_or(light.direction, Vec3(0));
  if (light.direction == Vec3(0)) throw Error(Code::bad_param, "light.direction", "has no length");
  if constexpr (std::is_same_v<L, LuminaireLight>) {
    light.c0 = normalize_or(light.c0 - dot(light.c0, light.direction) * light.direction, Vec3(0));
    if (light.c0 == Vec3(0)) throw Error(Code::bad_param, "light.c0", "does not point across the direction");
  }
}

/// The row of lights() whose product is the alternative that `light` holds.
std::string_view type_of(const Light& light) {
  for (const Method<Light>* row : lights())
    if (row->make(ParamSet(row->info)).index() == light.index()) return row->info.id;
  throw std::logic_error("a light without a row");
}

void irradiance(const py::dict& light_fields, const py::buffer& points, const py::buffer& normals,
                const py::buffer& out) {
  const Light light = light_from(light_fields);
  const Rows<const float> point(points, 3, "points"), normal(normals, 3, "normals");
  const Rows<float> result(out, 3, "out");
  for (size_t i = 0; i < result.size(); ++i) {
    const LightSample s = sample(light, vec3(point.row_or_only(i)));
    const Rgb e = s.e_perp.v * std::max(0.0f, dot(s.wi, vec3(normal.row_or_only(i))));
    for (int k = 0; k < 3; ++k) result.row(i)[k] = e[k];
  }
}

void spot_falloff_of(float inner, float outer, float exponent, const py::buffer& cosines, const py::buffer& out) {
  SpotLight light;
  light.inner_angle = inner, light.outer_angle = outer, light.exponent = exponent;
  const Rows<const float> cosine(cosines, 1, "cosine");
  const Rows<float> result(out, 1, "out");
  expect_rows(cosine, result.size(), "cosine");
  for (size_t i = 0; i < result.size(); ++i) *result.row(i) = spot_falloff(light, *cosine.row(i));
}

void attenuation(float a0, float a1, float a2, bool clamp, const py::buffer& distances, const py::buffer& out) {
  const Attenuation coefficients{a0, a1, a2, clamp};
  const Rows<const float> distance(distances, 1, "distance");
  const Rows<float> result(out, 1, "out");
  expect_rows(distance, result.size(), "distance");
  for (size_t i = 0; i < result.size(); ++i) *result.row(i) = attenuate(coefficients, *distance.row(i));
}

void depth_cue_of(float k1, float k2, const py::buffer& distances, const py::buffer& out) {
  const Rows<const float> distance(distances, 1, "distance");
  const Rows<float> result(out, 1, "out");
  expect_rows(distance, result.size(), "distance");
  for (size_t i = 0; i < result.size(); ++i) *result.row(i) = depth_cue(k1, k2, *distance.row(i));
}

}  // namespace

Light light_from(const py::dict& dict) {
  std::string type = "point";
  FromDict reader(dict, "light");
  reader("type", type);
  Light light = make_method(lights(), "light", type);
  std::visit(
      [&](auto& l) {
        fields_of(l, reader);
        LightCheck check;
        fields_of(l, check);
        normalize_direction(l);
      },
      light);
  reader.expect_all_read();
  return light;
}

py::dict light_dict(const Light& light) {
  ToDict writer;
  writer("type", type_of(light));
  std::visit([&](auto l) { fields_of(l, writer); }, light);
  return writer.dict();
}

void bind_lights(py::module_& m) {
  m.def("irradiance", &irradiance);
  m.def("spot_falloff", &spot_falloff_of);
  m.def("attenuation", &attenuation);
  m.def("depth_cue", &depth_cue_of);
}

}  // namespace aktina::python
