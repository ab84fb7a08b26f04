#include "aktina/render/info.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "aktina/image/file_format.h"
#include "aktina/import/luminaire/luminaire.h"
#include "aktina/radiosity/mesher/leaks.h"
#include "aktina/scene/scene_lights.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

using Json = nlohmann::ordered_json;

constexpr float kSmallest = 0.01f, kLargest = 1000;  // m; scenes beyond are suspected of wrong units

std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json vector(Vec3 v) { return {v.x, v.y, v.z}; }

std::string size_text(double bytes) {
  return bytes < 1e6   ? fmt::format("{:.0f} kB", bytes / 1e3)
         : bytes < 1e9 ? fmt::format("{:.1f} MB", bytes / 1e6)
                       : fmt::format("{:.1f} GB", bytes / 1e9);
}

/// Light by light, then what shines otherwise.
Json lights_json(const Scene& scene) {
  Json list = Json::array();
  for (const PlacedLight& placed : scene.lights) {
    const std::string_view type = lights()[placed.light.index()]->info.id;
    Json light = {{"name", placed.name}, {"type", type}};
    if (const auto total = flux(placed.light)) light["flux_lm"] = luminance(total->v);
    if (const auto* sun = std::get_if<DirectionalLight>(&placed.light))
      light["illuminance_lx"] = luminance(sun->e_perp.v);
    list.push_back(std::move(light));
  }
  return list;
}

Json check_json(const MeshCheck& c) {
  Json json = {{"triangles", c.triangles},
               {"closed", c.closed()},
               {"pieces", c.pieces},
               {"area_m2", c.area},
               {"degenerate_triangles", c.degenerate},
               {"duplicate_triangles", c.duplicate},
               {"boundary_edges", c.boundary_edges},
               {"non_manifold_edges", c.non_manifold_edges},
               {"inconsistent_edges", c.inconsistent_edges},
               {"pinched_vertices", c.pinched_vertices},
               {"t_junctions", c.t_junctions}};
  if (c.closed()) json["volume_m3"] = c.volume;
  return json;
}

Json geometry_json(const Scene& scene) {
  Json objects = Json::array();
  for (const ObjectCheck& object : check_objects(scene)) {
    Json json = {{"name", object.name}};
    json.update(check_json(object.mesh));
    objects.push_back(std::move(json));
  }
  return objects;
}

std::string node_name(const Scene& scene, uint32_t instance) {
  const int node = scene.instances[instance].node;
  return node >= 0 ? scene.nodes[size_t(node)].name : "";
}

Json leaks_json(const Scene& scene) {
  const TessellatedScene tessellated(scene);
  const Leaks leaks = find_leaks(*tessellated);
  Json worst = Json::array();
  for (const Gap& g : leaks.worst)
    worst.push_back({{"object", node_name(*tessellated, g.instance)},
                     {"other", node_name(*tessellated, g.other)},
                     {"place_m", vector(g.place)},
                     {"width_m", g.width},
                     {"length_m", g.length}});
  return {{"examined", leaks.complete},
          {"most_width_m", leaks.most_width},
          {"gaps", leaks.gaps},
          {"gap_length_m", leaks.gap_length},
          {"worst_gaps", std::move(worst)},
          {"crossed_faces", leaks.crossed_faces},
          {"crossing_length_m", leaks.crossing_length}};
}

std::string leaks_text(const Json& l) {
  constexpr size_t kMostGaps = 3;
  if (!l["examined"].get<bool>()) return "leaks: not examined, too many surfaces, or too many near each other\n";
  std::string text;
  if (const uint64_t count = l["crossed_faces"].get<uint64_t>())
    text += fmt::format("{} faces that others touch or cross, along {:.4g} m: partly buried\n", count,
                        l["crossing_length_m"].get<double>());
  if (const uint64_t count = l["gaps"].get<uint64_t>())
    text += fmt::format("{} gaps narrower than {:.3g} m, {:.4g} m in all: light may leak through them\n", count,
                        l["most_width_m"].get<double>(), l["gap_length_m"].get<double>());
  for (size_t i = 0; i < std::min(kMostGaps, l["worst_gaps"].size()); ++i) {
    const Json& g = l["worst_gaps"][i];
    text += fmt::format("  '{}' ends {:.3g} m off '{}', {:.3g} m long, at {:.4g} {:.4g} {:.4g}\n",
                        g["object"].get<std::string>(), g["width_m"].get<double>(), g["other"].get<std::string>(),
                        g["length_m"].get<double>(), g["place_m"][0].get<float>(), g["place_m"][1].get<float>(),
                        g["place_m"][2].get<float>());
  }
  return text;
}

