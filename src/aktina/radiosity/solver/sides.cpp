#include "aktina/radiosity/solver/sides.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace aktina {

Sides::Sides(const PatchMesh& mesh) : mesh_(&mesh) {
  centres_.reserve(mesh.size());
  for (size_t i = 0; i < mesh.size(); ++i) {
    const auto& c = mesh.patches[i];
    const Point3 three = mesh.positions[c[0]] + mesh.positions[c[1]] + mesh.positions[c[2]];
    centres_.push_back(mesh.is_quad(i) ? 0.25f * (three + mesh.positions[c[3]]) : three * (1.0f / 3));
  }
  for (const PatchMesh::Shooter& each : mesh.shooters) shooters_.push_back(shooter(each, each.first, false));
  for (const PatchMesh::Shooter& each : mesh.shooters) {
    if (!mesh.two_sided[each.first]) continue;  // patches of one face are of one material
    shooters_.push_back(shooter(each, uint32_t(size()), true));
    for (uint32_t i = 0; i < each.count; ++i) backs_.push_back(each.first + i);
  }
}

Point3 Sides::point(size_t side, Vec2 u) const {
  const auto& c = mesh_->patches[patch(side)];
  const auto p = [&](size_t k) { return mesh_->positions[c[k]]; };
  if (c[2] != c[3]) return (p(0) * (1 - u.x) + p(1) * u.x) * (1 - u.y) + (p(3) * (1 - u.x) + p(2) * u.x) * u.y;
  const float root = std::sqrt(u.x);
  return p(0) * (1 - root) + (p(1) * (1 - u.y) + p(2) * u.y) * root;
}

Sides::Shooter Sides::shooter(const PatchMesh::Shooter& of, uint32_t first, bool back) const {
  Shooter s{{first, of.count}, {}, mesh_->patch_normals[of.first], false};
  for (size_t k = 0; k < 4; ++k) s.corners[k] = mesh_->positions[of.corners[k]];
  if (back) {
    const bool quad = of.corners[2] != of.corners[3];
    std::reverse(s.corners.begin(), s.corners.begin() + (quad ? 4 : 3));
    if (!quad) s.corners[3] = s.corners[2];
    s.normal = -s.normal;
  }
  for (uint32_t i = of.first; i < of.first + of.count; ++i) s.emits = s.emits || !is_black(mesh_->emissions[i].v);
  return s;
}

std::vector<uint32_t> Sides::all() const {
  std::vector<uint32_t> numbers(size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

std::vector<uint32_t> Sides::origins(const Sides& before, std::span<const uint32_t> origin, uint32_t none) const {
  std::vector<uint32_t> back(before.mesh().size(), none), of(size(), none);
  for (size_t s = before.mesh().size(); s < before.size(); ++s) back[before.patch(s)] = uint32_t(s);
  for (size_t s = 0; s < size(); ++s)
    if (const uint32_t was = origin[patch(s)]; was != none) of[s] = is_back(s) ? back[was] : was;
  return of;
}

RadiosityProblem Sides::problem() const {
  RadiosityProblem p;
  p.bands = 3;
  p.weights = {0.2126, 0.7152, 0.0722};  // luminance()
  bool passes = false;
  for (size_t s = 0; s < size(); ++s) {
    const uint32_t i = patch(s);
    p.areas.push_back(double(mesh_->areas[i]));
    for (int c = 0; c < 3; ++c) {
      p.reflectances.push_back(double(mesh_->reflectances[i][c]));
      p.emissions.push_back(double(mesh_->emissions[i].v[c]));
      p.passing.push_back(double(mesh_->transmittances[i][c]));
      passes = passes || p.passing.back() > 0;
    }
  }
  if (!passes) p.passing.clear();
  for (const Shooter& s : shooters_) p.shooters.push_back(s.range);
  return p;
}

}  // namespace aktina
