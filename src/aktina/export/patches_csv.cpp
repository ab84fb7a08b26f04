// Comma-separated values as RFC 4180 has them, below lines of metadata that begin with '#'.
#include <fmt/format.h>

#include "aktina/base/error.h"
#include "aktina/export/csv.h"
#include "aktina/export/export.h"
#include "aktina/radiosity/error_estimate.h"

namespace aktina {
namespace {

constexpr std::string_view kColumns =
    "patch,instance,x_m,y_m,z_m,normal_x,normal_y,normal_z,area_m2,"
    "exitance_r_lm_m2,exitance_g_lm_m2,exitance_b_lm_m2,irradiance_r_lx,irradiance_g_lx,irradiance_b_lx,"
    "illuminance_lx,back_illuminance_lx,illuminance_error_lx\r\n";

/// The node's name, else the mesh's, else the number.
std::string name_of(const Scene& scene, uint32_t index) {
  if (index < scene.instances.size()) {
    const Instance& instance = scene.instances[index];
    if (instance.node >= 0 && !scene.nodes[size_t(instance.node)].name.empty())
      return scene.nodes[size_t(instance.node)].name;
    if (instance.mesh >= 0 && !scene.meshes[size_t(instance.mesh)].name.empty())
      return scene.meshes[size_t(instance.mesh)].name;
  }
  return std::to_string(index);
}

Point3 centre_of(const PatchMesh& mesh, size_t patch) {
  const auto& corners = mesh.patches[patch];
  const int count = mesh.is_quad(patch) ? 4 : 3;
  Point3 sum(0);
  for (int k = 0; k < count; ++k) sum += mesh.positions[corners[size_t(k)]];
  return sum / float(count);
}

}  // namespace

void write_patches_csv(const Path& path, const Scene& scene, const Solution& solution, const Metadata& metadata) {
  const PatchMesh& mesh = solution.mesh;
  std::string text;
  for (const auto& [name, value] : metadata) text += fmt::format("# {}: {}\r\n", one_line(name), one_line(value));
  text += kColumns;
  std::vector<std::string> names;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) names.push_back(csv_field(name_of(scene, i)));
  const std::vector<float> errors = patch_errors(solution);
  for (size_t i = 0; i < mesh.size(); ++i) {
    const Point3 p = centre_of(mesh, i);
    const Vec3 n = mesh.patch_normals[i];
    const Rgb b = solution.radiosities[i].v, e = solution.irradiances[i].v;
    const float back = mesh.two_sided[i] ? luminance(solution.back_irradiances[i].v) : 0;
    const uint32_t instance = mesh.centres[i].instance;
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", i,
                   instance < names.size() ? names[instance] : std::to_string(instance), p.x, p.y, p.z, n.x, n.y, n.z,
                   mesh.areas[i], b.r, b.g, b.b, e.r, e.g, e.b, luminance(e), back, errors[i]);
  }
  write_file(path, text);
}

}  // namespace aktina
