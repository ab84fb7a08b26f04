#include "aktina/radiosity/solver/light_groups.h"

#include <fmt/core.h>

#include <algorithm>

namespace aktina {

LightGroup all_lights(const Scene& scene) {
  return {"", scene.lights, scene.environment.shines() ? &scene.environment : nullptr,
          std::vector<uint8_t>(scene.instances.size(), 1)};
}

std::vector<LightGroup> each_light(const Scene& scene, const PatchMesh& mesh) {
  std::vector<LightGroup> groups;
  const auto group = [&](std::string name) -> LightGroup& {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const LightGroup& g) { return g.name == name; });
    if (same != groups.end()) return *same;
    return groups.emplace_back(
        LightGroup{std::move(name), {}, nullptr, std::vector<uint8_t>(scene.instances.size(), 0)});
  };
  const auto called = [](const std::string& name, const char* kind, size_t number) {
    return name.empty() ? fmt::format("{} {}", kind, number) : name;
  };
  for (size_t i = 0; i < scene.lights.size(); ++i)
    group(called(scene.lights[i].name, "lamp", i)).lamps.push_back(scene.lights[i]);
  std::vector<uint8_t> emits(scene.instances.size(), 0);
  for (size_t i = 0; i < mesh.size(); ++i)
    if (!is_black(mesh.emissions[i].v)) emits[mesh.centres[i].instance] = 1;
  for (size_t i = 0; i < emits.size(); ++i) {
    if (!emits[i]) continue;
    const int node = scene.instances[i].node;
    group(called(node >= 0 ? scene.nodes[size_t(node)].name : "", "object", i)).emits[i] = 1;
  }
  if (scene.environment.shines()) group("environment").sky = &scene.environment;
  return groups;
}

}  // namespace aktina
