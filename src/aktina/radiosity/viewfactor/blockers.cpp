#include "aktina/radiosity/viewfactor/blockers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "aktina/radiosity/viewfactor/merge.h"
#include "aktina/radiosity/viewfactor/welder.h"

namespace aktina {
namespace {

using Edge = std::pair<uint32_t, uint32_t>;

class BlockerFinder {
 public:
  BlockerFinder(const Faces& faces, double shrink) : faces_(faces), shrink_(shrink) {
    double size = 0;
    for (const auto* list : {&faces.surfaces(), &faces.occluders()})
      for (const Face& face : *list) {
        if (face.hides) all_.push_back(&face);
        size = std::max(size, length(face.centre - faces[0].centre) + face.radius);
      }
    tolerance_ = 1e-9 * size + 4e-15 * length(faces[0].centre);
  }

  std::vector<Blocker> run() {
    std::vector<uint32_t> groups;
    polygons_ = merge_coplanar(all_, tolerance_, groups);
    for (const std::vector<size_t>& part : connected_parts())
      if (std::optional<Blocker> body = convex_body(part))
        result_.push_back(std::move(*body));
      else
        for (const size_t i : part)
          if (parts_the_scene(polygons_[i].plane)) result_.push_back(sheet(polygons_[i]));
    return std::move(result_);
  }

 private:
  /// Polygons that share whole edges.
  std::vector<std::vector<size_t>> connected_parts() {
    Welder welder(8 * tolerance_);
    std::map<Edge, size_t> owner;
    edges_.resize(polygons_.size());
    for (size_t i = 0; i < polygons_.size(); ++i) {
      const Contour& v = polygons_[i].vertices;
      for (size_t k = 0; k < v.size(); ++k) {
        edges_[i].emplace_back(welder.id(v[k]), welder.id(v[(k + 1) % v.size()]));
        owner[edges_[i].back()] = i;
      }
    }
    DisjointSets sets(polygons_.size());
    for (const auto& [edge, i] : owner)
      if (const auto other = owner.find({edge.second, edge.first}); other != owner.end()) sets.join(i, other->second);
    std::map<size_t, std::vector<size_t>> parts;
    for (size_t i = 0; i < polygons_.size(); ++i) parts[sets.find(i)].push_back(i);
    std::vector<std::vector<size_t>> result;
    for (auto& [root, part] : parts) result.push_back(std::move(part));
    return result;
  }

  /// Whether surfaces reach to both sides: nothing else can hide them from each other.
  bool parts_the_scene(const Plane& plane) {
    const auto cell = [](double x) { return int64_t(std::llround(x * 1e12)); };
    const double size = tolerance_ * 1e9, offset = dot(plane.normal, plane.point - faces_[0].centre) / size;
    const auto [at, fresh] =
        parting_.try_emplace({cell(plane.normal.x), cell(plane.normal.y), cell(plane.normal.z), cell(offset)}, false);
    if (fresh) at->second = is_between(plane);
    return at->second;
  }
  bool is_between(const Plane& plane) const {
    bool front = false, back = false;
    for (const Face& face : faces_.surfaces())
      for (const Point3d& v : face.vertices) {
        const double h = plane.height(v);
        front = front || h > tolerance_, back = back || h < -tolerance_;
        if (front && back) return true;
      }
    return false;
  }

  /// Polygons whose fronts all look away from each other and that close a body, or do but for an opening that lies in
  /// the outermost plane of the scene, as a box on the ground without a bottom.
  std::optional<Blocker> convex_body(const std::vector<size_t>& part) {
    if (part.size() < 3 || part.size() >= Blocker::kMostBounds) return std::nullopt;
    for (const size_t i : part)
      for (const size_t k : part)
        for (const Point3d& v : polygons_[k].vertices)
          if (polygons_[i].plane.height(v) > 4 * tolerance_) return std::nullopt;
    Blocker body;
    body.closed = true;
    for (const size_t i : part) body.bounds.push_back(polygons_[i].plane);
    if (!closes(part, body)) return std::nullopt;
    if (!std::any_of(part.begin(), part.end(), [&](size_t i) { return parts_the_scene(polygons_[i].plane); }))
      return std::nullopt;
    draw_in(part, body);
    bound(body);
    if (is_entered(body)) return std::nullopt;
    return body;
  }

  /// Whether two surfaces reach into the body: there they may see each other, as they never do through a solid one.
  bool is_entered(const Blocker& body) const {
    int count = 0;
    for (const Face& face : faces_.surfaces()) {
      const double reach = face.radius + body.radius;
      if (squared_length(face.centre - body.centre) > reach * reach) continue;
      for (const Contour& piece : face.convex) {
        Contour within = piece;
        for (size_t k = 0; k < body.bounds.size() && !within.empty(); ++k)
          within = clip(within, {body.bounds[k].point, -body.bounds[k].normal}, 8 * tolerance_);
        if (within.empty()) continue;
        if (++count == 2) return true;
        break;
      }
    }
    return false;
  }

  /// Each corner by itself, so that faces go on sharing theirs.
  void draw_in(const std::vector<size_t>& part, Blocker& body) const {
    Point3d middle(0);
    double count = 0;
    for (const size_t i : part)
      for (const Point3d& v : polygons_[i].vertices) middle += v, ++count;
    middle /= count;
    std::map<uint32_t, Point3d> corners;
    for (const size_t i : part) {
      Contour& face = body.faces.emplace_back();
      for (size_t k = 0; k < polygons_[i].vertices.size(); ++k) {
        const Point3d v = polygons_[i].vertices[k];
        const auto [at, fresh] = corners.try_emplace(edges_[i][k].first, v);
        if (fresh) at->second = v + drawn_in(corners.size()) * (middle - v);
        face.push_back(at->second);
      }
    }
  }
  /// A little differently at each corner: edges must not stay parallel to what they coincided with.
  double drawn_in(size_t k) const { return shrink_ * (1 + 0.37 * double(k % 3) + 0.11 * double(k % kMostCorners)); }

