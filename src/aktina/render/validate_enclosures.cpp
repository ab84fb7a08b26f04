// Closed enclosures: all light stays in, so that sums and even levels are known exactly.
#include <cmath>

#include "aktina/radiosity/formfactor/formfactor.h"
#include "aktina/radiosity/solve.h"
#include "aktina/render/validate_cases.h"
#include "aktina/trace/radiance.h"

namespace aktina {
namespace {

constexpr float kReflectance = 0.6f;

/// A cube of 1 m whose inside shines with exitance 1 lm/m^2 and reflects 0.6: everywhere B = E / (1 - rho) = 2.5.
Scene white_furnace() {
  Scene scene;
  Material white;
  white.base_colour = Rgb(kReflectance), white.metallic = 0, white.specular_weight = 0;
  white.emission = Radiance(Rgb(float(kInvPi)));
  scene.materials.push_back(white);
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-0.5f, 0.5f}) {
      Vec3 normal(0), u(0), v(0);
      normal[axis] = side > 0 ? -1.0f : 1.0f, u[(axis + 1) % 3] = 1, v = cross(normal, u);
      Vec3 centre(0);
      centre[axis] = side;
      const auto first = uint32_t(mesh.positions.size());
      for (const Vec2 at : {Vec2(-0.5f, -0.5f), Vec2(0.5f, -0.5f), Vec2(0.5f, 0.5f), Vec2(-0.5f, 0.5f)}) {
        mesh.positions.push_back(centre + at.x * u + at.y * v);
        mesh.normals.push_back(normal);
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    }
  mesh.material = 0;
  scene.meshes.push_back(mesh);
  Instance instance;
  instance.mesh = 0;
  scene.instances.push_back(instance);
  return scene;
}

double furnace_by_paths() {
  const Scene scene = white_furnace();
  std::vector<Ray> rays;
  for (int i = 0; i < 64; ++i) {
    const int column = i % 4, row = i / 16;
    rays.push_back({{0.1f, 0.05f, -0.1f}, normalize(Vec3(float(column) - 1.5f, float(row) - 1.5f, 1))});
  }
  TraceOptions options;
  options.samples = 256;
  double sum = 0;
  for (const Radiance l : trace_radiance(scene, rays, options)) sum += double(l.v.g);
  return sum / double(rays.size());
}

double furnace_by_radiosity() {
  RadiosityOptions options;
  options.solver = "progressive", options.patch_size = 0.5, options.tolerance = 1e-5;
  const Solution solution = solve_radiosity(white_furnace(), options);
  double sum = 0, area = 0;
  for (size_t i = 0; i < solution.mesh.size(); ++i) {
    sum += double(solution.radiosities[i].v.g) * double(solution.mesh.areas[i]);
    area += double(solution.mesh.areas[i]);
  }
  return sum / area;
}

}  // namespace

void add_enclosure_cases(std::vector<ValidationCase>& cases) {
  const double even = 1 / (1 - double(kReflectance));
  cases.push_back({"furnace", "closed cube, E = 1, rho = 0.6: radiance by path tracing", "cd/m^2", even / kPi, 0.01,
                   "L = E / (pi (1 - rho))", furnace_by_paths});
  cases.push_back({"furnace", "closed cube, E = 1, rho = 0.6: mean radiosity by shooting", "lm/m^2", even, 0.005,
                   "B = E / (1 - rho)", furnace_by_radiosity});
}

}  // namespace aktina
