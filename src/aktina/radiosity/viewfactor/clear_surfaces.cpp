#include "aktina/radiosity/viewfactor/clear_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/radiosity/formfactor/face_rays.h"
#include "aktina/radiosity/formfactor/occluded.h"

namespace aktina {
namespace {

constexpr uint32_t kFewRays = 64, kMostRays = 1024;  // a pair
constexpr int kMostLayers = 64;                      // clear surfaces along a ray
constexpr float kLeastShare = 1e-6f;

class ClearRays {
 public:
  explicit ClearRays(const ViewFactorScene& scene) : scene_(scene), pieces_of_(scene.surfaces()) {
    std::vector<Polygon> opaque, clear;
    for (uint32_t p = 0; p < scene.pieces.size(); ++p) {
      pieces_of_[scene.owners[p]].push_back(p);
      faces_.push_back(make_face(scene.pieces[p], ""));
      if (scene.transmittances[p] > 0)
        clear.push_back(scene.pieces[p]), shares_.push_back(float(scene.transmittances[p]));
      else
        opaque.push_back(scene.pieces[p]);
    }
    opaque_.build(Faces({opaque, scene.occluders})), clear_.build(Faces({clear, {}}));
    any_opaque_ = !opaque.empty() || !scene.occluders.empty();
  }

  /// The mean share that passes where only clear surfaces are in between, and its error.
  Estimate passing(uint32_t i, uint32_t j, double wanted) const {
    const uint32_t seed = hash_combine(i, j);
    double weights = 0, sum = 0, squares = 0, most_error = 1;
    for (uint32_t sent = 0, limit = kFewRays; limit <= kMostRays && most_error > wanted; limit *= 4) {
      for (; sent < limit; sent += kPacket) add(i, j, sent, seed, weights, sum, squares);
      if (!(weights > 0)) continue;
      const double mean = sum / weights, spread = std::max(0.0, squares / weights - mean * mean);
      most_error = spread > 1e-12 ? std::sqrt(spread / double(limit)) : 0;
    }
    return weights > 0 ? Estimate{sum / weights, most_error} : Estimate{1, 1};
  }

 private:
  struct Place {
    Point3d point;
    Vec3d normal;
  };

  /// By area over the pieces of a surface.
  Place place(uint32_t surface, Vec2 u) const {
    const std::vector<uint32_t>& own = pieces_of_[surface];
    double all = 0;
    for (const uint32_t p : own) all += faces_[p].area;
    double rest = double(u.x) * all;
    size_t k = 0;
    while (k + 1 < own.size() && rest >= faces_[own[k]].area) rest -= faces_[own[k++]].area;
    const Face& face = faces_[own[k]];
    return {point_on(face, {std::min(rest / face.area, 1 - 1e-9), double(u.y)}), face.plane.normal};
  }

  void add(uint32_t i, uint32_t j, uint32_t first, uint32_t seed, double& weights, double& sum, double& squares) const {
    RayPacket solid, clear;
    double weight[kPacket];
    for (int lane = 0; lane < kPacket; ++lane) {
      const uint32_t k = first + uint32_t(lane);
      const Place x = place(i, sobol_owen(k, seed)), y = place(j, sobol_owen(k, hash32(seed)));
      const Vec3d d = y.point - x.point;
      const double squared = std::max(squared_length(d), 1e-300);
      weight[lane] = std::max(0.0, dot(x.normal, d)) * std::max(0.0, -dot(y.normal, d)) / (squared * squared);
      const auto ray = [&](const FaceRays& rays) {
        const Point3 from = rays.lifted(x.point, x.normal), to = rays.lifted(y.point, y.normal);
        return Ray{from, to - from, 0, 1};
      };
      solid.set(lane, ray(opaque_)), clear.set(lane, ray(clear_));
    }
    const uint32_t blocked = any_opaque_ ? opaque_.accelerator().occluded(solid, kAllLanes, Coherence::coherent) : 0;
    const std::array<float, kPacket> shares = through(clear);
    for (int lane = 0; lane < kPacket; ++lane) {
      if (blocked >> lane & 1 || shares[size_t(lane)] == 1) continue;
      const auto share = double(shares[size_t(lane)]);
      weights += weight[lane], sum += weight[lane] * share, squares += weight[lane] * share * share;
    }
  }

  std::array<float, kPacket> through(RayPacket& rays) const {
    std::array<float, kPacket> shares;
    shares.fill(1);
    uint32_t lanes = kAllLanes;
    for (int layer = 0; lanes && layer < kMostLayers; ++layer) {
      HitPacket hits;
      clear_.accelerator().intersect(rays, lanes, hits, Coherence::coherent);
      for (int lane = 0; lane < kPacket; ++lane) {
        if (!(lanes >> lane & 1)) continue;
        const Hit hit = hits.at(lane);
        if (hit) shares[size_t(lane)] *= shares_[clear_.face_of(hit.triangle)];
        if (!hit || shares[size_t(lane)] < kLeastShare) lanes &= ~(1U << lane);
        rays.near[lane] = hit.distance * (1 + 1e-5f) + FaceRays::kOffset;
      }
    }
    return shares;
  }

  const ViewFactorScene& scene_;
  std::vector<std::vector<uint32_t>> pieces_of_;
  std::vector<Face> faces_;
  FaceRays opaque_, clear_;
  std::vector<float> shares_;  // of clear pieces
  bool any_opaque_ = false;
};

/// Where row i has column j. @pre it has
uint64_t entry(const ViewFactors& f, uint32_t i, uint32_t j) {
  const uint32_t *begin = f.columns.data() + f.starts[i], *end = f.columns.data() + f.starts[i + 1];
  return uint64_t(std::lower_bound(begin, end, j) - f.columns.data());
}

}  // namespace

void let_through(const ViewFactorScene& scene, const ViewFactors& closed, double target, ViewFactors& open,
                 Progress* progress) {
  const ClearRays rays(scene);
  if (progress) progress->begin("clear surfaces", "rows", open.size());
  parallel_for(open.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (progress && progress->cancelled()) return;
      for (uint64_t k = open.starts[i]; k < open.starts[i + 1]; ++k) {
        const uint32_t j = open.columns[k];
        if (j < i) continue;
        const double all = open.factors[k], hidden = std::max(0.0, all - closed.at(i, j));
        const uint64_t back = entry(open, j, uint32_t(i));
        const double larger = std::max(hidden, hidden * open.areas[i] / open.areas[j]);
        if (!(larger > 1e-3 * target)) continue;
        const Estimate passing = rays.passing(uint32_t(i), j, target / larger);
        const double share = 1 - hidden / all * (1 - passing.value);
        const double doubt = hidden * passing.error;
        open.factors[k] *= share, open.errors[k] += float(doubt);
        if (back == k) continue;
        open.factors[back] *= share, open.errors[back] += float(doubt * open.areas[i] / open.areas[j]);
      }
      if (progress) progress->advance();
    }
  });
  if (progress) progress->throw_if_cancelled();
}

}  // namespace aktina
