// View-factor matrices of scenes.
#include <memory>

#include "aktina/base/error.h"
#include "aktina/radiosity/viewfactor/gray_body.h"
#include "aktina/render/view_factor_job.h"
#include "arrays.h"
#include "rooms.h"
#include "work.h"

namespace aktina::python {
namespace {

SurfacesBy surfaces_by(const std::string& word) {
  if (word == "face") return SurfacesBy::face;
  if (word == "object") return SurfacesBy::object;
  if (word == "material") return SurfacesBy::material;
  throw Error(Code::usage, "by", "got '" + word + "'", "face, object or material");
}

/// The matrix; its arrays are read in place.
struct ViewFactorArrays {
  std::shared_ptr<const ViewFactors> factors;
  std::string certificate;

  template <class Values>
  Array of(const Values& values) const {
    return array_view<typename Values::value_type>(factors, values.data(), {py::ssize_t(values.size())});
  }
};

ViewFactorArrays compute(const ViewFactorScene& surfaces, double target_error, bool repair, double max_memory,
                         const std::string& scratch, const py::object& report) {
  return run(report, [&](Progress& progress) {
    ViewFactorJob job;
    job.options.target_error = target_error, job.repair = repair;
    job.options.most_bytes = uint64_t(max_memory * 1e9), job.options.scratch = scratch;
    ViewFactorResult result = view_factors(surfaces, job, progress);
    std::string certificate = certificate_json(result);
    return ViewFactorArrays{std::make_shared<const ViewFactors>(std::move(result.factors)), std::move(certificate)};
  });
}

std::vector<GrayBody> gray_bodies(const Rows<const double>& emissivities, const Rows<const double>& temperatures,
                                  const Rows<const double>& fluxes) {
  std::vector<GrayBody> bodies;
  for (size_t i = 0; i < emissivities.size(); ++i)
    bodies.push_back({*emissivities.row(i), *temperatures.row(i), *fluxes.row(i)});
  return bodies;
}

/// Values of one kind; the array keeps them.
Array owned(std::vector<double> values) {
  const auto kept = std::make_shared<const std::vector<double>>(std::move(values));
  return array_view<double>(kept, kept->data(), {py::ssize_t(kept->size())});
}

py::dict exchange(const ViewFactorArrays& arrays, const py::buffer& emissivities, const py::buffer& temperatures,
                  const py::buffer& fluxes) {
  const std::vector<GrayBody> bodies =
      gray_bodies({emissivities, 1, "emissivity"}, {temperatures, 1, "temperature"}, {fluxes, 1, "flux"});
  GrayExchange found = run(py::none(), [&](Progress&) { return gray_exchange(*arrays.factors, bodies); });
  py::dict result;
  result["gebhart"] = owned(std::move(found.gebhart));
  result["script_F"] = owned(std::move(found.script_f));
  result["escaped"] = owned(std::move(found.escaped));
  return result;
}

py::dict balance(const ViewFactorArrays& arrays, const py::buffer& emissivities, const py::buffer& temperatures,
                 const py::buffer& fluxes, double surroundings) {
  const std::vector<GrayBody> bodies =
      gray_bodies({emissivities, 1, "emissivity"}, {temperatures, 1, "temperature"}, {fluxes, 1, "flux"});
  GrayBalance found = run(py::none(), [&](Progress&) { return gray_balance(*arrays.factors, bodies, surroundings); });
  py::dict result;
  result["temperatures"] = owned(std::move(found.temperatures));
  result["radiosities"] = owned(std::move(found.radiosities));
  result["fluxes"] = owned(std::move(found.fluxes));
  result["net"] = found.net;
  return result;
}

}  // namespace

void bind_view_factors(py::module_& m) {
  py::class_<ViewFactorScene>(m, "ViewFactorScene");
  using A = ViewFactorArrays;
  py::class_<A>(m, "ViewFactorArrays")
      .def_property_readonly("names",
                             [](const A& a) {
                               py::list names;
                               for (const std::string& name : a.factors->names) names.append(py::str(name));
                               return names;
                             })
      .def_readonly("certificate", &A::certificate)
      .def_property_readonly("areas", [](const A& a) { return a.of(a.factors->areas); })
      .def_property_readonly("indptr", [](const A& a) { return a.of(a.factors->starts); })
      .def_property_readonly("indices", [](const A& a) { return a.of(a.factors->columns); })
      .def_property_readonly("data", [](const A& a) { return a.of(a.factors->factors); })
      .def("gray_exchange", &exchange)
      .def("gray_balance", &balance)
      .def_property_readonly("transmittances", [](const A& a) { return a.of(a.factors->transmittances); })
      .def_property_readonly("errors", [](const A& a) { return a.of(a.factors->errors); });
  m.def("surfaces_of_scene", [](const Scene& scene, const std::string& by, bool backs, bool clear) {
    return surfaces_of(scene, surfaces_by(by), backs ? Backs::see : Backs::hide, clear ? Clear::pass : Clear::hide);
  });
  m.def("surfaces_of_file", [](const std::string& path, const std::string& by, bool backs, bool clear) {
    return load_view_factor_scene(path, surfaces_by(by), backs ? Backs::see : Backs::hide,
                                  clear ? Clear::pass : Clear::hide);
  });
  m.def("view_factors", &compute);
}

}  // namespace aktina::python