Json materials_json(const Scene& scene) {
  std::vector<uint64_t> uses(scene.materials.size(), 0);
  for (const Instance& instance : scene.instances) {
    const int own = instance.mesh >= 0 ? scene.meshes[size_t(instance.mesh)].material : -1;
    const int index = instance.material >= 0 ? instance.material : own;
    if (index >= 0) ++uses[size_t(index)];
  }
  Json list = Json::array();
  for (size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    list.push_back({{"name", m.name},
                    {"uses", uses[i]},
                    {"reflectance", luminance(matt_reflectance(m))},
                    {"emits", m.emits()},
                    {"textured", bool(m.base_texture)},
                    {"double_sided", m.double_sided}});
  }
  return list;
}

Json cameras_json(const Scene& scene) {
  Json list = Json::array();
  for (const Camera& c : scene.cameras) {
    Json json = {{"name", c.name}, {"position_m", vector(c.position())}};
    if (c.kind == Camera::Kind::perspective)
      json["vertical_fov_degrees"] = double(c.vertical_fov) * 180 / kPi;
    else
      json["half_height_m"] = c.half_height;
    list.push_back(std::move(json));
  }
  return list;
}

/// Too large or too small for metres, with a guess.
std::string suspicion(const Bounds& b) {
  const float size = b.diagonal();
  if (size > kLargest)
    return fmt::format("{:.6g} m across: are its units millimetres (--units 0.001) or centimetres (--units 0.01)?",
                       size);
  if (size > 0 && size < kSmallest) return fmt::format("{:.6g} m across: are its units metres?", size);
  return {};
}

Json scene_json(const Scene& scene) {
  const Bounds b = bounds(scene);
  Json json = {{"kind", "scene"}, {"file", Path(scene.source).filename().string()}};
  if (!scene.generator.empty()) json["generator"] = scene.generator;
  json["hash"] = hash(scene).text();
  json["counts"] = {{"nodes", scene.nodes.size()},           {"meshes", scene.meshes.size()},
                    {"primitives", scene.primitives.size()}, {"instances", scene.instances.size()},
                    {"triangles", triangle_count(scene)},    {"materials", scene.materials.size()},
                    {"images", scene.images.size()},         {"lights", scene.lights.size()},
                    {"cameras", scene.cameras.size()}};
  if (!b.empty()) json["bounds_m"] = {{"low", vector(b.low)}, {"high", vector(b.high)}, {"size", vector(b.size())}};
  json["metres_per_unit"] = scene.metres_per_unit;
  if (const std::string doubt = suspicion(b); !doubt.empty()) json["suspicious_scale"] = doubt;
  json["lights"] = lights_json(scene);
  json["emissive_flux_lm"] = emissive_flux(scene);
  json["mean_sky_radiance_cd_m2"] = luminance(scene_lights(scene).ambient) - luminance(scene.ambient);
  json["objects"] = geometry_json(scene);
  json["leaks"] = leaks_json(scene);
  json["materials"] = materials_json(scene);
  json["cameras"] = cameras_json(scene);
  Json jobs = Json::array();
  for (const JobEstimate& e : estimate_jobs(scene))
    jobs.push_back({{"job", e.job}, {"bytes", e.bytes}, {"seconds", e.seconds}});
  json["estimates"] = std::move(jobs);
  return json;
}

std::string object_line(const Json& o) {
  std::string line = fmt::format("  {:<28} {:>9} triangles, {:.4g} m^2, {}", o["name"].get<std::string>(),
                                 o["triangles"].get<uint64_t>(), o["area_m2"].get<double>(),
                                 o["closed"].get<bool>() ? "closed" : "open");
  for (const char* fault : {"degenerate_triangles", "duplicate_triangles", "boundary_edges", "non_manifold_edges",
                            "inconsistent_edges", "pinched_vertices", "t_junctions"}) {
    std::string words = fault;
    std::replace(words.begin(), words.end(), '_', ' ');
    if (const uint64_t count = o[fault].get<uint64_t>()) line += fmt::format(", {} {}", count, words);
  }
  return line + "\n";
}

