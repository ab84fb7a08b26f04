#include "aktina/trace/emitter.h"

#include <algorithm>
#include <cmath>

#include "aktina/trace/placed_primitive.h"

namespace aktina {
namespace {

struct LocalSample {
  Point3 position;
  Vec3 normal;
};

Vec3 around(float u) { return {std::cos(float(2 * kPi) * u), 0, std::sin(float(2 * kPi) * u)}; }

LocalSample sample_shape(const Sphere& s, Vec2 u) {
  const float y = 1 - 2 * u.y;
  const Vec3 n = around(u.x) * std::sqrt(std::max(0.0f, 1 - y * y)) + Vec3(0, y, 0);
  return {n * s.radius, n};
}
LocalSample sample_shape(const Disc& d, Vec2 u) { return {around(u.x) * (d.radius * std::sqrt(u.y)), {0, 1, 0}}; }
LocalSample sample_shape(const Cone& c, Vec2 u) {
  // Evenly over the area: the share below height t is (r t + (r_top - r) t^2 / 2) / ((r + r_top) / 2).
  const float r = c.radius, grow = c.top_radius - c.radius, sum = (c.radius + c.top_radius) * u.y;
  const float t = std::clamp(sum / std::max(r + std::sqrt(std::max(r * r + grow * sum, 0.0f)), 1e-20f), 0.0f, 1.0f);
  const Vec3 out = around(u.x);
  return {out * (r + grow * t) + Vec3(0, c.height * t, 0), normalize_or(out * c.height - Vec3(0, grow, 0), {0, 1, 0})};
}
LocalSample sample_shape(const Cylinder& c, Vec2 u) { return sample_shape(Cone{c.radius, c.radius, c.height}, u); }

Vec2 mix(const std::vector<Vec2>& uv, const std::array<uint32_t, 3>& t, float b1, float b2) {
  return uv.empty() ? Vec2(0) : uv[t[0]] * (1 - b1 - b2) + uv[t[1]] * b1 + uv[t[2]] * b2;
}

/// How much a piece of surface with this normal (own space) grows when it is placed: |det M| |M^-T n|.
float area_scale(const Mat4& m, float length_of_world_normal) {
  return std::abs(glm::determinant(Mat3(m))) * length_of_world_normal;
}

bool even(const Material& m) { return !m.emission_texture && m.alpha_mode == AlphaMode::opaque; }

}  // namespace

EmitterSample Emitter::sample(Vec2 u) const {
  EmitterSample s;
  if (primitive) {
    const LocalSample local = std::visit([&](const auto& shape) { return sample_shape(shape, u); }, *primitive);
    const Vec3 n = glm::transpose(glm::inverse(Mat3(to_world))) * local.normal;
    s.position = transform_point(to_world, local.position);
    s.normal = normalize_or(n, {0, 1, 0});
    s.area_pdf = area_pdf(n);
    return s;
  }
  s.normal = normal;
  s.area_pdf = 1 / area;
  if (parallelogram) {
    s.position = corner + edge[0] * u.x + edge[1] * u.y;
    const bool second = u.y > u.x;  // beyond the diagonal
    const float along = second ? u.y - u.x : u.x - u.y, diagonal = std::min(u.x, u.y);
    if (!even(*material)) set_uv(s, triangle + second, second ? diagonal : along, second ? along : diagonal);
    return s;
  }
  const float root = std::sqrt(u.x), b1 = root * (1 - u.y), b2 = root * u.y;
  s.position = corner + edge[0] * b1 + edge[1] * b2;
  if (!even(*material)) set_uv(s, triangle, b1, b2);
  return s;
}

void Emitter::set_uv(EmitterSample& s, uint32_t t, float b1, float b2) const {
  for (int k = 0; k < 2; ++k) s.uv[k] = mix(mesh->uv[k], mesh->triangles[t], b1, b2);
}

void Emitter::set_triangles(uint32_t first) {
  const auto at = [&](uint32_t vertex) { return transform_point(to_world, mesh->positions[vertex]); };
  const auto& t = mesh->triangles[first];
  triangle = first;
  corner = at(t[0]);
  edge[0] = at(t[1]) - corner, edge[1] = at(t[2]) - corner;
  parallelogram = false;
  if (first + 1 < mesh->triangles.size()) {
    const auto& next = mesh->triangles[first + 1];
    const Vec3 side = at(next[2]) - corner;
    const bool closes = squared_length(edge[0] + side - edge[1]) < 1e-10f * squared_length(edge[1]);
    parallelogram = next[0] == t[0] && next[1] == t[2] && closes;
    if (parallelogram) edge[1] = side;
  }
  const Vec3 across = cross(edge[0], edge[1]) * (glm::determinant(Mat3(to_world)) < 0 ? -1.0f : 1.0f);
  area = length(across) * (parallelogram ? 1 : 0.5f);
  normal = normalize_or(across, {0, 1, 0});
}

float Emitter::area_pdf(Vec3 hit_normal) const {
  return primitive ? 1 / (area * area_scale(to_world, length(hit_normal))) : 1 / area;
}

Rgb Emitter::radiance(const Scene& scene, const Vec2 uv[2]) const {
  if (even(*material)) return material->emission.v;
  const MaterialPoint point = evaluate(scene, *material, uv, Vec4(1));
  return point.emission.v * point.alpha;
}

Rgb Emitter::mean_radiance(const Scene& scene) const {
  if (even(*material)) return material->emission.v;
  constexpr int kSteps = 4;
  Rgb sum;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const EmitterSample s = sample({(float(i) + 0.5f) / kSteps, (float(j) + 0.5f) / kSteps});
      sum += radiance(scene, s.uv);
    }
  return sum / (kSteps * kSteps);
}

