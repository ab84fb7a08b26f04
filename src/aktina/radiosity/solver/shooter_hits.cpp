#include "aktina/radiosity/solver/shooter_hits.h"

#include <algorithm>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {
namespace {

constexpr uint32_t kDirections = 16;  // that must all end at backs
constexpr float kLarge = 64;          // times the area that a twentieth of the patches do not have
constexpr uint32_t kFewPlaces = 16, kManyPlaces = 256;

}  // namespace

ShooterHits::ShooterHits(const Sides& sides) : sides_(sides) {
  const PatchMesh& mesh = sides.mesh();
  outlines_.meshes.emplace_back();
  outlines_.instances.emplace_back();
  outlines_.instances[0].mesh = 0;
  const size_t fronts = mesh.shooters.size();
  backs_.assign(fronts, kNobody);
  std::vector<uint32_t> first_shooter(mesh.size(), kNobody);  // of the patch that begins it
  for (uint32_t i = 0; i < fronts; ++i) first_shooter[mesh.shooters[i].first] = i, add(i);
  for (uint32_t i = uint32_t(fronts); i < sides.shooters().size(); ++i)
    backs_[first_shooter[sides.patch(sides.shooters()[i].range.first)]] = i;
  accelerator_ = build_accelerator(outlines_);
  offset_ = ray_offset(bounds(outlines_));
}

void ShooterHits::add(uint32_t shooter) {
  const PatchMesh::Shooter& s = sides_.mesh().shooters[shooter];
  Mesh& mesh = outlines_.meshes[0];
  const auto first = uint32_t(mesh.positions.size());
  const bool quad = s.corners[2] != s.corners[3];
  for (size_t k = 0; k < (quad ? 4U : 3U); ++k) mesh.positions.push_back(sides_.mesh().positions[s.corners[k]]);
  mesh.triangles.push_back({first, first + 1, first + 2}), owners_.push_back(shooter);
  if (quad) mesh.triangles.push_back({first, first + 2, first + 3}), owners_.push_back(shooter);
  float sum = 0;
  for (uint32_t i = s.first; i < s.first + s.count; ++i) sum += luminance(sides_.mesh().transmittances[i]);
  if (sum > 0 && passing_.empty()) passing_.assign(sides_.mesh().shooters.size(), 0);
  if (!passing_.empty()) passing_[shooter] = sum / float(s.count);
}

bool ShooterHits::sees_only_backs(size_t side, Point3 place, uint32_t first, uint32_t count) const {
  const Frame frame(sides_.normal(side));
  const Point3 origin = place + offset_ * sides_.normal(side);
  RayPacket rays{};
  HitPacket hits;
  for (uint32_t k = 0; k < count; ++k) {
    const Vec2 u = first + k == 0 ? Vec2(0) : sobol_owen(first + k, uint32_t(side));
    rays.set(int(k), {origin, frame.to_world(sample_cosine_hemisphere(u)), 0, kInfinity});
  }
  intersect(rays, (1U << count) - 1, hits);
  for (uint32_t k = 0; k < count; ++k) {
    const Hit hit = hits.at(int(k));
    if (!hit || shooter(hit, rays.at(int(k)).direction) != kNobody) return false;
  }
  return true;
}

/// Most places are clear by a single ray along the normal.
bool ShooterHits::open(size_t side, Point3 place) const {
  return !sees_only_backs(side, place, 0, 1) || !sees_only_backs(side, place, 0, kDirections);
}

float ShooterHits::open_share(size_t side, uint32_t places) const {
  uint32_t count = 0;
  for (uint32_t k = 0; k < places; ++k) count += open(side, sides_.point(side, sobol_owen(k, hash32(uint32_t(side)))));
  return float(count) / float(places);
}

std::vector<float> ShooterHits::open_shares() const {
  std::vector<float> areas = sides_.mesh().areas;
  const auto small = areas.begin() + std::ptrdiff_t(areas.size() / 20);
  std::nth_element(areas.begin(), small, areas.end());
  const float large = kLarge * *small;
  std::vector<float> shares(sides_.size(), 0);
  parallel_for(sides_.size(), 256, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s) {
      if (sides_.mesh().areas[sides_.patch(s)] <= large) {
        shares[s] = open(s, sides_.centre(s)) ? 1 : 0;
        continue;
      }
      shares[s] = open_share(s, kFewPlaces);
      if (shares[s] > 0 && shares[s] < 1) shares[s] = open_share(s, kManyPlaces);
    }
  });
  return shares;
}

}  // namespace aktina
