#include "aktina/raster/shading/split_triangle.h"

#include <algorithm>
#include <tuple>

namespace aktina {

SplitTriangle::SplitTriangle(const CornerValues& c, const Illuminator& light, const HighlightCurve& curve, float least,
                             int depth)
    : curve_(curve), least_(least) {
  for (int v = 0; v < 3; ++v) points_[v] = {c.position[v], c.normal[v], c.light[v], v, v, false};
  parts_[0] = {{0, 1, 2}, {}, 0};
  for (int level = 0, begin = 0; level < depth; ++level) {
    const int end = part_count_, first_point = point_count_;
    for (int part = begin; part < end; ++part) split(light, part);
    light_points(light, first_point);
    begin = end;
  }
}

/// The same answer from both sides of an edge: ends in an order of their own.
bool SplitTriangle::edge_shines(const Illuminator& light, const Part& part, int edge) const {
  const Point *a = &points_[part.corner[edge]], *b = &points_[part.corner[(edge + 1) % 3]];
  const auto place = [](const Point& p) { return std::tuple(p.position.x, p.position.y, p.position.z); };
  if (place(*b) < place(*a)) std::swap(a, b);
  const Point3 position[3] = {a->position, b->position, b->position};
  const Vec3 normal[3] = {a->normal, b->normal, b->normal};
  return std::any_of(light.lamps().begin(), light.lamps().end(), [&](const Lamp& lamp) {
    return may_shine(curve_, least_, lamp, light.viewer(), position, normal);
  });
}

void SplitTriangle::split(const Illuminator& light, int at) {
  const Part part = parts_[at];
  bool own[3], any = false;
  for (int edge = 0; edge < 3; ++edge) any |= own[edge] = !part.linear[edge] && edge_shines(light, part, edge);
  if (!any) {
    const Point* p[3] = {&points_[part.corner[0]], &points_[part.corner[1]], &points_[part.corner[2]]};
    const Point3 position[3] = {p[0]->position, p[1]->position, p[2]->position};
    const Vec3 normal[3] = {p[0]->normal, p[1]->normal, p[2]->normal};
    for (const Lamp& lamp : light.lamps())
      any = any || may_shine(curve_, least_, lamp, light.viewer(), position, normal);
  }
  if (!any) return;
  const auto& [a, b, c] = part.corner;
  const int ab = middle(a, b, own[0]), bc = middle(b, c, own[1]), ca = middle(c, a, own[2]);
  parts_[at].child = part_count_;
  add_child({a, ab, ca}, {!own[0], false, !own[2]});
  add_child({ab, b, bc}, {!own[0], !own[1], false});
  add_child({ca, bc, c}, {false, !own[1], !own[2]});
  add_child({bc, ca, ab}, {false, false, false});
}

/// Parts of one level share the middles of their edges.
int SplitTriangle::middle(int from, int to, bool own) {
  for (int i = 3; i < point_count_; ++i)
    if ((points_[i].from == from && points_[i].to == to) || (points_[i].from == to && points_[i].to == from)) return i;
  const Point &a = points_[from], &b = points_[to];
  Point& p = points_[point_count_];
  p.position = 0.5f * (a.position + b.position), p.normal = normalize_or(a.normal + b.normal, a.normal);
  p.light = {(a.light.diffuse + b.light.diffuse) * 0.5f, (a.light.specular + b.light.specular) * 0.5f};
  p.from = from, p.to = to, p.own = own;
  return point_count_++;
}

void SplitTriangle::add_child(const std::array<int, 3>& corner, const std::array<bool, 3>& linear) {
  parts_[part_count_++] = {{corner[0], corner[1], corner[2]}, {linear[0], linear[1], linear[2]}, 0};
}

/// All new points at once.
void SplitTriangle::light_points(const Illuminator& light, int first) {
  alignas(64) float position[3][padded(kMostPoints)], normal[3][padded(kMostPoints)], lit[6][padded(kMostPoints)];
  int own[kMostPoints];
  size_t count = 0;
  for (int i = first; i < point_count_; ++i) {
    if (!points_[i].own) continue;
    for (int k = 0; k < 3; ++k) position[k][count] = points_[i].position[k], normal[k][count] = points_[i].normal[k];
    own[count++] = i;
  }
  for (size_t i = count; i < padded(count); ++i)
    for (int k = 0; k < 3; ++k) position[k][i] = position[k][0], normal[k][i] = normal[k][0];
  light.evaluate({count, {position[0], position[1], position[2]}, {normal[0], normal[1], normal[2]}},
                 {{lit[0], lit[1], lit[2]}, {lit[3], lit[4], lit[5]}});
  for (size_t i = 0; i < count; ++i)
    points_[own[i]].light = {{lit[0][i], lit[1][i], lit[2][i]}, {lit[3][i], lit[4][i], lit[5][i]}};
}

Lit SplitTriangle::at(float b1, float b2) const {
  float b[3] = {1 - b1 - b2, b1, b2};
  const Part* part = &parts_[0];
  while (part->child != 0) {
    const int which = b[0] >= 0.5f ? 0 : b[1] >= 0.5f ? 1 : b[2] >= 0.5f ? 2 : 3;
    for (int k = 0; k < 3; ++k) b[k] = which == 3 ? 1 - 2 * b[k] : 2 * b[k] - float(k == which);
    part = &parts_[part->child + which];
  }
  Lit sum;
  for (int k = 0; k < 3; ++k) {
    const Lit& corner = points_[part->corner[k]].light;
    sum.diffuse += corner.diffuse * b[k], sum.specular += corner.specular * b[k];
  }
  return sum;
}

void SplitTriangle::shade(const SpanPixels& pixels, const LitArrays& out) const {
  for (size_t i = 0; i < size_t(pixels.count); ++i) {
    const Lit lit = at(pixels.b1[i], pixels.b2[i]);
    for (int k = 0; k < 3; ++k) {
      out.diffuse[k][pixels.output + i] = lit.diffuse[k];
      out.specular[k][pixels.output + i] = lit.specular[k];
    }
  }
}

}  // namespace aktina
