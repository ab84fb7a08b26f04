#include "aktina/export/gltf_scene.h"

#include <cmath>

#include "aktina/export/gltf_mesh.h"

namespace aktina::gltf_export {
namespace {

Json array(const Mat4& m) {
  Json values = Json::array();
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) values.push_back(m[c][r]);
  return values;
}

/// Whether translation, rotation and scale make up the matrix, as glTF demands of it.
bool expressible(const Mat4& m) {
  const Vec3 x(m[0]), y(m[1]), z(m[2]);
  const float lengths[] = {length(x), length(y), length(z)};
  for (const float l : lengths)
    if (!(l > 1e-12f && l < kInfinity)) return false;
  constexpr float kSquare = 1e-5f;
  return is_finite(Vec3(m[3])) && m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1 &&
         std::fabs(dot(x, y)) < kSquare * lengths[0] * lengths[1] &&
         std::fabs(dot(y, z)) < kSquare * lengths[1] * lengths[2] &&
         std::fabs(dot(z, x)) < kSquare * lengths[2] * lengths[0];
}

bool nearly_equal(const Mat4& a, const Mat4& b) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!(std::fabs(a[c][r] - b[c][r]) <= 1e-5f * (1 + std::fabs(a[c][r])))) return false;
  return true;
}

class NodeWriter {
 public:
  NodeWriter(GltfFile& file, const Scene& scene) : file_(file), scene_(scene) {
    for (const Node& node : scene.nodes) {
      const bool straight = (node.parent < 0 || straight_[size_t(node.parent)]) && expressible(node.local);
      straight_.push_back(straight);
      Json json = Json::object();
      if (!node.name.empty()) json["name"] = node.name;
      if (straight && node.local != Mat4(1)) json["matrix"] = array(node.local);
      nodes_.push_back(std::move(json));
      parents_.push_back(node.parent);
    }
  }

  /// Index of scene node `hint`, if it stands where `to_world` says; else of a new node that does.
  size_t at(int hint, const Mat4& to_world, const std::string& name) {
    if (hint >= 0 && straight_[size_t(hint)] && nearly_equal(scene_.nodes[size_t(hint)].to_world, to_world))
      return size_t(hint);
    Json json = Json::object();
    if (!name.empty()) json["name"] = name;
    if (to_world != Mat4(1)) json["matrix"] = array(to_world);
    nodes_.push_back(std::move(json));
    parents_.push_back(-1);
    return nodes_.size() - 1;
  }

  /// A scene node without camera that stands where a camera does; -1: none.
  int camera_node(const Camera& camera) const {
    int found = -1;
    for (size_t i = 0; i < scene_.nodes.size(); ++i) {
      if (nodes_[i].contains("camera") || !nearly_equal(scene_.nodes[i].to_world, camera.to_world)) continue;
      if (scene_.nodes[i].name == camera.name) return int(i);
      if (found < 0) found = int(i);
    }
    return found;
  }

  Json& operator[](size_t node) { return nodes_[node]; }

  void finish() {
    Json roots = Json::array();
    for (size_t i = 0; i < nodes_.size(); ++i)
      if (parents_[i] < 0)
        roots.push_back(i);
      else
        nodes_[size_t(parents_[i])]["children"].push_back(i);
    for (Json& node : nodes_) file_.add("nodes", std::move(node));
    file_.json["scene"] = 0;
    file_.json["scenes"] = Json::array({Json::object()});
    if (!roots.empty()) file_.json["scenes"][0]["nodes"] = std::move(roots);
  }

 private:
  GltfFile& file_;
  const Scene& scene_;
  std::vector<bool> straight_;  // written with its own matrix, and so are all above it
  std::vector<Json> nodes_;
  std::vector<int> parents_;
};

void add_meshes(GltfFile& file, NodeWriter& nodes, const Scene& scene,
                const std::function<int(const Instance&)>& material_of) {
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[size_t(instance.mesh)];
    if (mesh.triangles.empty()) continue;
    const bool apply = !expressible(instance.to_world);
    Json primitive = apply ? primitive_json(file, transformed(mesh, instance.to_world)) : primitive_json(file, mesh);
    if (const int material = material_of(instance); material >= 0) primitive["material"] = material;
    const size_t node = nodes.at(instance.node, apply ? Mat4(1) : instance.to_world, mesh.name);
    if (nodes[node].contains("mesh")) {  // meshes of several materials come as several instances on one node
      file.json["meshes"][nodes[node]["mesh"].get<size_t>()]["primitives"].push_back(std::move(primitive));
      continue;
    }
    Json json = Json::object();
    if (!mesh.name.empty()) json["name"] = mesh.name;
    json["primitives"] = Json::array({std::move(primitive)});
    nodes[node]["mesh"] = file.add("meshes", std::move(json));
  }
}