std::string scene_text(const Json& j) {
  constexpr size_t kMostObjects = 40;
  std::string text = fmt::format("{}: scene\n", j["file"].get<std::string>());
  for (const auto& [name, count] : j["counts"].items())
    text += fmt::format("  {:<28} {:>9}\n", name, count.get<uint64_t>());
  if (j.contains("bounds_m")) {
    const Json& size = j["bounds_m"]["size"];
    text += fmt::format("size: {:.4g} x {:.4g} x {:.4g} m (1 unit of the file = {:g} m)\n", size[0].get<float>(),
                        size[1].get<float>(), size[2].get<float>(), j["metres_per_unit"].get<double>());
  }
  if (j.contains("suspicious_scale")) text += "suspicious scale: " + j["suspicious_scale"].get<std::string>() + "\n";
  text += "light:\n";
  for (const Json& light : j["lights"])
    text += fmt::format("  {} '{}': {}\n", light["type"].get<std::string>(), light["name"].get<std::string>(),
                        light.contains("flux_lm") ? fmt::format("{:.4g} lm", light["flux_lm"].get<double>())
                                                  : fmt::format("{:.4g} lx", light.value("illuminance_lx", 0.0)));
  text += fmt::format("  emissive surfaces: {:.4g} lm; sky: {:.4g} cd/m^2 in the mean\n",
                      j["emissive_flux_lm"].get<double>(), j["mean_sky_radiance_cd_m2"].get<double>());
  text += "objects:\n";
  for (size_t i = 0; i < std::min(kMostObjects, j["objects"].size()); ++i) text += object_line(j["objects"][i]);
  if (j["objects"].size() > kMostObjects)
    text += fmt::format("  and {} more (--json lists all)\n", j["objects"].size() - kMostObjects);
  text += leaks_text(j["leaks"]);
  for (const Json& m : j["materials"])
    if (m["uses"] == 0) text += fmt::format("material '{}' is not used\n", m["name"].get<std::string>());
  text += "foreseen, roughly:\n";
  for (const Json& e : j["estimates"])
    text += fmt::format("  {:<28} {:>9}, {:.2g} s\n", e["job"].get<std::string>(), size_text(e["bytes"].get<double>()),
                        e["seconds"].get<double>());
  return text;
}

FileInfo scene_info(const Path& path, const ImportOptions& options) {
  const Scene scene = load_scene(path, options);
  const Json json = scene_json(scene);
  return {scene_text(json), dump(json), scene.warnings};
}

FileInfo image_info(std::span<const uint8_t> bytes, const Path& path) {
  constexpr std::string_view kNames[] = {"unknown", "png", "jpeg", "webp", "hdr", "exr", "pfm"};
  const ImageHeader h = read_image_header(bytes, display(path));
  const Json json = {{"kind", "image"},
                     {"file", path.filename().string()},
                     {"format", kNames[size_t(h.format)]},
                     {"width", h.width},
                     {"height", h.height},
                     {"channels", h.channels},
                     {"bits_per_channel", h.bits},
                     {"layers", h.layers}};
  std::string text = fmt::format("{}: {} image, {} x {}, {} channels of {} bits\n", json["file"].get<std::string>(),
                                 kNames[size_t(h.format)], h.width, h.height, h.channels, h.bits);
  for (const std::string& layer : h.layers) text += fmt::format("  layer '{}'\n", layer);
  return {text, dump(json), {}};
}

