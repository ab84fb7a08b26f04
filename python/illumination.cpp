// Illumination models and lights: batches of samples.
#include <algorithm>

#include "aktina/base/parallel.h"
#include "aktina/illumination/energy.h"
#include "aktina/illumination/facets.h"
#include "aktina/illumination/light/light.h"
#include "aktina/illumination/model.h"
#include "arrays.h"
#include "rooms.h"
#include "surface_row.h"

namespace aktina::python {
namespace {

constexpr size_t kGrain = 4096;  // samples a piece

/// [(name, default values)]
py::list surface_fields() {
  const Surface s;
  py::list fields;
  for (const SurfaceField& field : kSurfaceFields) {
    py::list values;
    if (field.colour)
      for (int k = 0; k < 3; ++k) values.append((s.*field.colour)[k]);
    else
      values.append(s.*field.number);
    fields.append(py::make_tuple(field.name, values));
  }
  return fields;
}

using Input = Rows<const float>;

void illuminate(const std::string& choice, const py::buffer& surfaces, const py::buffer& n, const py::buffer& l,
                const py::buffer& v, const py::buffer& light, const py::buffer& ambient, const py::buffer& out) {
  const IlluminationModel model = make_method(illumination_models(), "illumination", choice);
  const Input material(surfaces, surface_row_size(), "material"), normal(n, 3, "n"), wi(l, 3, "l"), wo(v, 3, "v"),
      colour(light, 3, "light"), around(ambient, 3, "ambient");
  const Rows<float> result(out, 3, "out");
  const py::gil_scoped_release without_lock;
  parallel_for(result.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Surface s = surface(material.row_or_only(i));
      const Rgb radiance = s.ka * rgb(around.row_or_only(i)) +
                           classic_radiance(model, s, vec3(normal.row_or_only(i)), vec3(wi.row_or_only(i)),
                                            vec3(wo.row_or_only(i)), rgb(colour.row_or_only(i)));
      for (int k = 0; k < 3; ++k) result.row(i)[k] = radiance[k];
    }
  });
}

using Albedo = Rgb (*)(const IlluminationModel&, const Surface&, float);

template <Albedo function>
void albedo_of(const std::string& choice, const py::buffer& surfaces, const py::buffer& cosines,
               const py::buffer& out) {
  const IlluminationModel model = make_method(illumination_models(), "illumination", choice);
  const Input material(surfaces, surface_row_size(), "material"), cosine(cosines, 1, "cosine");
  const Rows<float> result(out, 3, "out");
  const py::gil_scoped_release without_lock;
  parallel_for(result.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Rgb a = function(model, surface(material.row_or_only(i)), *cosine.row_or_only(i));
      for (int k = 0; k < 3; ++k) result.row(i)[k] = a[k];
    }
  });
}

py::tuple reciprocity_of(const std::string& choice, const py::buffer& surfaces) {
  const IlluminationModel model = make_method(illumination_models(), "illumination", choice);
  const Input material(surfaces, surface_row_size(), "material");
  const Reciprocity r = reciprocity_error(model, surface(material.row(0)));
  return py::make_tuple(r.error, py::make_tuple(r.a.x, r.a.y, r.a.z), py::make_tuple(r.b.x, r.b.y, r.b.z));
}

/// One number of the theory of facets for each angle or direction.
void facet_distribution(const std::string& name, const py::buffer& angles, float width, const py::buffer& out) {
  using Distribution = float (*)(float, float);
  constexpr std::pair<std::string_view, Distribution> kDistributions[] = {{"phong", facet_phong},
                                                                          {"gaussian", facet_gaussian},
                                                                          {"trowbridge_reitz", facet_trowbridge_reitz},
                                                                          {"beckmann", facet_beckmann}};
  const auto* found = std::find_if(std::begin(kDistributions), std::end(kDistributions),
                                   [&](const auto& row) { return row.first == name; });
  if (found == std::end(kDistributions))
    no_such_method("facet distribution", name, "phong, gaussian, trowbridge_reitz, beckmann");
  const Input angle(angles, 1, "alpha");
  const Rows<float> result(out, 1, "out");
  for (size_t i = 0; i < result.size(); ++i) *result.row(i) = found->second(*angle.row(i), width);
}

void schlick_power_of(const py::buffer& cosines, const py::buffer& exponents, const py::buffer& out) {
  const Input t(cosines, 1, "t"), n(exponents, 1, "exponent");
  const Rows<float> result(out, 1, "out");
  for (size_t i = 0; i < result.size(); ++i) *result.row(i) = schlick_power(*t.row(i), *n.row(i));
}

void groove_masking_of(const py::buffer& n, const py::buffer& l, const py::buffer& v, const py::buffer& out) {
  const Input normal(n, 3, "n"), wi(l, 3, "l"), wo(v, 3, "v");
  const Rows<float> result(out, 1, "out");
  for (size_t i = 0; i < result.size(); ++i)
    *result.row(i) = groove_masking(vec3(normal.row_or_only(i)), vec3(wi.row_or_only(i)), vec3(wo.row_or_only(i)));
}

void fresnel_of(const py::buffer& cosines, float eta, const py::buffer& out) {
  const Input cosine(cosines, 1, "cosine");
  const Rows<float> result(out, 1, "out");
  for (size_t i = 0; i < result.size(); ++i) *result.row(i) = fresnel_dielectric(*cosine.row(i), eta);
}

}  // namespace

void bind_illumination(py::module_& m) {
  m.def("surface_fields", &surface_fields);
  m.def("illuminate", &illuminate);
  m.def("albedo", &albedo_of<albedo>);
  m.def("reflected_share", &albedo_of<reflected_share>);
  m.def("reciprocity", &reciprocity_of);
  m.def("facet_distribution", &facet_distribution);
  m.def("schlick_power", &schlick_power_of);
  m.def("groove_masking", &groove_masking_of);
  m.def("fresnel", &fresnel_of);
}

}  // namespace aktina::python
