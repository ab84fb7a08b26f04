// Half a cube over the middle of a patch, its faces cut into cells: each shows the nearest polygon behind it, and
// counts with its delta form factor. Cost: five item buffers a hemicube for a whole row. Weakness: seen from a few
// points only, so patches that are near or large need several hemicubes; what is smaller than a cell is seen or missed
// by luck.
//
//     top, at (x, y, 1):   dF = dA / (pi (x^2 + y^2 + 1)^2)
//     side, at (1, y, z):  dF = z dA / (pi (y^2 + z^2 + 1)^2),   dA = (2 / n)^2
//
// M. Cohen, D. Greenberg, "The Hemi-Cube: A Radiosity Solution for Complex Environments", SIGGRAPH '85.
#include "aktina/radiosity/formfactor/hemicube.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/formfactor/face_rays.h"
#include "aktina/radiosity/formfactor/quadrature.h"
#include "aktina/raster/item_buffer.h"

namespace aktina {

DeltaFormFactors::DeltaFormFactors(int resolution) : resolution_(resolution) {
  const int half = resolution / 2;
  const double step = 2.0 / resolution, area = step * step;
  for (int j = 0; j < half; ++j)
    for (int i = 0; i < half; ++i) {
      const double u = (i + 0.5) * step, v = (j + 0.5) * step, squared = u * u + v * v + 1;
      top_.push_back(area / (kPi * squared * squared));
      side_.push_back(v * area / (kPi * squared * squared));
    }
}

double DeltaFormFactors::total() const { return top_share() + 8 * sum(side_); }
double DeltaFormFactors::top_share() const { return 4 * sum(top_); }

double DeltaFormFactors::sum(const std::vector<double>& cells) {
  Sum sum;
  for (const double cell : cells) sum.add(cell);
  return sum.value();
}

namespace {

/// The cells of one face of the cube in the order in which they are drawn; padding counts nothing.
struct Cells {
  std::vector<double> each, blocks;  // of a block: the sum

  template <class Delta>
  Cells(int width, int rows, Delta&& delta) {
    const BlockLayout layout{0, rows, width};
    each.resize(layout.blocks() * kLanes), blocks.resize(layout.blocks());
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < width; ++x) each[layout.offset_of_pixel(x, y)] = delta(x, y);
    for (size_t k = 0; k < each.size(); ++k) blocks[k / kLanes] += each[k];
  }
};

class Hemicube final : public FormFactorMethod {
 public:
  Hemicube(int resolution, uint32_t hemicubes, uint32_t seed)
      : Hemicube(DeltaFormFactors(resolution), resolution, hemicubes, seed) {}

  void build(const FormFactorScene& scene) override {
    faces_ = Faces(scene);
    rays_.build(faces_);
    const Mesh& mesh = rays_.mesh();
    items_ = std::make_unique<ItemRasterizer>(mesh.positions, mesh.triangles);
  }

  FormFactorRow row(size_t i) const override {
    check_surface(faces_, i);
    const uint32_t seed = hash_combine(seed_, uint32_t(i));
    return mean([&](uint32_t k) {
      // One hemicube stands in the middle; several are spread evenly by area.
      const Vec2d u = hemicubes_ == 1 ? Vec2d(0.5) : Vec2d(sobol_owen(k, seed));
      const bool middle = hemicubes_ == 1 && faces_[i].convex.size() == 1;
      return look(middle ? centroid(faces_[i]) : point_on(faces_[i], u), faces_[i].plane.normal, turn(seed, k));
    });
  }

  FormFactorRow row(Point3d x, Vec3d n) const override {
    n = checked_normal(x, n);
    return mean([&](uint32_t k) { return look(x, n, turn(seed_, k)); });
  }

 private:
  Hemicube(const DeltaFormFactors& delta, int resolution, uint32_t hemicubes, uint32_t seed)
      : top_(resolution, resolution, [&](int x, int y) { return delta.top(x, y); }),
        side_(resolution, resolution / 2, [&](int x, int y) { return delta.side(x, y); }),
        total_(delta.total()),
        resolution_(resolution),
        hemicubes_(hemicubes),
        seed_(seed) {}

  static Point3d centroid(const Face& face) {
    Point3d sum(0);
    for (const SurfaceSample& s : gauss_points(face.vertices, face.plane.normal, 2)) sum += s.area * s.x;
    return sum / face.area;
  }

