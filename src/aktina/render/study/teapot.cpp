// Newell's teapot. Rim, body, lid and bottom are surfaces of revolution, handle and spout mirror images of a half: what
// is listed are the profiles of the former and the patches of one half of the latter, in Newell's units, z up.
//
// M. Newell, "The Utilization of Procedure Models in Digital Image Synthesis", University of Utah, 1975; measures as in
// F. Crow, "The Origins of the Teapot", IEEE Computer Graphics and Applications 7(1), 1987.
#include <array>
#include <vector>

#include "aktina/render/study/paper.h"
#include "aktina/render/study/surface_grid.h"

namespace aktina {
namespace {

constexpr double kCircle = 0.56;        // where Newell puts the inner control points of a quarter of a circle
constexpr double kScale = 2.0 / 6.525;  // from the handle's end to the spout's: 2 m
constexpr double kMiddle = 1.575;       // half the height, to stand about the origin

struct Patch {
  std::array<std::array<Vec3d, 4>, 4> at;  // [along][across]; the front is on the side of d/d across x d/d along
  bool inside_out = false;
};

struct ProfilePoint {
  double radius, height;
};
using Profile = std::array<ProfilePoint, 4>;

constexpr Profile kRim = {{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}};
constexpr Profile kBody[] = {{{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}},
                             {{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}}};
constexpr Profile kLid[] = {{{{0, 3.15}, {0.8, 3.15}, {0, 2.7}, {0.2, 2.7}}},
                            {{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}}};
constexpr Profile kBottom = {{{0, 0}, {1.425, 0}, {1.5, 0.075}, {1.5, 0.15}}};

/// Half of a tube: a row is {x, z of the inner side, half width, x, z of the outer side}.
struct TubeRow {
  double x0, z0, half_width, x1, z1;
};
using Tube = std::array<TubeRow, 4>;
constexpr Tube kTubes[] = {
    {{{-1.6, 2.025, 0.3, -1.5, 2.25},
      {-2.3, 2.025, 0.3, -2.5, 2.25},
      {-2.7, 2.025, 0.3, -3, 2.25},
      {-2.7, 1.8, 0.3, -3, 1.8}}},
    {{{-2.7, 1.8, 0.3, -3, 1.8},
      {-2.7, 1.575, 0.3, -3, 1.35},
      {-2.5, 1.125, 0.3, -2.65, 0.9375},
      {-2, 0.9, 0.3, -1.9, 0.6}}},
    {{{1.7, 1.425, 0.66, 1.7, 0.6},
      {2.6, 1.425, 0.66, 3.1, 0.825},
      {2.3, 2.1, 0.25, 2.4, 2.025},
      {2.7, 2.4, 0.25, 3.3, 2.4}}},
    {{{2.7, 2.4, 0.25, 3.3, 2.4},
      {2.8, 2.475, 0.25, 3.525, 2.49375},
      {2.9, 2.475, 0.15, 3.45, 2.5125},
      {2.8, 2.4, 0.15, 3.2, 2.4}}},
};

void add_revolution(std::vector<Patch>& patches, const Profile& profile, bool inside_out = false) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    Patch patch;
    patch.inside_out = inside_out;
    for (size_t i = 0; i < 4; ++i) {
      const auto [r, z] = profile[i];
      const Vec2d arc[] = {{r, 0}, {r, kCircle * r}, {kCircle * r, r}, {0, r}};
      for (size_t j = 0; j < 4; ++j) {
        Vec2d p = arc[j];
        for (int turn = 0; turn < quarter; ++turn) p = {-p.y, p.x};
        patch.at[j][i] = {p.x, p.y, z};
      }
    }
    patches.push_back(patch);
  }
}

void add_tube(std::vector<Patch>& patches, const Tube& tube) {
  for (const double side : {-1.0, 1.0}) {
    Patch patch;
    patch.inside_out = side > 0;
    for (size_t i = 0; i < 4; ++i) {
      const TubeRow& row = tube[i];
      const double y = side * row.half_width;
      patch.at[i] = {Vec3d{row.x0, 0, row.z0}, {row.x0, y, row.z0}, {row.x1, y, row.z1}, {row.x1, 0, row.z1}};
    }
    patches.push_back(patch);
  }
}

std::vector<Patch> all_patches() {
  std::vector<Patch> patches;
  add_revolution(patches, kRim);
  for (const Profile& profile : kBody) add_revolution(patches, profile);
  for (const Profile& profile : kLid) add_revolution(patches, profile);
  add_revolution(patches, kBottom, true);
  for (const Tube& tube : kTubes) add_tube(patches, tube);
  return patches;
}

/// Value and derivative of a cubic Bezier curve.
struct Curve {
  Vec3d value, slope;
};
Curve bezier(const std::array<Vec3d, 4>& p, double t) {
  const double s = 1 - t;
  return {p[0] * (s * s * s) + p[1] * (3 * s * s * t) + p[2] * (3 * s * t * t) + p[3] * (t * t * t),
          (p[1] - p[0]) * (3 * s * s) + (p[2] - p[1]) * (6 * s * t) + (p[3] - p[2]) * (3 * t * t)};
}

/// @param along, across  in [0, 1]
SurfacePoint3 evaluate(const Patch& patch, double along, double across) {
  std::array<Vec3d, 4> points, slopes;
  for (size_t i = 0; i < 4; ++i) {
    std::array<Vec3d, 4> column;
    for (size_t j = 0; j < 4; ++j) column[j] = patch.at[j][i];
    const Curve curve = bezier(column, along);
    points[i] = curve.value, slopes[i] = curve.slope;
  }
  const Curve other = bezier(points, across);
  const Vec3d normal = cross(other.slope, bezier(slopes, across).value);
  return {other.value, patch.inside_out ? -normal : normal};
}

/// In our units and directions. Where the patch comes to a point, the normal is that of a place beside it.
SurfacePoint3 placed(const Patch& patch, double along, double across) {
  SurfacePoint3 p = evaluate(patch, along, across);
  if (length(p.normal) < 1e-9) p.normal = evaluate(patch, along, across < 0.5 ? across + 1e-4 : across - 1e-4).normal;
  const Vec3d n = p.normal / std::max(length(p.normal), 1e-300);
  return {kScale * Vec3d(p.position.x, p.position.z - kMiddle, -p.position.y), {n.x, n.z, -n.y}};
}

}  // namespace

Mesh teapot(int n) {
  Mesh mesh;
  mesh.name = "teapot";
  for (const Patch& patch : all_patches())
    add_grid(mesh, n, n, [&](double u, double v) { return placed(patch, u, v); });
  return mesh;
}

}  // namespace aktina
