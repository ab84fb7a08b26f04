#include "aktina/image/metric/flip_colour.h"

#include <array>
#include <cmath>

namespace aktina::flip {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix inverse(const Matrix& m) {
  const auto minor = [&](size_t r, size_t c) {
    const size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix result;
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 3; ++c) result[r][c] = minor(c, r) / determinant;
  return result;
}

/// The matrices that follow from the chromaticities of Rec. 709's primaries and of D65.
struct Constants {
  float to_xyz[3][3], to_rgb[3][3];  // XYZ relative to white

  Constants() {
    static constexpr double kXy[4][2] = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};
    const auto xyz = [&](size_t i) {
      return std::array{kXy[i][0] / kXy[i][1], 1.0, (1 - kXy[i][0] - kXy[i][1]) / kXy[i][1]};
    };
    Matrix primaries;
    for (size_t c = 0; c < 3; ++c)
      for (size_t r = 0; r < 3; ++r) primaries[r][c] = xyz(c)[r];
    const Matrix back = inverse(primaries);
    const auto w = xyz(3);
    for (size_t c = 0; c < 3; ++c) {
      const double scale = back[c][0] * w[0] + back[c][1] * w[1] + back[c][2] * w[2];
      for (size_t r = 0; r < 3; ++r) {
        to_xyz[r][c] = float(primaries[r][c] * scale / w[r]);
        to_rgb[c][r] = float(back[c][r] / scale * w[r]);
      }
    }
  }
};
const Constants& constants() {
  static const Constants values;
  return values;
}

/// XYZ, each relative to white.
Triple relative_xyz(Rgb c) {
  const auto& m = constants().to_xyz;
  const auto row = [&](int r) { return m[r][0] * c.r + m[r][1] * c.g + m[r][2] * c.b; };
  return {row(0), row(1), row(2)};
}

/// CIE L*a*b*: the cube root, a straight line near black.
float lab_root(float t) {
  constexpr float kDelta = 6.0f / 29;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0f / 29;
}

}  // namespace

Triple ycxcz(Rgb linear) {
  const Triple t = relative_xyz(linear);
  return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}

Rgb rgb_of_ycxcz(Triple o) {
  const float y = (o.x + 16) / 116, x = y + o.y / 500, z = y - o.z / 200;
  const auto& m = constants().to_rgb;
  const auto row = [&](int r) { return m[r][0] * x + m[r][1] * y + m[r][2] * z; };
  return {row(0), row(1), row(2)};
}

Triple hunt_lab(Rgb linear) {
  const Triple t = relative_xyz(linear);
  const float x = lab_root(t.x), y = lab_root(t.y), z = lab_root(t.z);
  const float lightness = 116 * y - 16;
  return {lightness, 0.01f * lightness * 500 * (x - y), 0.01f * lightness * 200 * (y - z)};
}

float hyab(Triple a, Triple b) {
  const float da = a.y - b.y, db = a.z - b.z;
  return std::abs(a.x - b.x) + std::sqrt(da * da + db * db);
}

}  // namespace aktina::flip