  /// A random rotation about the normal, so that the cells' pattern does not repeat from patch to patch.
  static float turn(uint32_t seed, uint32_t k) { return 2 * float(kPi) * unit_float(hash_combine(seed, k + 0x51ed27)); }

  template <class Look>
  FormFactorRow mean(Look&& look) const {
    std::vector<RunningStatistics> statistics(faces_.size());
    for (uint32_t k = 0; k < hemicubes_; ++k) {
      const std::vector<double> seen = look(k);
      for (size_t j = 0; j < seen.size(); ++j) statistics[j].add(seen[j]);
    }
    FormFactorRow row;
    const double cell = 4.0 / (kPi * resolution_ * resolution_);  // the largest delta form factor
    for (const RunningStatistics& s : statistics) {
      // A boundary passes through about as many cells as the root of the area covers, half of each rightly counted.
      const double edges = cell * std::sqrt(4 * s.mean() / cell + 1) / std::sqrt(double(hemicubes_));
      row.factors.push_back(s.mean());
      row.errors.push_back(edges + (hemicubes_ > 1 ? s.standard_error() : 0));
    }
    return row;
  }

  std::vector<double> look(Point3d x, Vec3d normal, float angle) const {
    const Vec3 n(normal);
    const Frame frame(n);
    const Vec3 t = std::cos(angle) * frame.t + std::sin(angle) * frame.b, b = cross(n, t);
    const Point3 eye = rays_.lifted(x, normal);
    std::vector<double> seen(faces_.size(), 0);
    add(eye, n, b, resolution_, top_, seen);
    for (const Vec3& side : {t, b, -t, -b}) add(eye, side, n, resolution_ / 2, side_, seen);
    for (size_t j = 0; j < seen.size(); ++j)
      seen[j] = faces_[j].plane.height(x) > rounding(faces_[j]) ? seen[j] / total_ : 0;  // backs are not lit
    return seen;
  }

  /// One face of the cube, seen along `forward`; of a side only the half above the horizon.
  void add(Point3 eye, Vec3 forward, Vec3 up, int rows, const Cells& cells, std::vector<double>& seen) const {
    Camera camera;
    camera.to_world = Mat4(Vec4(cross(forward, up), 0), Vec4(up, 0), Vec4(-forward, 0), Vec4(eye, 1));
    camera.vertical_fov = float(kPi / 2), camera.aspect = 1, camera.near = FaceRays::kOffset;
    items_->look(camera, resolution_, resolution_, rows,
                 [&](const BlockLayout& layout, std::span<const uint32_t> items) {
                   for (size_t block = 0; block < layout.blocks(); ++block) {
                     const uint32_t* item = &items[block * kLanes];
                     const double* cell = &cells.each[block * kLanes];
                     uint32_t differs = 0;
                     for (size_t k = 1; k < kLanes; ++k) differs |= item[k] ^ item[0];
                     if (!differs)
                       add(item[0], cells.blocks[block], seen);
                     else
                       for (size_t k = 0; k < kLanes; ++k) add(item[k], cell[k], seen);
                   }
                 });
  }
  void add(uint32_t item, double factor, std::vector<double>& seen) const {
    if (item == ItemBuffer::kNothing) return;
    const size_t face = rays_.face_of(item);
    if (face < faces_.size()) seen[face] += factor;
  }

  Cells top_, side_;
  double total_;  // rows of a closed scene sum to 1 exactly
  int resolution_;
  uint32_t hemicubes_, seed_;
  Faces faces_;
  FaceRays rays_;
  std::unique_ptr<ItemRasterizer> items_;
};

constexpr Param kParams[] = {
    {"resolution", "px", "cells along an edge of the cube, rounded up to an even number", 64, 2, 4096, true},
    {"hemicubes", "1", "on each patch: one in the middle, or several spread over it", 256, 1, 65536, true},
    {"seed", "1", "of the hemicubes' places and rotations", 0, 0, 4294967295.0, true}};

}  // namespace

extern constinit const FormFactorMethodRow hemicube_formfactor = {
    {"hemicube", "Hemicube", "cohen1985",
     "Item buffers on half a cube around points of a patch: a whole row at a time; aliasing, and wrong near by unless "
     "there are many.",
     kParams},
    [](const ParamSet& params) -> std::unique_ptr<FormFactorMethod> {
      const int resolution = int(params["resolution"]);
      return std::make_unique<Hemicube>(resolution + resolution % 2, uint32_t(params["hemicubes"]),
                                        uint32_t(params["seed"]));
    }};

}  // namespace aktina