Json camera_json(const Camera& camera) {
  Json json;
  if (!camera.name.empty()) json["name"] = camera.name;
  if (camera.kind == Camera::Kind::orthographic) {
    json["type"] = "orthographic";
    json["orthographic"] = {{"xmag", camera.half_height * (camera.aspect > 0 ? camera.aspect : 1)},
                            {"ymag", camera.half_height},
                            {"zfar", camera.far < kInfinity ? camera.far : camera.near + 1e6f},
                            {"znear", camera.near}};
    return json;
  }
  json["type"] = "perspective";
  Json& perspective = json["perspective"] = {{"yfov", camera.vertical_fov}, {"znear", camera.near}};
  if (camera.aspect > 0) perspective["aspectRatio"] = camera.aspect;
  if (camera.far < kInfinity) perspective["zfar"] = camera.far;
  return json;
}

void add_cameras(GltfFile& file, NodeWriter& nodes, const Scene& scene) {
  for (const Camera& camera : scene.cameras) {
    const int index = file.add("cameras", camera_json(camera));
    const size_t node = nodes.at(nodes.camera_node(camera), camera.to_world, camera.name);
    nodes[node]["camera"] = index;
  }
}

struct LightPlace {
  Point3 position{0};
  Vec3 direction{0, 0, -1};
  bool has_position = true, has_direction = true;
};

LightPlace place(const PointLight& l) { return {.position = l.position, .has_direction = false}; }
LightPlace place(const SpotLight& l) { return {.position = l.position, .direction = l.direction}; }
LightPlace place(const DirectionalLight& l) { return {.direction = l.direction, .has_position = false}; }
LightPlace place(const LuminaireLight& l) { return {.position = l.position, .has_direction = false}; }
LightPlace place(const WarnLight& l) { return {.position = l.position, .has_direction = false}; }
LightPlace place(const RectangleLight& l) { return {.position = l.corner, .has_direction = false}; }
LightPlace place(const DiscLight& l) { return {.position = l.position, .has_direction = false}; }

bool stands_at(const LightPlace& light, const Mat4& m) {
  const float reach = 1e-4f * (1 + length(light.position));
  return (!light.has_position || length(Vec3(m[3]) - light.position) < reach) &&
         (!light.has_direction || dot(normalize_or(-Vec3(m[2]), Vec3(0)), light.direction) > 1 - 1e-6f);
}

Mat4 matrix_of(const LightPlace& light) {
  const Frame frame(-light.direction);
  return {Vec4(frame.t, 0), Vec4(frame.b, 0), Vec4(frame.n, 0), Vec4(light.position, 1)};
}

void set_colour(Json& json, Rgb strength) {
  const float intensity = max_channel(strength);
  const Rgb colour = intensity > 0 ? clamped(strength / intensity, 0, 1) : Rgb(1);
  json["color"] = {colour.r, colour.g, colour.b};
  json["intensity"] = intensity;  // cd; lx of a directional light
}

Json light_json(const Light& light) {
  Json json;
  if (const auto* spot = std::get_if<SpotLight>(&light)) {
    json["type"] = "spot";
    set_colour(json, spot->intensity.v);
    // glTF's cones end at a right angle, and the inner one is smaller.
    const float outer = std::min(spot->outer_angle, float(kPi / 2));
    const float inner = std::min(spot->inner_angle, std::nextafter(outer, 0.0f));
    json["spot"] = {{"innerConeAngle", std::max(inner, 0.0f)}, {"outerConeAngle", outer}};
  } else if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
    json["type"] = "directional";
    set_colour(json, sun->e_perp.v);
  } else if (const auto* point = std::get_if<PointLight>(&light)) {
    json["type"] = "point";
    set_colour(json, point->intensity.v);
  } else {  // what glTF itself can say of the others is their mean intensity
    json["type"] = "point";
    set_colour(json, flux(light).value_or(Flux()).v * float(kInvPi / 4));
  }
  return json;
}

void add_lights(GltfFile& file, NodeWriter& nodes, const Scene& scene) {
  if (scene.lights.empty()) return;
  file.use("KHR_lights_punctual");
  Json& lights = file.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array();
  for (const PlacedLight& light : scene.lights) {
    const LightPlace where = std::visit([](const auto& l) { return place(l); }, light.light);
    const bool keeps_node = light.node >= 0 && stands_at(where, scene.nodes[size_t(light.node)].to_world);
    const Mat4 to_world = keeps_node ? scene.nodes[size_t(light.node)].to_world : matrix_of(where);
    Json json = light_json(light.light);
    if (!light.name.empty()) json["name"] = light.name;
    lights.push_back(std::move(json));
    Json& node = nodes[nodes.at(keeps_node ? light.node : -1, to_world, light.name)];
    node["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
  }
}

}  // namespace

void add_nodes(GltfFile& file, const Scene& scene, const std::function<int(const Instance&)>& material_of) {
  NodeWriter nodes(file, scene);
  add_meshes(file, nodes, scene, material_of);
  add_cameras(file, nodes, scene);
  add_lights(file, nodes, scene);
  nodes.finish();
}

}  // namespace aktina::gltf_export
