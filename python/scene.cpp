// Scenes: loaded from files or built from dictionaries, and rays through them.
#include "aktina/scene/scene.h"

#include <algorithm>

#include "aktina/base/parallel.h"
#include "aktina/import/import.h"
#include "aktina/scene/scene_lights.h"
#include "aktina/trace/radiance.h"
#include "arrays.h"
#include "camera_dict.h"
#include "fields.h"
#include "light_dict.h"
#include "material_dict.h"
#include "primitive_dict.h"
#include "rooms.h"
#include "work.h"

namespace aktina::python {
namespace {

using SceneHandle = std::shared_ptr<Scene>;

template <class T, class Item>
std::vector<T> vectors(const py::dict& dict, const char* name, int columns) {
  if (!dict.contains(name)) return {};
  const Rows<const Item> rows(py::reinterpret_borrow<py::buffer>(dict[name]), columns, name);
  const auto* first = reinterpret_cast<const T*>(rows.data());
  return {first, first + rows.size()};
}

/// Arrays of a mesh; Python has made them contiguous and of the right type.
Mesh mesh_from(const py::dict& dict) {
  Mesh mesh;
  mesh.positions = vectors<Point3, float>(dict, "vertices", 3);
  mesh.normals = vectors<Vec3, float>(dict, "normals", 3);
  mesh.uv[0] = vectors<Vec2, float>(dict, "uv", 2);
  mesh.triangles = vectors<std::array<uint32_t, 3>, uint32_t>(dict, "triangles", 3);
  for (const auto& triangle : mesh.triangles)
    for (const uint32_t vertex : triangle)
      if (vertex >= mesh.positions.size())
        throw Error(Code::bad_input, "triangles", fmt::format("name vertex {}", vertex),
                    fmt::format("there are {}", mesh.positions.size()));
  return mesh;
}

Mat4 transform_from(const py::dict& dict) {
  Mat4 m(1);
  if (!dict.contains("to_world")) return m;
  const Rows<const float> rows(py::reinterpret_borrow<py::buffer>(dict["to_world"]), 4, "to_world");
  expect_rows(rows, 4, "to_world");
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) m[column][row] = rows.row(size_t(row))[column];
  return m;
}

/// A picture of (height, width, 3) linear floats.
Image image_from(const py::buffer& pixels, const char* name) {
  const Rows<const float> rows(pixels, 3, name);
  const py::buffer_info info = pixels.request();
  if (info.ndim != 3) throw Error(Code::usage, name, "has not the shape (height, width, 3)");
  Image image(int(info.shape[1]), int(info.shape[0]), 3);
  std::copy_n(rows.data(), image.pixels.size(), image.pixels.begin());
  return image;
}

int add_image(Scene& scene, const py::buffer& pixels) {
  TextureImage texture;
  texture.pixels = image_from(pixels, "texture");
  scene.images.push_back(std::move(texture));
  return int(scene.images.size()) - 1;
}

int add_material(Scene& scene, const py::dict& dict) {
  FromDict reader(dict, "material");
  Material material = material_from(dict, reader);
  std::string filter = "bilinear";
  reader("filter", filter);
  if (filter != "bilinear" && filter != "nearest")
    throw Error(Code::usage, "material.filter", "got " + filter, "bilinear or nearest");
  reader.expect_known("texture");
  reader.expect_all_read();
  if (dict.contains("texture")) {
    material.base_texture.image = add_image(scene, py::reinterpret_borrow<py::buffer>(dict["texture"]));
    material.base_texture.filter = filter == "nearest" ? Filter::nearest : Filter::bilinear;
  }
  scene.materials.push_back(std::move(material));
  return int(scene.materials.size()) - 1;
}

void add_object(Scene& scene, const py::dict& dict) {
  Instance instance;
  instance.to_world = transform_from(dict);
  instance.material = add_material(scene, py::dict(dict["material"]));
  if (dict.contains("shape")) {
    const py::dict shape(dict["shape"]);
    std::string type;
    FromDict reader(shape, "shape");
    reader("type", type);
    scene.primitives.push_back(read_primitive(type, reader));
    reader.expect_all_read();
    instance.primitive = int(scene.primitives.size()) - 1;
  } else {
    scene.meshes.push_back(mesh_from(dict));
    instance.mesh = int(scene.meshes.size()) - 1;
  }
  scene.instances.push_back(instance);
}

/// As light_from(), with a "name" beside.
void add_light(Scene& scene, const py::dict& dict) {
  const py::dict fields = dict.attr("copy")();
  const std::string name = fields.contains("name") ? py::cast<std::string>(fields.attr("pop")("name")) : "";
  const Light light = light_from(fields);
  if (!name.empty()) scene.nodes.push_back({name});
  place_light(scene, {name, light, name.empty() ? -1 : int(scene.nodes.size()) - 1});
}

void add_camera(Scene& scene, const py::dict& dict) { scene.cameras.push_back(camera_from(dict)); }

py::list cameras(const Scene& scene) {
  py::list list;
  for (const Camera& camera : scene.cameras) list.append(camera_dict(camera));
  return list;
}

py::list warnings(const Scene& scene) {
  py::list list;
  for (const auto& item : scene.warnings.items()) list.append(py::make_tuple(item.text, item.count));
  return list;
}

py::list light_list(const Scene& scene) {
  py::list list;
  for (const PlacedLight& placed : scene.lights) list.append(light_dict(placed.light));
  return list;
}

py::object box(const Scene& scene) {
  const Bounds b = bounds(scene);
  if (b.empty()) return py::none();
  return py::make_tuple(py::make_tuple(b.low.x, b.low.y, b.low.z), py::make_tuple(b.high.x, b.high.y, b.high.z));
}

void set_surroundings(Scene& scene, const py::dict& dict) {
  FromDict reader(dict, "scene");
  reader("ambient", scene.ambient), reader("background", scene.background);
  reader("sky", scene.environment.colour);
  reader.expect_all_read();
}

/// @param picture  (H, W, 3), rows from the top: radiance, cd/m^2
void set_sky(Scene& scene, const py::buffer& picture, float rotation) {
  scene.environment = {image_from(picture, "sky"), Radiance(Rgb(1)), rotation};
}

std::vector<Ray> rays_from(const py::buffer& origins, const py::buffer& directions, float near, float far) {
  const Rows<const float> origin(origins, 3, "origins"), direction(directions, 3, "directions");
  std::vector<Ray> rays(std::max(origin.size(), direction.size()));
  for (size_t i = 0; i < rays.size(); ++i)
    rays[i] = {vec3(origin.row_or_only(i)), vec3(direction.row_or_only(i)), near, far};
  return rays;
}

constexpr size_t kGrain = 1024;

/// What is not hit has distance infinity and indices -1; its other results stay as Python has filled them.
void trace_rays(const SceneHandle& scene, const py::buffer& origins, const py::buffer& directions, float near,
                float far, const py::buffer& distance, const py::buffer& normal, const py::buffer& uv,
                const py::buffer& indices) {
  const std::vector<Ray> rays = rays_from(origins, directions, near, far);
  const Rows<float> t(distance, 1, "distance"), n(normal, 3, "normal"), parameters(uv, 2, "uv");
  const Rows<int32_t> index(indices, 2, "indices");
  const py::gil_scoped_release without_lock;
  const auto accelerator = build_accelerator(*scene);
  parallel_for(rays.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Hit hit = accelerator->intersect(rays[i]);
      *t.row(i) = hit.distance;
      if (!hit) continue;
      const Vec3 unit = normalize_or(hit.normal, Vec3(0));
      for (int k = 0; k < 3; ++k) n.row(i)[k] = unit[k];
      parameters.row(i)[0] = hit.u, parameters.row(i)[1] = hit.v;
      index.row(i)[0] = int32_t(hit.instance), index.row(i)[1] = int32_t(hit.triangle);
    }
  });
}