  bool closes(const std::vector<size_t>& part, Blocker& body) const {
    std::map<Edge, Point3d> edges;
    for (const size_t i : part)
      for (size_t k = 0; k < edges_[i].size(); ++k)
        if (!edges.try_emplace(edges_[i][k], polygons_[i].vertices[k]).second) return false;
    Contour rim;
    for (const auto& [edge, from] : edges)
      if (!edges.contains({edge.second, edge.first})) rim.push_back(from);
    if (rim.empty()) return part.size() >= 4;
    return rim.size() >= 3 && covers(rim, part, body);
  }

  bool covers(const Contour& rim, const std::vector<size_t>& part, Blocker& body) const {
    Vec3d normal(0);
    for (size_t k = 2; k < rim.size() && normal == Vec3d(0); ++k) normal = cross(rim[1] - rim[0], rim[k] - rim[0]);
    if (!(length(normal) > 0)) return false;
    Plane cover{rim[0], normalize(normal)};
    double high = 0, low = 0;
    for (const size_t i : part)
      for (const Point3d& v : polygons_[i].vertices)
        high = std::max(high, cover.height(v)), low = std::min(low, cover.height(v));
    if (std::min(high, -low) > 4 * tolerance_) return false;  // the rest is on both sides
    if (high > 4 * tolerance_) cover.normal = -cover.normal;
    for (const Point3d& v : rim)
      if (std::abs(cover.height(v)) > 4 * tolerance_) return false;
    for (const Face& face : faces_.surfaces())
      for (const Point3d& v : face.vertices)
        if (cover.height(v) > 4 * tolerance_) return false;
    body.bounds.push_back(cover);
    return true;
  }

  Blocker sheet(const ConvexPolygon& polygon) const {
    Blocker blocker;
    const Contour& v = polygon.vertices;
    blocker.bounds = {polygon.plane, {polygon.plane.point, -polygon.plane.normal}};
    for (size_t k = 0; k < v.size(); ++k) {
      const Vec3d outward = cross(v[(k + 1) % v.size()] - v[k], polygon.plane.normal);
      if (const double norm = length(outward); norm > 0) blocker.bounds.push_back({v[k], outward / norm});
    }
    blocker.faces = {shrunken(v)};
    bound(blocker);
    return blocker;
  }

  Contour shrunken(const Contour& contour) const {
    Point3d middle(0);
    for (const Point3d& v : contour) middle += v / double(contour.size());
    Contour result;
    for (size_t k = 0; k < contour.size(); ++k) result.push_back(contour[k] + drawn_in(k) * (middle - contour[k]));
    return result;
  }

  static void bound(Blocker& blocker) {
    Point3d low(INFINITY), high(-INFINITY);
    for (const Contour& face : blocker.faces)
      for (const Point3d& v : face) low = glm::min(low, v), high = glm::max(high, v);
    blocker.centre = 0.5 * (low + high), blocker.radius = 0.5 * length(high - low);
  }

  const Faces& faces_;
  double shrink_, tolerance_;
  std::vector<const Face*> all_;
  std::vector<ConvexPolygon> polygons_;
  std::vector<std::vector<Edge>> edges_;
  std::map<std::array<int64_t, 4>, bool> parting_;  // planes that have been asked for
  std::vector<Blocker> result_;
};

}  // namespace

std::vector<Blocker> find_blockers(const Faces& faces, double shrink) { return BlockerFinder(faces, shrink).run(); }

BlockerTree::BlockerTree(std::vector<Blocker> blockers) : blockers_(std::move(blockers)) {
  if (!blockers_.empty()) build(0, uint32_t(blockers_.size()));
}

uint32_t BlockerTree::build(uint32_t first, uint32_t count) {
  const auto at = uint32_t(nodes_.size());
  Point3d low(INFINITY), high(-INFINITY);
  for (uint32_t k = first; k < first + count; ++k)
    low = glm::min(low, blockers_[k].centre), high = glm::max(high, blockers_[k].centre);
  Node node{0.5 * (low + high), 0, first, count, 0};
  for (uint32_t k = first; k < first + count; ++k)
    node.radius = std::max(node.radius, length(blockers_[k].centre - node.centre) + blockers_[k].radius);
  nodes_.push_back(node);
  if (count == 1) return at;
  const Vec3d size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const uint32_t half = count / 2;
  std::stable_sort(blockers_.begin() + first, blockers_.begin() + first + count,
                   [&](const Blocker& a, const Blocker& b) { return a.centre[axis] < b.centre[axis]; });
  build(first, half);
  const uint32_t right = build(first + half, count - half);
  nodes_[at].right = right;
  return at;
}

void BlockerTree::find(Point3d a, Point3d b, double reach, size_t most, std::vector<uint32_t>& found) const {
  if (nodes_.empty()) return;
  const Vec3d axis = b - a;
  const double squared = squared_length(axis);
  uint32_t stack[64], depth = 0;
  stack[depth++] = 0;
  while (depth > 0 && found.size() <= most) {
    const uint32_t at = stack[--depth];
    const Node& node = nodes_[at];
    const Vec3d to = node.centre - a;
    const double t = squared > 0 ? std::clamp(dot(to, axis) / squared, 0.0, 1.0) : 0, limit = reach + node.radius;
    if (squared_length(to - t * axis) > limit * limit) continue;
    if (node.count == 1)
      found.push_back(node.first);
    else
      stack[depth++] = node.right, stack[depth++] = at + 1;
  }
}

}  // namespace aktina
