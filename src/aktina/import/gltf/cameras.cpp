// Cameras, placed by the nodes that name them.
#include <cmath>

#include "aktina/import/gltf/nodes.h"

namespace aktina::gltf {
namespace {

constexpr float kWidest = 3.1f;  // rad, of a perspective camera's vertical angle

float positive(const Value& value, float fallback) {
  const float number = value.real(fallback);
  if (!(number > 0)) value.fail("should be above 0");
  return number;
}

void read_perspective(Document& document, const Value& place, Camera& camera) {
  if (!place["yfov"]) place["yfov"].fail("is missing");
  camera.vertical_fov = positive(place["yfov"], 0.7f);
  if (camera.vertical_fov > kWidest) {
    document.warnings.add("cameras with a field of view of 180 degrees or more were narrowed");
    camera.vertical_fov = kWidest;
  }
  camera.aspect = place["aspectRatio"] ? positive(place["aspectRatio"], 1) : 0;
  camera.near = positive(place["znear"], 0.01f);
  camera.far = place["zfar"] ? positive(place["zfar"], 1) : kInfinity;
}

void read_orthographic(const Value& place, Camera& camera) {
  camera.kind = Camera::Kind::orthographic;
  const float width = std::abs(place["xmag"].real(1));
  camera.half_height = std::abs(place["ymag"].real(1));
  if (!(camera.half_height > 0) || !(width > 0)) place.fail("xmag and ymag should not be 0");
  camera.aspect = width / camera.half_height;
  camera.near = place["znear"].real(0);
  camera.far = positive(place["zfar"], 1e6f);
}

Camera read_camera(Document& document, const Value& place) {
  Camera camera;
  camera.name = place["name"].text();
  const std::string_view type = place["type"].text_view();
  if (type == "perspective")
    read_perspective(document, place["perspective"], camera);
  else if (type == "orthographic")
    read_orthographic(place["orthographic"], camera);
  else
    place["type"].fail("is neither perspective nor orthographic");
  if (place["perspective"] && place["orthographic"])
    document.warnings.add("cameras that are both perspective and orthographic are what their type says");
  if (!(camera.far > camera.near)) place.fail("zfar should be beyond znear");
  return camera;
}

}  // namespace

void read_cameras(Document& document, const Hierarchy& hierarchy, Scene& scene) {
  const Value nodes = document.list("nodes"), list = document.list("cameras");
  std::vector<Camera> cameras;
  for (size_t i = 0; i < list.size(); ++i) cameras.push_back(read_camera(document, list[i]));
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    const int index = nodes[size_t(hierarchy.source[i])]["camera"].index(cameras.size());
    if (index < 0) continue;
    Camera camera = cameras[size_t(index)];
    camera.to_world = rigid(scene.nodes[i].to_world);
    const auto units = float(scene.metres_per_unit);
    camera.near *= units, camera.far *= units, camera.half_height *= units;
    if (camera.name.empty()) camera.name = scene.nodes[i].name;
    scene.cameras.push_back(std::move(camera));
  }
}

}  // namespace aktina::gltf
