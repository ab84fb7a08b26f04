#include "aktina/radiosity/mesher/leaks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/mesher/box_tree.h"
#include "aktina/radiosity/mesher/contacts.h"
#include "aktina/scene/weld.h"

namespace aktina {
namespace {

constexpr double kMostWidth = 1e-3;  // of the diagonal
constexpr size_t kWorst = 10;

double distance_to_edge(Point3d p, Point3d a, Point3d b) {
  const Vec3d along = b - a;
  return length(p - a - std::clamp(dot(p - a, along) / squared_length(along), 0.0, 1.0) * along);
}

/// Behind a face, seen straight through it, nothing is near: what went through leaves no gap.
double distance(const FlatFace& face, Point3d p, double touch) {
  const size_t n = face.corners.size();
  double nearest = 1e300;
  bool inside = true;
  for (size_t k = 0; k < n; ++k) {
    const Point3d a = face.corners[k], b = face.corners[(k + 1) % n];
    inside = inside && dot(cross(face.normal, b - a), p - a) >= 0;
    nearest = std::min(nearest, distance_to_edge(p, a, b));
  }
  const double before = face.distance(p);
  return !inside ? nearest : before >= -touch ? std::abs(before) : 1e300;
}

/// For each face the piece that it belongs to: faces that share the places of vertices.
std::vector<uint32_t> pieces(const std::vector<FlatFace>& faces) {
  std::vector<Point3> corners;
  std::vector<size_t> first = {0};
  for (const FlatFace& f : faces) {
    for (const Point3d p : f.corners) corners.emplace_back(p);
    first.push_back(corners.size());
  }
  std::vector<uint32_t> piece = weld(corners);  // of corners; the lowest one of a piece names it
  const auto find = [&](uint32_t i) {
    while (piece[i] != i) i = piece[i] = piece[piece[i]];
    return i;
  };
  std::vector<uint32_t> of_face;
  for (size_t f = 0; f < faces.size(); ++f)
    for (size_t k = first[f]; k < first[f + 1]; ++k) {
      const uint32_t a = find(uint32_t(first[f])), b = find(uint32_t(k));
      piece[std::max(a, b)] = std::min(a, b);
    }
  for (size_t f = 0; f < faces.size(); ++f) of_face.push_back(find(uint32_t(first[f])));
  return of_face;
}

/// The edges of the faces, each once, with a face they belong to.
struct Edge {
  Point3d a, b;
  uint32_t face;
};
std::vector<Edge> edges_of(const std::vector<FlatFace>& faces) {
  std::vector<Edge> all;
  std::vector<Point3> middles;
  for (uint32_t f = 0; f < faces.size(); ++f)
    for (size_t k = 0; k < faces[f].corners.size(); ++k) {
      const Point3d a = faces[f].corners[k], b = faces[f].corners[(k + 1) % faces[f].corners.size()];
      all.push_back({a, b, f});
      middles.emplace_back((a + b) * 0.5);
    }
  const std::vector<uint32_t> same = weld(middles);
  std::vector<Edge> once;
  for (size_t i = 0; i < all.size(); ++i)
    if (same[i] == i) once.push_back(all[i]);
  return once;
}

/// The nearest surface of another piece along an edge; width 0 where it touches one, or none is near.
Gap gap_at(const Edge& edge, const std::vector<FlatFace>& faces, const std::vector<uint32_t>& piece,
           const BoxTree& tree, double touch, double most) {
  const Point3d middle = (edge.a + edge.b) * 0.5;
  Gap gap{Point3(middle), most, length(edge.b - edge.a), faces[edge.face].instance, 0};
  Bounds near;
  near.add(Point3(middle) - float(most)), near.add(Point3(middle) + float(most));
  bool found = false;
  tree.touching(near, [&](uint32_t k) {
    if (piece[k] == piece[edge.face]) return;
    const double at_middle = distance(faces[k], middle, touch);
    if (!(at_middle < gap.width)) return;
    gap.width = at_middle, gap.other = faces[k].instance;
    found = true;
  });
  if (!found || gap.width <= touch) gap.width = 0;
  return gap;
}

void add_gaps(const std::vector<FlatFace>& faces, double touch, Leaks& leaks) {
  std::vector<Bounds> boxes;
  for (const FlatFace& f : faces) boxes.push_back(f.box);
  const BoxTree tree(boxes);
  const std::vector<uint32_t> piece = pieces(faces);
  const std::vector<Edge> edges = edges_of(faces);
  std::vector<Gap> gaps(edges.size());
  parallel_for(edges.size(), 256, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) gaps[i] = gap_at(edges[i], faces, piece, tree, touch, leaks.most_width);
  });
  std::erase_if(gaps, [](const Gap& g) { return g.width == 0; });
  leaks.gaps = gaps.size();
  for (const Gap& g : gaps) leaks.gap_length += g.length;
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const Gap& a, const Gap& b) { return a.width * a.length > b.width * b.length; });
  gaps.resize(std::min(gaps.size(), kWorst));
  leaks.worst = gaps;
}

}  // namespace

Leaks find_leaks(const Scene& scene, double most_width) {
  Leaks leaks;
  leaks.complete = triangle_count(scene) <= kMostLeakTriangles;
  if (!leaks.complete) return leaks;
  const SceneFaces surfaces(scene);
  const std::vector<FlatFace> faces = flat_faces(surfaces);
  const double diagonal = double(bounds(surfaces).diagonal()), touch = kTouch * diagonal;
  leaks.most_width = most_width > 0 ? most_width : kMostWidth * diagonal;
  bool too_many = false;
  const std::vector<Contact> lines = find_contacts(faces, touch, 10 * touch, &too_many);
  leaks.complete = !too_many;
  if (too_many) return leaks;
  for (size_t i = 0; i < lines.size(); ++i) {
    leaks.crossed_faces += i == 0 || lines[i].face != lines[i - 1].face;
    leaks.crossing_length += length(lines[i].b - lines[i].a);
  }
  add_gaps(faces, touch, leaks);
  for (Gap& gap : leaks.worst)
    gap.instance = surfaces.instances[gap.instance], gap.other = surfaces.instances[gap.other];
  return leaks;
}

}  // namespace aktina
