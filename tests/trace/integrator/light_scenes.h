// Scenes with light in them, for tests of integrators.
#pragma once

#include "aktina/base/statistics.h"
#include "aktina/trace/radiance.h"
#include "trace/test_scenes.h"

namespace aktina::test {

/// Classic coefficients on the scene's last material, and the physical ones that they stand for.
inline Material& set_classic(Material& material, const ClassicMaterial& classic) {
  material = material_of(classic);
  return material;
}
inline Material& set_matt(Material& material, Rgb rho, Rgb emission = Rgb(0)) {
  set_classic(material, {.ka = rho, .kd = rho});
  material.emission = Radiance(emission);
  return material;
}
/// Glass that reflects and refracts, without colour.
inline Material& set_glass(Material& material, float ior, float roughness = 0) {
  material.base_colour = Rgb(1);
  material.metallic = 0, material.roughness = roughness, material.transmission = 1, material.ior = ior;
  return material;
}
inline Material& set_metal(Material& material, Rgb colour, float roughness = 0) {
  material.base_colour = colour;
  material.metallic = 1, material.roughness = roughness;
  return material;
}

inline Mesh quad(Point3 a, Point3 b, Point3 c, Point3 d) {
  Mesh mesh;
  add_quad(mesh, a, b, c, d);
  return mesh;
}

/// Box with inward fronts.
inline Mesh room(Point3 low, Point3 high) {
  Mesh mesh = box(low, high);
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline TraceOptions options(const char* integrator, int samples, uint32_t seed = 0) {
  TraceOptions o;
  o.integrator = integrator, o.samples = samples, o.seed = seed;
  return o;
}

/// Radiance along one ray.
inline Rgb along(const Scene& scene, Point3 from, Vec3 direction, const TraceOptions& o) {
  const Ray ray{from, direction};
  return trace_radiance(scene, {&ray, 1}, o)[0].v;
}

/// Mean of independent estimates (green channel) along one ray, and how sure it is.
inline RunningStatistics estimates(const Scene& scene, Point3 from, Vec3 direction, const char* integrator, int runs,
                                   int samples) {
  const std::vector<Ray> rays(size_t(runs), Ray{from, direction});
  RunningStatistics result;
  for (const Radiance& r : trace_radiance(scene, rays, options(integrator, samples))) result.add(double(r.v.g));
  return result;
}

#define EXPECT_MEAN(statistics, truth)                                                          \
  EXPECT_NEAR((statistics).mean(), (truth), 4 * (statistics).standard_error() + 1e-4 * (truth)) \
      << "standard error " << (statistics).standard_error()

}  // namespace aktina::test
