// What receives and shoots light: the fronts of all patches, then the backs of those that are two-sided.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "aktina/radiosity/solution.h"
#include "aktina/radiosity/solver/problem.h"

namespace aktina {

class Sides {
 public:
  /// `mesh` must outlive this.
  explicit Sides(const PatchMesh& mesh);

  size_t size() const { return mesh_->size() + backs_.size(); }
  bool is_back(size_t side) const { return side >= mesh_->size(); }
  uint32_t patch(size_t side) const { return is_back(side) ? backs_[side - mesh_->size()] : uint32_t(side); }
  Point3 centre(size_t side) const { return centres_[patch(side)]; }
  Vec3 normal(size_t side) const {
    const Vec3 n = mesh_->patch_normals[patch(side)];
    return is_back(side) ? -n : n;
  }
  /// A place on a side; evenly over its area where u is over the unit square (nearly, on quadrilaterals that are no
  /// parallelograms).
  Point3 point(size_t side, Vec2 u) const;
  const PatchMesh& mesh() const { return *mesh_; }

  /// The outline of what shoots together, counter-clockwise seen from its side; the last two corners of a triangle are
  /// equal.
  struct Shooter {
    RadiosityProblem::Range range;
    std::array<Point3, 4> corners;
    Vec3 normal;
    bool emits;
  };
  const std::vector<Shooter>& shooters() const { return shooters_; }

  /// Numbers of all sides, in order.
  std::vector<uint32_t> all() const;
  /// For each side which one of `before` it was. @param origin  the same by patch; `none` where there is none
  std::vector<uint32_t> origins(const Sides& before, std::span<const uint32_t> origin, uint32_t none) const;

  /// Three bands; nothing arrives yet.
  RadiosityProblem problem() const;

 private:
  Shooter shooter(const PatchMesh::Shooter& of, uint32_t first, bool back) const;

  const PatchMesh* mesh_;
  std::vector<uint32_t> backs_;
  std::vector<Point3> centres_;
  std::vector<Shooter> shooters_;
};

}  // namespace aktina