FileInfo luminaire_info(const Path& path) {
  constexpr std::string_view kShapes[] = {"point", "rectangle", "ellipse", "sphere", "cylinder"};
  const Luminaire l = load_luminaire(path);
  const PeakIntensity most = peak(*l.table);
  const double total = flux(*l.table);
  Json json = {{"kind", "luminaire"},
               {"file", path.filename().string()},
               {"format", l.format},
               {"name", l.name},
               {"manufacturer", l.manufacturer},
               {"lamp", l.lamp},
               {"flux_lm", total},
               {"lamp_flux_lm", l.lamp_flux},
               {"watts", l.watts},
               {"peak_cd", most.candela},
               {"peak_c_degrees", most.c},
               {"peak_gamma_degrees", most.gamma},
               {"beam_angle_degrees", opening_angle(*l.table, 0.5)},
               {"field_angle_degrees", opening_angle(*l.table, 0.1)},
               {"symmetry", l.symmetry},
               {"c_planes", l.table->c.size()},
               {"gamma_angles", l.table->gamma.size()}};
  json["opening"] = {{"shape", kShapes[size_t(l.opening.shape)]},
                     {"width_m", l.opening.width},
                     {"length_m", l.opening.length},
                     {"height_m", l.opening.height}};
  std::string text =
      fmt::format("{}: luminaire, {}\n  {} {}\n", json["file"].get<std::string>(), l.format, l.manufacturer, l.name);
  text += fmt::format("  flux                {:.5g} lm\n", total);
  if (l.lamp_flux > 0)
    text += fmt::format("  of its lamps        {:.5g} lm ({:.1f} %)\n", l.lamp_flux, 100 * total / l.lamp_flux);
  if (l.watts > 0) text += fmt::format("  power               {:.4g} W, {:.4g} lm/W\n", l.watts, total / l.watts);
  text += fmt::format("  highest intensity   {:.5g} cd at C {:g}, gamma {:g}\n", most.candela, most.c, most.gamma);
  text += fmt::format("  beam, field angle   {:.3g}, {:.3g} degrees\n", opening_angle(*l.table, 0.5),
                      opening_angle(*l.table, 0.1));
  text += fmt::format("  symmetry            {}\n  opening             {}, {:.3g} x {:.3g} x {:.3g} m\n", l.symmetry,
                      kShapes[size_t(l.opening.shape)], l.opening.width, l.opening.length, l.opening.height);
  return {text, dump(json), l.warnings};
}

/// All meshes of a node together.
MeshCheck check_object(const Scene& scene, std::span<const Instance* const> instances) {
  if (instances.size() == 1 && instances[0]->to_world == Mat4(1)) {  // large scans need no copy
    const Mesh& mesh = scene.meshes[size_t(instances[0]->mesh)];
    return check_mesh(mesh.positions, mesh.triangles);
  }
  size_t vertices = 0, faces = 0;
  for (const Instance* instance : instances) {
    const Mesh& mesh = scene.meshes[size_t(instance->mesh)];
    vertices += mesh.positions.size(), faces += mesh.triangles.size();
  }
  std::vector<Point3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  positions.reserve(vertices), triangles.reserve(faces);
  for (const Instance* instance : instances) {
    const Mesh& mesh = scene.meshes[size_t(instance->mesh)];
    const auto first = uint32_t(positions.size());
    for (const Point3 p : mesh.positions) positions.push_back(transform_point(instance->to_world, p));
    for (const auto& t : mesh.triangles) triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return check_mesh(positions, triangles);
}

}  // namespace

std::vector<ObjectCheck> check_objects(const Scene& scene) {
  std::map<int, std::vector<const Instance*>> objects;  // by node
  for (const Instance& instance : scene.instances)
    if (instance.mesh >= 0) objects[instance.node].push_back(&instance);
  std::vector<ObjectCheck> checks;
  for (const auto& [node, instances] : objects)
    checks.push_back({node >= 0 ? scene.nodes[size_t(node)].name : "", check_object(scene, instances)});
  return checks;
}

double emissive_flux(const Scene& scene) {
  double sum = 0;
  for (const Instance& instance : scene.instances) {
    const Material& m = scene.material_of(instance);
    if (!m.emits() || m.unlit || instance.mesh < 0) continue;
    const Mesh& mesh = scene.meshes[size_t(instance.mesh)];
    double area = 0;
    for (const auto& t : mesh.triangles) {
      Vec3d p[3];
      for (size_t k = 0; k < 3; ++k) p[k] = transform_point(instance.to_world, mesh.positions[t[k]]);
      area += length(cross(p[1] - p[0], p[2] - p[0])) / 2;
    }
    sum += kPi * double(luminance(m.emission.v)) * area * (m.double_sided ? 2 : 1);
  }
  return sum;
}

FileInfo file_info(const Path& path, const ImportOptions& options) {
  {
    const std::vector<uint8_t> bytes = read_file(path, kLargestFile);
    if (detect_image_format(bytes) != ImageFormat::unknown) return image_info(bytes, path);
    if (is_luminaire(bytes, lower_extension(path))) return luminaire_info(path);
  }  // large scenes need the memory
  return scene_info(path, options);
}

}  // namespace aktina
