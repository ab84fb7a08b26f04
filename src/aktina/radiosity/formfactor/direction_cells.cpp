#include "aktina/radiosity/formfactor/direction_cells.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/formfactor/face_rays.h"

namespace aktina {
namespace {

class ByCells final : public FaceRaysMethod {
 public:
  ByCells(std::vector<DirectionCell> cells, uint32_t points, uint32_t seed)
      : cells_(std::move(cells)), points_(points), seed_(seed) {
    for (const DirectionCell& cell : cells_) largest_ = std::max(largest_, cell.factor);
  }

  FormFactorRow row(size_t i) const override {
    check_surface(faces_, i);
    const uint32_t seed = hash_combine(seed_, uint32_t(i));
    return mean(seed, faces_[i].plane.normal,
                [&](uint32_t k) { return point_on(faces_[i], Vec2d(sobol_owen(k, seed))); });
  }

  FormFactorRow row(Point3d x, Vec3d n) const override {
    return mean(seed_, checked_normal(x, n), [&](uint32_t) { return x; });
  }

 private:
  template <class Place>
  FormFactorRow mean(uint32_t seed, Vec3d normal, Place&& place) const {
    std::vector<RunningStatistics> statistics(faces_.size());
    for (uint32_t k = 0; k < points_; ++k) {
      const float angle = 2 * float(kPi) * unit_float(hash_combine(seed, k + 0x51ed27));
      const std::vector<double> seen = look(place(k), normal, angle);
      for (size_t j = 0; j < seen.size(); ++j) statistics[j].add(seen[j]);
    }
    FormFactorRow row;
    for (const RunningStatistics& s : statistics) {
      // A boundary passes through about as many cells as the root of the area covers, half of each rightly counted.
      const double edges = largest_ * std::sqrt(4 * s.mean() / largest_ + 1) / std::sqrt(double(points_));
      row.factors.push_back(std::min(s.mean(), 1.0));
      row.errors.push_back(edges + (points_ > 1 ? s.standard_error() : 0));
    }
    return row;
  }

  std::vector<double> look(Point3d x, Vec3d normal, float angle) const {
    const Frame frame{Vec3(normal)};
    const float c = std::cos(angle), s = std::sin(angle);
    const Point3 eye = rays_.lifted(x, normal);
    std::vector<double> seen(faces_.size(), 0);
    for (size_t first = 0; first < cells_.size(); first += kPacket) {
      RayPacket rays;
      HitPacket hits;
      uint32_t lanes = 0;
      for (size_t lane = 0; lane < size_t(kPacket) && first + lane < cells_.size(); ++lane) {
        const Vec3 d = cells_[first + lane].direction;
        rays.set(int(lane), {eye, frame.to_world({c * d.x - s * d.y, s * d.x + c * d.y, d.z})});
        lanes |= 1U << lane;
      }
      rays_.accelerator().intersect(rays, lanes, hits, Coherence::incoherent);
      for (size_t lane = 0; lane < size_t(kPacket); ++lane) {
        if (!(lanes >> lane & 1) || hits.instance[lane] == kNothing) continue;
        const size_t face = rays_.face_of(hits.triangle[lane]);
        if (face < faces_.size() && dot(Vec3d(rays.at(int(lane)).direction), faces_[face].plane.normal) < 0)
          seen[face] += cells_[first + lane].factor;  // backs are not lit
      }
    }
    return seen;
  }

  std::vector<DirectionCell> cells_;
  double largest_ = 0;
  uint32_t points_, seed_;
};

}  // namespace

DirectionCell direction_cell(Vec3d middle, Vec3d normal, double area) {
  const double squared = squared_length(middle), r = std::sqrt(squared);
  const double cosines = middle.z * std::abs(dot(normal, middle)) / squared;
  return {Vec3(middle / r), cosines * area / (kPi * squared)};
}

std::unique_ptr<FormFactorMethod> by_cells(std::vector<DirectionCell> cells, uint32_t points, uint32_t seed) {
  return std::make_unique<ByCells>(std::move(cells), points, seed);
}

}  // namespace aktina