namespace {

LampBounds bounds_of(const Light& lamp) {
  LampBounds b;
  b.spread = float(kPi);
  if (const auto* spot = std::get_if<SpotLight>(&lamp)) {
    b.box.add(spot->position);
    b.power = luminance(spot->intensity.v), b.spread = 0;
    b.axis = spot->direction, b.beam = spot->outer_angle;
  } else if (const auto* point = std::get_if<PointLight>(&lamp)) {
    b.box.add(point->position);
    b.power = luminance(point->intensity.v);
  } else if (const auto* luminaire = std::get_if<LuminaireLight>(&lamp)) {
    b.box.add(luminaire->position);
    b.power = luminance(flux(*luminaire)->v) / float(4 * kPi);  // mean intensity
  } else if (const auto* warn = std::get_if<WarnLight>(&lamp)) {
    b.box.add(warn->position);
    b.power = luminance(warn->intensity.v), b.spread = 0;
    b.axis = warn->direction, b.beam = std::min(warn->cone_angle, float(kPi / 2));
  } else if (const auto* rectangle = std::get_if<RectangleLight>(&lamp)) {
    b.box.add(rectangle->corner + (rectangle->edge_u + rectangle->edge_v) * 0.5f);
    b.power = luminance(flux(*rectangle)->v) / float(4 * kPi);
  } else if (const auto* disc = std::get_if<DiscLight>(&lamp)) {
    b.box.add(disc->position);
    b.power = luminance(flux(*disc)->v) / float(4 * kPi);
  }
  return b;
}

}  // namespace

LampBounds Emitter::bounds(const Scene& scene) const {
  if (lamp) return bounds_of(*lamp);
  LampBounds b;
  b.power = luminance(mean_radiance(scene)) * area;
  if (primitive) {
    b.box = PlacedPrimitive(*primitive, to_world).bounds();
    const float scale = std::cbrt(std::abs(glm::determinant(Mat3(to_world))));
    b.power *= scale * scale;
    b.spread = float(kPi);
    if (std::holds_alternative<Disc>(*primitive) && !material->double_sided) {
      b.axis = normalize_or(glm::transpose(glm::inverse(Mat3(to_world))) * Vec3(0, 1, 0), {0, 1, 0});
      b.spread = 0;
    }
    return b;
  }
  for (const Point3 p : {corner, corner + edge[0], corner + edge[1]}) b.box.add(p);
  if (parallelogram) b.box.add(corner + edge[0] + edge[1]);
  b.axis = normal;
  if (material->double_sided) b.spread = float(kPi);
  return b;
}

}  // namespace aktina
