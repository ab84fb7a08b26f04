// Lightmaps of solutions, and models that carry their light.
#include "aktina/radiosity/lightmap/lightmap.h"

#include "aktina/render/bake_job.h"
#include "arrays.h"
#include "fields.h"
#include "rooms.h"
#include "work.h"

namespace aktina::python {
namespace {

LightmapOptions lightmap_options(const py::dict& fields, uint32_t seed) {
  LightmapOptions o;
  FromDict field(fields, "lightmap");
  field("texel_size", o.texel_size), field("size", o.size), field("padding", o.padding), field("keep_uv", o.keep_uv);
  field("direct_samples", o.direct_samples), field("gather_samples", o.gather_samples);
  field.expect_all_read();
  o.seed = seed;
  return o;
}

struct Mapped {
  Lightmap map;
  LightmappedScene scene;
};

py::list pages_of(const std::shared_ptr<Mapped>& mapped) {
  py::list pages;
  for (const Image& page : mapped->map.irradiances)
    pages.append(array_view(mapped, page.pixels.data(), {page.height, page.width, page.channels}));
  return pages;
}

/// What stands on the pages: (instance, page, is the back, vertices, texture coordinates, triangles).
py::list meshes_of(const std::shared_ptr<Mapped>& mapped) {
  py::list meshes;
  for (size_t i = 0; i < mapped->scene.pages.size(); ++i) {
    const Instance& instance = mapped->scene.scene.instances[i];
    const Mesh& mesh = mapped->scene.scene.meshes[size_t(instance.mesh)];
    const auto vertices = py::ssize_t(mesh.positions.size()), triangles = py::ssize_t(mesh.triangles.size());
    std::vector<float> world;
    for (const Point3 p : mesh.positions)
      for (int k = 0; k < 3; ++k) world.push_back(transform_point(instance.to_world, p)[k]);
    meshes.append(py::make_tuple(mapped->scene.sources[i], mapped->scene.pages[i], bool(mapped->scene.backs[i]),
                                 array(std::move(world), {vertices, 3}),
                                 array_view(mapped, &mesh.uv[1].data()->x, {vertices, 2}),
                                 array_view(mapped, &mesh.triangles.data()->front(), {triangles, 3})));
  }
  return meshes;
}

py::tuple make(const Radiosities& r, const Scene& scene, const py::dict& fields, uint32_t seed,
               const py::object& report) {
  const LightmapOptions options = lightmap_options(fields, seed);
  const auto mapped = run(report, [&](Progress& progress) {
    auto m = std::make_shared<Mapped>();
    m->map = make_lightmap(scene, r.solution, options, &progress);
    m->scene = lightmapped_scene(scene, m->map);
    return m;
  });
  const SeamReport& seams = mapped->map.seams;
  py::list warnings;
  for (const Warnings::Item& item : mapped->map.layout.warnings.items())
    warnings.append(py::make_tuple(item.text, item.count));
  return py::make_tuple(pages_of(mapped), meshes_of(mapped), mapped->map.layout.texel_size,
                        py::make_tuple(seams.before, seams.after), warnings);
}

py::list bake(const Radiosities& r, const Scene& scene, const std::string& path, const std::string& form,
              float exposure, const py::dict& fields, uint32_t seed, const py::object& report) {
  const LightmapOptions options = lightmap_options(fields, seed);
  py::list written;
  for (const Path& file : run(report, [&](Progress& progress) {
         Radiosities copy = r;
         return Baking(scene, copy, form, exposure, options).write(path, progress);
       }))
    written.append(display(file));
  return written;
}

}  // namespace

void bind_lightmaps(py::module_& m) {
  m.def("make_lightmap", &make);
  m.def("bake", &bake);
}

}  // namespace aktina::python
