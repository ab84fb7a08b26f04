#include <fmt/core.h>

#include <cmath>
#include <unordered_map>

#include "aktina/base/error.h"
#include "aktina/import/text.h"
#include "aktina/render/view_factor_job.h"

namespace aktina {
std::vector<GrayBody> gray_bodies(const ViewFactorScene& scene, double fallback) {
  std::vector<GrayBody> bodies(scene.surfaces(), {.emissivity = fallback});
  for (size_t i = 0; i < scene.emissivities.size(); ++i) bodies[i].emissivity = scene.emissivities[i];
  return bodies;
}

std::vector<GrayBody> read_gray_bodies(const Path& path, const ViewFactorScene& scene, std::vector<GrayBody> bodies) {
  std::unordered_multimap<std::string, size_t> by_name;
  for (size_t i = 0; i < scene.surfaces(); ++i) by_name.emplace(scene.names[i], i);
  const std::string text = read_text_file(path), where = display(path);
  Lines lines(text);
  std::string_view line;
  bool head = true;
  while (lines.next(line)) {
    if (trimmed(line).empty() || line[0] == '#') continue;
    const std::vector<std::string> fields = csv_fields(line);
    const std::string at = place(where, lines.number());
    if (fields.size() != 4)
      throw Error(Code::bad_input, at, fmt::format("has {} fields", fields.size()),
                  "surface,emissivity,temperature_K,flux_W_m2");
    if (std::exchange(head, false) && fields[1] == "emissivity") continue;
    const auto [begin, end] = by_name.equal_range(fields[0]);
    if (begin == end) throw Error(Code::bad_input, at, fmt::format("there is no surface '{}'", fields[0]));
    double values[3] = {kUnknown, kUnknown, kUnknown};
    for (size_t k = 0; k < 3; ++k)
      if (!fields[k + 1].empty() && !(parse_number(fields[k + 1], values[k]) && std::isfinite(values[k])))
        throw Error(Code::bad_input, at, fmt::format("'{}' is no number", fields[k + 1]));
    for (auto it = begin; it != end; ++it) {
      GrayBody& body = bodies[it->second];
      if (!fields[1].empty()) body.emissivity = values[0];
      body.temperature = values[1], body.flux = values[2];
    }
  }
  return bodies;
}

}  // namespace aktina
