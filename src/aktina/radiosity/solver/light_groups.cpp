#include "aktina/radiosity/solver/light_groups.h"

#include <fmt/core.h>

#include <algorithm>

#include "aktina/radiosity/solve.h"

namespace aktina {

LightGroup all_lights(const Scene& scene) {
  return {"", scene.lights, scene.environment.shines() ? &scene.environment : nullptr,
          std::vector<uint8_t>(scene.instances.size(), 1)};
}

std::vector<LightGroup> each_light(const Scene& scene) {
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
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (!scene.material_of(instance).emits() || (instance.mesh < 0 && instance.primitive < 0)) continue;
    const int node = instance.node;
    group(called(node >= 0 ? scene.nodes[size_t(node)].name : "", "object", i)).emits[i] = 1;
  }
  if (scene.environment.shines()) group("environment").sky = &scene.environment;
  return groups;
}

std::vector<std::string> light_names(const Scene& scene) {
  std::vector<std::string> names;
  for (LightGroup& group : each_light(scene)) names.push_back(std::move(group.name));
  return names;
}

}  // namespace aktina
