// Form factors: closed forms a second, rows a second of the methods that find out what is hidden, and what a second
// thread is worth to them.
#include <numeric>
#include <string>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/radiosity/formfactor/face_rays.h"
#include "aktina/radiosity/formfactor/hemicube.h"
#include "aktina/radiosity/formfactor/matrix.h"
#include "aktina/radiosity/formfactor/point_to_polygon.h"
#include "bench/llvmpipe.h"
#include "bench/report.h"

namespace {

using namespace aktina;

constexpr int kCells = 8;  // along each edge of the room: 6 x 64 surfaces

/// Squares that tile one wall of the unit room, seen from inside: corner, and the two edges whose product points
/// inward.
void add_wall(FormFactorScene& scene, Point3d corner, Vec3d u, Vec3d v) {
  for (int i = 0; i < kCells; ++i)
    for (int k = 0; k < kCells; ++k) {
      const auto at = [&](int a, int b) { return corner + u * (double(a) / kCells) + v * (double(b) / kCells); };
      scene.surfaces.push_back({{at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)}});
    }
}

/// A room of 384 squares with two screens in it.
FormFactorScene room() {
  const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  FormFactorScene scene;
  add_wall(scene, {0, 0, 0}, x, y), add_wall(scene, {0, 0, 1}, y, x);
  add_wall(scene, {0, 0, 0}, y, z), add_wall(scene, {1, 0, 0}, z, y);
  add_wall(scene, {0, 0, 0}, z, x), add_wall(scene, {0, 1, 0}, x, z);
  scene.occluders.push_back({{{0.3, 0.2, 0.1}, {0.3, 0.7, 0.1}, {0.3, 0.7, 0.8}, {0.3, 0.2, 0.8}}});
  scene.occluders.push_back({{{0.5, 0.4, 0.5}, {0.9, 0.4, 0.5}, {0.9, 0.8, 0.6}, {0.5, 0.8, 0.6}}});
  return scene;
}

/// Points on a plane below a square that some of them see cut by their horizon: a new one each time.
double closed_forms(int pairs) {
  const Face face = make_face({{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}}, "square");
  double sum = 0;
  for (int i = 0; i < pairs; ++i) {
    const double t = double(i) / pairs, tilt = 2 * t;
    sum += point_to_polygon({t, 1 - t, 0}, {std::sin(tilt), 0, std::cos(tilt)}, face);
  }
  return sum;
}

void closed_form_rate() {
  constexpr int kPairs = 200'000;
  volatile double sink = 0;
  const auto least = bench::race(3, {[&] { sink = sink + closed_forms(kPairs); }});
  bench::report("formfactor.closed_form", "points to a square by the contour formula, clipped, one thread",
                kPairs / least[0], "pairs/s");
}

void row_rate(const FormFactorScene& scene, const std::string& method) {
  const auto matrix = [&](int threads) {
    set_thread_count(threads);
    form_factor_matrix(scene, method);
  };
  const auto least = bench::race(3, {[&] { matrix(1); }, [&] { matrix(2); }});
  set_thread_count(0);
  const std::string name = method.substr(0, method.find(':'));
  bench::report("formfactor." + name, "rows of 384 surfaces by " + method + ", one thread",
                double(scene.surfaces.size()) / least[0], "rows/s");
  bench::report("formfactor." + name + ".threads", "rows by " + method + " on two threads against one",
                least[0] / least[1], "x", bench::Goal{1.85});
}

/// A hemicube as llvmpipe draws it: five pictures, read back and weighed.
class PeerHemicube {
 public:
  PeerHemicube(const FaceRays& rays, size_t faces, int resolution, int threads)
      : rays_(rays),
        delta_(resolution),
        seen_(faces),
        resolution_(resolution),
        items_(rays.mesh(), resolution, threads) {}
  const std::string& missing() const { return items_.missing(); }

  double look(Point3 eye, Vec3 n) {
    std::fill(seen_.begin(), seen_.end(), 0.0);
    const Frame frame(n);
    add(eye, n, frame.b, true);
    for (const Vec3& side : {frame.t, frame.b, -frame.t, -frame.b}) add(eye, side, n, false);
    return std::accumulate(seen_.begin(), seen_.end(), 0.0) / delta_.total();
  }

 private:
  void add(Point3 eye, Vec3 forward, Vec3 up, bool top) {
    Camera camera;
    camera.to_world = Mat4(Vec4(cross(forward, up), 0), Vec4(up, 0), Vec4(-forward, 0), Vec4(eye, 1));
    camera.vertical_fov = float(kPi / 2), camera.near = 1e-4f, camera.far = 10;
    const int rows = top ? resolution_ : resolution_ / 2;
    items_.draw(camera, rows, buffer_);
    for (int row = 0; row < rows; ++row)
      for (int x = 0; x < resolution_; ++x) {
        const uint32_t item = buffer_[size_t(row) * size_t(resolution_) + size_t(x)];
        const int y = rows - 1 - row;
        if (item == 0) continue;
        const size_t face = rays_.face_of(item - 1);
        if (face < seen_.size()) seen_[face] += top ? delta_.top(x, y) : delta_.side(x, y);
      }
  }

  const FaceRays& rays_;
  DeltaFormFactors delta_;
  std::vector<double> seen_;
  int resolution_;
  bench::LlvmpipeItems items_;
  std::vector<uint32_t> buffer_;
};

/// Hemicubes over the middles of some surfaces, one thread each side.
void against_llvmpipe(const FormFactorScene& scene, int resolution) {
  constexpr size_t kHemicubes = 96;
  const Faces faces(scene);
  FaceRays rays;
  rays.build(faces);
  PeerHemicube peer(rays, faces.size(), resolution, 0);
  if (!peer.missing().empty()) {
    fmt::print(stderr, "hemicube: not compared with llvmpipe: {}\n", peer.missing());
    return;
  }
  const auto own =
      make_method(formfactors(), "formfactor", fmt::format("hemicube:resolution={},hemicubes=1", resolution));
  own->build(scene);
  double ours = 0, theirs = 0;
  set_thread_count(1);
  const auto each = [&](auto&& look) {
    for (size_t k = 0; k < kHemicubes; ++k) look(k * faces.size() / kHemicubes);
  };
  const auto least = bench::race(5, {[&] { each([&](size_t i) { ours += own->row(i).factors[0]; }); },
                                     [&] {
                                       each([&](size_t i) {
                                         const Vec3d n = faces[i].plane.normal;
                                         theirs += peer.look(rays.lifted(faces[i].centre, n), Vec3(n));
                                       });
                                     }});
  set_thread_count(0);
  bench::report(
      fmt::format("formfactor.hemicube.llvmpipe_{}", resolution),
      fmt::format("hemicubes of {0} x {0} among 384 squares against the same by llvmpipe, one thread", resolution),
      least[1] / least[0], "x", bench::Goal{3});
}

}  // namespace

int main() {
  closed_form_rate();
  const FormFactorScene scene = room();
  row_rate(scene, "ray_cast:points=16,samples=2");
  row_rate(scene, "hemicube:hemicubes=4");
  for (const int resolution : {64, 256}) against_llvmpipe(scene, resolution);
  return 0;
}
