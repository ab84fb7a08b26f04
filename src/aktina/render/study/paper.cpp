#include "aktina/render/study/paper.h"

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/render/study/surface_grid.h"

namespace aktina {
namespace {

/// About the origin, radius 1.
Mesh sphere(int n) {
  Mesh mesh;
  add_grid(mesh, 16 * n, 10 * n, [](double u, double v) {
    const double a = 2 * kPi * u, b = kPi * v;
    const Vec3d p(std::sin(b) * std::sin(a), std::cos(b), std::sin(b) * std::cos(a));
    return SurfacePoint3{p, p};
  });
  return mesh;
}

Mesh torus(int n) {
  Mesh mesh;
  add_grid(mesh, 16 * n, 9 * n, [](double u, double v) {
    const double a = 2 * kPi * u, b = 2 * kPi * v;
    const Vec3d out(std::cos(a), std::sin(a), 0), normal = out * std::cos(b) + Vec3d(0, 0, std::sin(b));
    return SurfacePoint3{out * 0.72 + normal * 0.32, normal};
  });
  return mesh;
}

/// y = x^3 - x along x: the middle one of an odd number of segments bends both ways, with the same normal at both ends.
Mesh strip(int segments) {
  Mesh mesh;
  add_grid(mesh, segments, std::max(1, segments / 3), [](double u, double v) {
    const double x = 2.3 * (u - 0.5), z = 1.4 * (v - 0.5);
    return SurfacePoint3{{x, x * x * x - x, z}, normalize(Vec3d(1 - 3 * x * x, 1, 0))};
  });
  return mesh;
}

/// One shiny material, two lamps, a camera that sees all of it.
Scene lit(const std::string& name, Mesh mesh, Point3 eye, bool double_sided) {
  Scene scene;
  scene.source = name;
  mesh.name = name, mesh.material = 0;
  scene.materials.push_back(
      material_of({.ka = {0.1f, 0.06f, 0.03f}, .kd = {0.6f, 0.36f, 0.18f}, .ks = Rgb(0.5f), .exponent = 30}));
  scene.materials[0].double_sided = double_sided;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({.mesh = 0});
  scene.lights.push_back({"key", PointLight{{3, 4, 5}, Intensity(Rgb(60)), {}}, -1});
  scene.lights.push_back({"fill", PointLight{{-5, 1, 3}, Intensity({12, 16, 22}), {}}, -1});
  scene.ambient = Rgb(0.5f);
  scene.background = Radiance(Rgb(0.02f));
  scene.cameras.push_back(look_at(eye, {0, 0, 0}, {0, 1, 0}, 0.6f));
  scene.cameras[0].aspect = 4.0f / 3;
  return scene;
}

PaperScene series(const std::string& name, Mesh (*make)(int), std::initializer_list<int> levels, Point3 eye,
                  bool double_sided = false) {
  PaperScene scene{name, {}};
  for (const int level : levels) scene.levels.push_back(lit(name, make(level), eye, double_sided));
  return scene;
}

}  // namespace

std::vector<PaperScene> paper_scenes() {
  return {series("sphere", sphere, {1, 2, 4, 8}, {0, 0.6f, 3.8f}),
          series("torus", torus, {1, 2, 4, 8}, {0, -1.2f, 3.6f}),
          series("strip", strip, {3, 9, 27, 81}, {0.6f, 1.9f, 3.4f}, true),
          series("teapot", teapot, {3, 6, 12, 24}, {0.35f, 1.1f, 2.7f}, true)};
}

std::vector<Study> study_paper(const StudyOptions& options, Progress& progress) {
  std::vector<Study> studies;
  for (const PaperScene& scene : paper_scenes()) {
    StudyOptions own = options;
    own.levels.clear();
    for (const Scene& level : scene.levels) own.levels.push_back(&level);
    try {
      studies.push_back(study(scene.levels[0], own, progress));
    } catch (const Error& error) {
      if (error.code() != Code::cancelled || studies.empty()) throw;
      studies.back().report.complete = false;
    }
    if (!studies.back().report.complete) break;
  }
  return studies;
}

}  // namespace aktina