void radiance_along(const SceneHandle& scene, const py::buffer& origins, const py::buffer& directions,
                    const std::string& method, int samples, uint32_t seed, const py::buffer& out,
                    const py::object& progress) {
  const std::vector<Ray> rays = rays_from(origins, directions, 0, kInfinity);
  TraceOptions options;
  options.integrator = method, options.samples = samples, options.seed = seed;
  const std::vector<Radiance> light =
      run(progress, [&](Progress& p) { return trace_radiance(*scene, rays, options, &p); });
  const Rows<float> result(out, 3, "out");
  for (size_t i = 0; i < light.size(); ++i)
    for (int k = 0; k < 3; ++k) result.row(i)[k] = light[i].v[k];
}

SceneHandle load(const std::string& path, const std::string& normals, float crease, const std::string& environment,
                 double scale, double rotation) {
  const py::gil_scoped_release without_lock;
  return std::make_shared<Scene>(load_scene(path, {.normals = normals,
                                                   .crease = crease,
                                                   .environment = environment,
                                                   .environment_scale = scale,
                                                   .environment_rotation = rotation}));
}

}  // namespace

void bind_scene(py::module_& m) {
  py::class_<Scene, SceneHandle>(m, "Scene")
      .def(py::init<>())
      .def("add_object", &add_object)
      .def("add_light", &add_light)
      .def("set_sky", &set_sky)
      .def("add_camera", &add_camera)
      .def("set_surroundings", &set_surroundings)
      .def_property_readonly("triangles", &triangle_count)
      .def_property_readonly("hash", [](const Scene& scene) { return hash(scene).text(); })
      .def_property_readonly("warnings", &warnings)
      .def_property_readonly("cameras", &cameras)
      .def_property_readonly("lights", &light_list)
      .def_property_readonly("bounds", &box)
      .def("frame", [](Scene& scene) {
        if (scene.cameras.empty()) add_default_camera(scene);
      });
  m.def("load_scene", &load);
  m.def("trace", &trace_rays);
  m.def("radiance", &radiance_along);
}

}  // namespace aktina::python
