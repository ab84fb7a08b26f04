// View-factor matrices against View3D 4.0 (eps 1e-4, compute alone): its seconds were measured on the project's kind of
// machine (2 cores, AVX-512), for it is in no package that could be raced here; so these ratios, unlike all others,
// depend on the machine that runs them.
#include <cmath>
#include <string>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/radiosity/viewfactor/certificate.h"
#include "bench/report.h"

namespace {

using namespace aktina;

class City {
 public:
  ViewFactorScene scene;

  /// n x m tiles of a parallelogram; its front is where u x v points.
  void tiles(Point3d o, Vec3d u, Vec3d v, int n, int m) {
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < m; ++k) {
        const auto at = [&](int a, int b) { return o + u * (double(a) / n) + v * (double(b) / m); };
        scene.owners.push_back(uint32_t(scene.names.size())), scene.names.emplace_back();
        scene.pieces.push_back({{at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)}});
      }
  }
  /// A box of n x n tiles a side, fronts inside or outside.
  void box(Point3d low, Vec3d s, int n, bool inside) {
    const Vec3d x(s.x, 0, 0), y(0, s.y, 0), z(0, 0, s.z);
    const auto side = [&](Point3d o, Vec3d u, Vec3d v) { inside ? tiles(o, u, v, n, n) : tiles(o, v, u, n, n); };
    side(low, x, y), side(low + z, y, x), side(low, y, z), side(low + x, z, y), side(low, z, x), side(low + y, x, z);
  }
};

ViewFactorScene room(int tiles, int box_tiles) {
  City city;
  city.box({0, 0, 0}, {1, 1, 1}, tiles, true);
  if (box_tiles > 0) city.box({0.3, 0.35, 0.2}, {0.4, 0.3, 0.35}, box_tiles, false);
  return city.scene;
}

/// Blocks of 20 m among streets of 20 m, 10 to 47 m high, on a ground of 5 m tiles.
ViewFactorScene town(int blocks) {
  City city;
  constexpr double kPitch = 40, kTile = 5;
  const int n = int(blocks * kPitch / kTile);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double x = i * kTile, y = k * kTile, u = std::fmod(x, kPitch), v = std::fmod(y, kPitch);
      if (u >= 10 && u < 30 && v >= 10 && v < 30) continue;
      city.tiles({x, y, 0}, {kTile, 0, 0}, {0, kTile, 0}, 1, 1);
    }
  for (int i = 0; i < blocks; ++i)
    for (int k = 0; k < blocks; ++k) {
      const int floors = 2 + int(hash_combine(uint32_t(i), uint32_t(k)) % 8);
      const double h = floors * kTile + double(hash_combine(uint32_t(k), uint32_t(i)) % 3);
      const Point3d o(i * kPitch + 10, k * kPitch + 10, 0);
      const Vec3d x(20, 0, 0), y(0, 20, 0), z(0, 0, h);
      city.tiles(o + z, x, y, 4, 4), city.tiles(o, y, x, 1, 1);
      city.tiles(o, x, z, 4, floors), city.tiles(o + x, y, z, 4, floors);
      city.tiles(o + x + y, -x, z, 4, floors), city.tiles(o + y, -y, z, 4, floors);
    }
  return city.scene;
}

void against_view3d(const std::string& id, const ViewFactorScene& scene, double peer, double goal, double goal_two) {
  double worst = 0;
  const auto matrix = [&](int threads) {
    set_thread_count(threads);
    view_factors(scene, {});
  };
  const auto least = bench::race(3, {[&] { matrix(1); }, [&] { matrix(2); }});
  set_thread_count(0);
  const ViewFactors f = view_factors(scene, {});
  for (size_t i = 0; i < f.size(); ++i) worst = std::max(worst, std::abs(f.row_sum(i) - 1));
  const std::string what = fmt::format("{} facets: View3D's {} s over ours", scene.pieces.size(), peer);
  bench::report("viewfactors." + id, what + ", one thread", peer / least[0], "x", bench::Goal{goal});
  bench::report("viewfactors." + id + ".threads", what + ", two threads", peer / least[1], "x", bench::Goal{goal_two});
  if (id != "city")
    bench::report("viewfactors." + id + ".closure", "row of the matrix farthest from 1, not normalised", worst, "1",
                  bench::Goal{2e-4, false});
}

}  // namespace

int main() {
  against_view3d("room", room(18, 0), 0.15, 4, 8);
  against_view3d("box_1014", room(12, 5), 4.62, 30, 50);
  against_view3d("box_2028", room(17, 7), 16.9, 60, 100);
  against_view3d("city", town(4), 6.3, 15, 25);
  return 0;
}
