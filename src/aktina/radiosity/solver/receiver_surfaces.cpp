#include "aktina/radiosity/solver/receiver_surfaces.h"

#include <algorithm>

#include "aktina/radiosity/mesher/patch_builder.h"

namespace aktina {
namespace {

constexpr uint32_t kNone = 0xffffffff;

std::array<Point3, 4> turned(std::array<Point3, 4> c) {
  const bool quad = c[2] != c[3];
  std::reverse(c.begin(), c.begin() + (quad ? 4 : 3));
  if (!quad) c[3] = c[2];
  return c;
}

/// The faces of a scene, by what lies on them.
class FaceIndex {
 public:
  explicit FaceIndex(const Scene& scene) : all_(scene), first_(scene.instances.size(), 0) {
    faces_of_.resize(scene.instances.size());
    for (size_t k = 0; k < all_.faces.size(); ++k) {
      const uint32_t instance = all_.instances[k];
      first_[instance] = count_;
      count_ += uint32_t(all_.faces[k].list.size());
      faces_of_[instance] = index(all_.faces[k], scene.meshes[size_t(scene.instances[instance].mesh)]);
      for (const SourceFace& face : all_.faces[k].list) {
        corners_.emplace_back();
        for (size_t c = 0; c < 4; ++c) corners_.back()[c] = all_.faces[k].positions[face.corners[c]];
      }
    }
  }
  uint32_t size() const { return count_; }
  uint32_t at(const SurfacePoint& place) const {
    return first_[place.instance] + faces_of_[place.instance][place.triangle];
  }
  const std::array<Point3, 4>& corners(uint32_t face) const { return corners_[face]; }

 private:
  static std::vector<uint32_t> index(const SourceFaces& faces, const Mesh& mesh) {
    std::vector<uint32_t> of(mesh.triangles.size(), kNone);
    for (uint32_t f = 0; f < faces.list.size(); ++f)
      for (const uint32_t t : faces.list[f].triangles) of[t] = f;
    return of;
  }

  SceneFaces all_;
  std::vector<uint32_t> first_;
  std::vector<std::vector<uint32_t>> faces_of_;  // by instance and triangle
  std::vector<std::array<Point3, 4>> corners_;
  uint32_t count_ = 0;
};

struct Member {
  uint32_t face, side, receiver;
};

/// All sides that count, with the receivers that they belong to.
std::vector<Member> members_of(const ShotGeometry& geometry, const FaceIndex& index) {
  const Sides& sides = geometry.sides();
  std::vector<Member> members;
  const auto add = [&](uint32_t side, size_t receiver) {
    const uint32_t face = index.at(sides.mesh().centres[sides.patch(side)]);
    members.push_back({2 * face + sides.is_back(side), side, uint32_t(receiver)});
  };
  for (size_t r = 0; r < geometry.receivers(); ++r) {
    if (!geometry.receiving()) {
      add(uint32_t(r), r);
      continue;
    }
    for (const uint32_t side : geometry.receiving()->sides(r)) add(side, r);
  }
  std::stable_sort(members.begin(), members.end(), [](const Member& a, const Member& b) { return a.face < b.face; });
  return members;
}

}  // namespace

SurfaceLayout ReceiverSurfaces::layout() const {
  const Sides& sides = geometry_.sides();
  const PatchMesh& mesh = sides.mesh();
  const FaceIndex index(scene_);
  SurfaceLayout layout;
  uint32_t last = kNone;
  for (const Member& m : members_of(geometry_, index)) {
    if (m.face != last) {
      const std::array<Point3, 4>& corners = index.corners(m.face / 2);
      layout.faces.push_back({m.face % 2 ? turned(corners) : corners, sides.normal(m.side)});
      layout.first_pieces.push_back(uint32_t(layout.pieces.size()));
      last = m.face;
    }
    const uint32_t patch = sides.patch(m.side);
    std::array<Point3, 4> corners;
    for (size_t k = 0; k < 4; ++k) corners[k] = mesh.positions[mesh.patches[patch][k]];
    layout.pieces.push_back({m.receiver, m.face % 2 ? turned(corners) : corners, double(mesh.areas[patch])});
  }
  layout.first_pieces.push_back(uint32_t(layout.pieces.size()));
  return layout;
}

}  // namespace aktina
