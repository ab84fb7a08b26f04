// Vectors and matrices in the graphics convention (GLM), under the names used throughout Aktina.
#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace aktina {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Mat3 = glm::mat3;
using Mat4 = glm::mat4;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;
using Mat4d = glm::dmat4;
using Point3 = Vec3;    // m
using Point3d = Vec3d;  // m

using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kInvPi = 1 / kPi;
inline constexpr float kInfinity = __builtin_inff();

inline float squared_length(Vec3 v) { return dot(v, v); }
inline double squared_length(Vec3d v) { return dot(v, v); }

/// Direction of v, or `fallback` where v is (nearly) zero or not finite.
inline Vec3 normalize_or(Vec3 v, Vec3 fallback) {
  const float l2 = dot(v, v);
  return l2 > 1e-30f && l2 < kInfinity ? v * (1 / __builtin_sqrtf(l2)) : fallback;
}

inline bool is_finite(Vec3 v) { return __builtin_isfinite(v.x) && __builtin_isfinite(v.y) && __builtin_isfinite(v.z); }

inline Point3 transform_point(const Mat4& m, Point3 p) { return Vec3(m * Vec4(p, 1)); }
inline Vec3 transform_vector(const Mat4& m, Vec3 v) { return Vec3(m * Vec4(v, 0)); }

/// Two unit vectors that complete n to a right-handed orthonormal frame (t, b, n).
/// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
struct Frame {
  Vec3 t, b, n;
  explicit Frame(Vec3 normal) : n(normal) {
    const float sign = __builtin_copysignf(1.0f, n.z), a = -1 / (sign + n.z), c = n.x * n.y * a;
    t = {1 + sign * n.x * n.x * a, sign * c, -sign * n.x};
    b = {c, sign + n.y * n.y * a, -n.y};
  }
  Vec3 to_world(Vec3 v) const { return t * v.x + b * v.y + n * v.z; }
  Vec3 to_local(Vec3 v) const { return {dot(v, t), dot(v, b), dot(v, n)}; }
};

/// Axis-aligned box; empty until something is added.
struct Bounds {
  Point3 low{kInfinity}, high{-kInfinity};
  bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
  void add(Point3 p) { low = glm::min(low, p), high = glm::max(high, p); }
  void add(const Bounds& o) { low = glm::min(low, o.low), high = glm::max(high, o.high); }
  Point3 centre() const { return low + 0.5f * (high - low); }
  Vec3 size() const { return high - low; }
  float diagonal() const { return empty() ? 0 : length(size()); }
};

}  // namespace aktina
