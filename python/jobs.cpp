// Pictures of scenes, and the light on their surfaces.
#include "aktina/radiosity/error_estimate.h"
#include "aktina/render/job.h"
#include "aktina/render/picture_view.h"
#include "aktina/trace/illuminance.h"
#include "arrays.h"
#include "camera_dict.h"
#include "rooms.h"
#include "work.h"

namespace aktina::python {
namespace {

/// A view of the caller's own, or the number of one of the scene's cameras.
struct View {
  Camera own;
  bool given = false;
  int number = 0;
  explicit View(const py::object& camera) {
    given = py::isinstance<py::dict>(camera);
    if (given)
      own = camera_from(py::cast<py::dict>(camera));
    else
      number = py::cast<int>(camera);
  }
};

RadiosityOptions radiosity_options(const py::dict& fields, const Scene& scene) {
  RadiosityOptions o;
  int most_steps = 0, most_patches = int(o.most_patches);
  FromDict field(fields, "radiosity");
  field("solver", o.solver), field("formfactor", o.formfactor), field("mesher", o.mesher), field("quality", o.quality);
  field("patch_size", o.patch_size), field("tolerance", o.tolerance), field("target_error", o.target_error);
  field("indirect_size", o.indirect_size);
  field("most_steps", most_steps), field("most_patches", most_patches);
  std::string checkpoint;
  field("checkpoint", checkpoint), field("every", o.checkpoint.seconds), field("resume", o.checkpoint.resume);
  o.checkpoint.file = checkpoint;
  field.expect_known("importance");
  if (fields.contains("importance") && !fields["importance"].is_none()) {
    const View view(fields["importance"]);
    o.importance = view.given ? view.own : chosen_camera(scene, view.number);
  }
  o.most_steps = uint64_t(std::max(most_steps, 0)), o.most_patches = uint64_t(std::max(most_patches, 0));
  field.expect_all_read();
  return o;
}

RenderOptions render_options(const py::dict& fields, const View& view) {
  RenderOptions o;
  FromDict field(fields, "render");
  field("method", o.method), field("shading", o.shading), field("illumination", o.illumination);
  field("k1", o.depth_cue.k1), field("k2", o.depth_cue.k2);
  field("width", o.width), field("height", o.height), field("samples", o.samples), field("layers", o.layers);
  field.expect_all_read();
  o.camera = view.number, o.view = view.given ? &view.own : nullptr;
  return o;
}

Array pixels_of(Image&& image) {
  const std::vector<py::ssize_t> shape = {image.height, image.width, image.channels};
  return array(std::move(image.pixels), shape);
}

/// [(layer, array)]
py::list render_scene(const Scene& scene, const py::dict& fields, const py::object& camera, const py::dict& radiosity,
                      uint32_t seed, const py::object& report) {
  const View view(camera);
  RenderOptions options = render_options(fields, view);
  options.radiosity = radiosity_options(radiosity, scene), options.seed = seed;
  Rendering rendering = run(report, [&](Progress& progress) { return render(scene, options, progress); });
  py::list layers;
  for (LayeredImage::Layer& layer : rendering.picture.layers)
    layers.append(py::make_tuple(layer.name, pixels_of(std::move(layer.image))));
  return layers;
}

using Result = std::shared_ptr<Radiosities>;

Result solve_scene(const Scene& scene, const py::dict& fields, uint32_t seed, const py::object& report) {
  RadiosityOptions options = radiosity_options(fields, scene);
  options.seed = seed;
  return run(report,
             [&](Progress& progress) { return std::make_shared<Radiosities>(solve(scene, options, progress)); });
}

/// {name: Radiosities}
py::dict solve_lights_of(const Scene& scene, const py::dict& fields, uint32_t seed, const py::object& report) {
  RadiosityOptions options = radiosity_options(fields, scene);
  options.seed = seed;
  std::vector<LightRadiosities> lights =
      run(report, [&](Progress& progress) { return solve_lights(scene, options, progress); });
  py::dict results;
  for (LightRadiosities& each : lights)
    results[py::str(each.light)] = std::make_shared<Radiosities>(std::move(each.result));
  return results;
}

/// @param lights  [(name, Radiosities, factor)]
Result mix_lights(const py::list& lights) {
  std::vector<DimmedLight> all;
  for (const py::handle& each : lights) {
    const auto [name, result, factor] = py::cast<std::tuple<std::string, Result, double>>(each);
    all.push_back({name, result.get(), factor});
  }
  const py::gil_scoped_release release;
  return std::make_shared<Radiosities>(mix(all));
}

Result load(const Scene& scene, const std::string& path) {
  auto result = std::make_shared<Radiosities>();
  result->solution = load_solution(path);
  if (result->solution.scene_hash != hash(scene).text())
    throw Error(Code::bad_input, path, "is a solution of another scene");
  result->report.settings = result->solution.settings, result->report.seed = result->solution.seed;
  result->report.scene_hash = result->solution.scene_hash;
  return result;
}

template <class T>
Array triples(const Result& owner, const std::vector<T>& values) {
  static_assert(sizeof(T) == 3 * sizeof(float));
  return array_view(owner, reinterpret_cast<const float*>(values.data()), {py::ssize_t(values.size()), 3});
}

/// The arrays of a solution by name, read in place.
py::dict solution_arrays(const Result& r) {
  const Solution& s = r->solution;
  const auto n = py::ssize_t(s.mesh.size());
  py::dict d;
  d["vertices"] = triples(r, s.mesh.positions), d["vertex_normals"] = triples(r, s.mesh.normals);
  d["patches"] = array_view(r, &s.mesh.patches.data()->front(), {n, 4});
  d["areas"] = array_view(r, s.mesh.areas.data(), {n});
  d["normals"] = triples(r, s.mesh.patch_normals), d["reflectances"] = triples(r, s.mesh.reflectances);
  d["emissions"] = triples(r, s.mesh.emissions);
  d["irradiances"] = triples(r, s.irradiances), d["radiosities"] = triples(r, s.radiosities);
  d["illuminance_errors"] = array(patch_errors(s), std::vector<py::ssize_t>{n});
  d["vertex_irradiances"] = triples(r, s.vertex_irradiances);
  d["vertex_radiosities"] = triples(r, s.vertex_radiosities);
  return d;
}

py::dict solution_facts(const Radiosities& r) {
  const Solution& s = r.solution;
  py::dict d;
  d["steps"] = s.steps, d["unshot"] = s.unshot, d["converged"] = s.converged;
  d["emitted"] = s.emitted, d["absorbed"] = s.absorbed, d["escaped"] = s.escaped;
  return d;
}

Array draw_solution(const Radiosities& r, const Scene& scene, const py::object& camera, const std::string& two_pass,
                    int width, int height, int samples, uint32_t seed, const py::object& report) {
  const View view(camera);
  if (!view.given && (view.number < 0 || size_t(view.number) >= scene.cameras.size()))
    throw Error(Code::usage, "camera", fmt::format("there is no camera {}", view.number));
  const Camera& eye = view.given ? view.own : scene.cameras[size_t(view.number)];
  LayeredImage picture = run(report, [&](Progress& progress) {
    if (two_pass.empty()) return render_solution(scene, r.solution, eye, width, height, samples, &progress);
    return render_two_pass(scene, r.solution, eye, width, height,
                           {.method = two_pass, .samples = samples, .seed = seed, .each_pass = {}}, &progress);
  });
  return pixels_of(std::move(picture.layers[0].image));
}

void illuminance_at(const Scene& scene, const py::buffer& points, const py::buffer& normals, const std::string& method,
                    int samples, uint32_t seed, const py::object& report, const py::buffer& out) {
  const Rows<const float> point(points, 3, "points"), normal(normals, 3, "normals");
  const Rows<float> result(out, 3, "out");
  std::vector<Point3> x(result.size());
  std::vector<Vec3> n(result.size());
  for (size_t i = 0; i < x.size(); ++i) x[i] = vec3(point.row_or_only(i)), n[i] = vec3(normal.row_or_only(i));
  TraceOptions options;
  options.integrator = method, options.samples = samples, options.seed = seed;
  const auto light = run(report, [&](Progress& p) { return illuminance(scene, x, n, options, &p); });
  for (size_t i = 0; i < x.size(); ++i)
    for (int k = 0; k < 3; ++k) result.row(i)[k] = light[i].v[k];
}

}  // namespace

void bind_jobs(py::module_& m) {
  py::class_<Radiosities, Result>(m, "Radiosities");
  m.def("render", &render_scene);
  m.def("solve_scene", &solve_scene);
  m.def("solve_lights", &solve_lights_of);
  m.def("mix", &mix_lights);
  m.def("load_solution", &load);
  m.def("solution_arrays", &solution_arrays);
  m.def("solution_facts", &solution_facts);
  m.def("draw_solution", &draw_solution);
  m.def("write_solution", [](const Radiosities& r, const Scene& scene, const std::string& path) {
    const py::gil_scoped_release without_lock;
    write_radiosities(path, scene, r);
  });
  m.def("illuminance", &illuminance_at);
}

}  // namespace aktina::python
