#include "aktina/radiosity/mesher/contacts.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/radiosity/mesher/box_tree.h"
#include "aktina/radiosity/mesher/junctions.h"

namespace aktina {
namespace {

constexpr double kShortest = 1.0 / 16;  // of a patch
constexpr double kMostPerPatch = 4;     // lines
constexpr double kMostPairs = 5e7;
constexpr size_t kProbes = 256;    // faces whose neighbours are counted first
constexpr double kStraight = 0.5;  // of the tolerance of junctions: they find what is left out as straight

/// Lines on `on`, along which `other` lies in its plane or goes through it.
class Meeting {
 public:
  Meeting(const FlatFace& on, const FlatFace& other, double touch, double shortest, double tolerance)
      : on_(on), touch_(touch), shortest_(shortest), tolerance_(tolerance) {
    for (const Point3d p : other.corners) distances_.push_back(on.distance(p));
    corners_ = &other.corners;
  }

  template <class Body>
  void each_line(const Body& body) const {
    const auto [low, high] = std::minmax_element(distances_.begin(), distances_.end());
    if (*low > touch_ || *high < -touch_) return;
    const size_t n = corners_->size();
    for (size_t k = 0; k < n; ++k)
      if (near(k) && near((k + 1) % n)) clip((*corners_)[k], (*corners_)[(k + 1) % n], body);
    if (*low >= -touch_ || *high <= touch_) return;
    Point3d ends[2];
    if (crossing(ends) == 2) clip(ends[0], ends[1], body);
  }

 private:
  bool near(size_t k) const { return std::abs(distances_[k]) <= touch_; }

  /// Where the outline goes through the plane: twice, as it is convex.
  int crossing(Point3d ends[2]) const {
    int found = 0;
    for (size_t k = 0; k < corners_->size() && found < 2; ++k) {
      const size_t next = (k + 1) % corners_->size();
      const double d = distances_[k], e = distances_[next];
      if (near(k))
        ends[found++] = (*corners_)[k];
      else if (!near(next) && (d > 0) != (e > 0))
        ends[found++] = (*corners_)[k] + ((*corners_)[next] - (*corners_)[k]) * (d / (d - e));
    }
    return found;
  }

  template <class Body>
  void clip(Point3d a, Point3d b, const Body& body) const {
    a = on_.projected(a), b = on_.projected(b);
    double from, to;
    if (!clip_segment(a, b, on_.corners, on_.normal, tolerance_, from, to)) return;
    if ((to - from) * length(b - a) >= shortest_) body(a + (b - a) * from, a + (b - a) * to);
  }

  const FlatFace& on_;
  const std::vector<Point3d>* corners_;
  std::vector<double> distances_;
  double touch_, shortest_, tolerance_;
};

/// Pairs of boxes that touch, from a sample.
double estimated_pairs(const BoxTree& tree, std::span<const Bounds> boxes) {
  const size_t step = std::max<size_t>(1, boxes.size() / kProbes);
  double pairs = 0, probes = 0;
  for (size_t i = 0; i < boxes.size() && pairs < kMostPairs; i += step, ++probes)
    tree.touching(boxes[i], [&](uint32_t) { ++pairs; });
  return probes > 0 ? pairs / probes * double(boxes.size()) / 2 : 0;
}

Bounds grown(Bounds b, float by) { return {b.low - by, b.high + by}; }

/// Long lines first, as they divide a face best; those of about one length in random order, which keeps trees flat.
void order(std::vector<Contact>& lines) {
  std::vector<std::tuple<int, uint32_t, uint32_t>> keys;
  for (uint32_t i = 0; i < lines.size(); ++i)
    keys.emplace_back(-std::ilogb(length(lines[i].b - lines[i].a)), hash32(i), i);
  std::sort(keys.begin(), keys.end());
  std::vector<Contact> sorted;
  for (const auto& [size, hash, i] : keys) sorted.push_back(lines[i]);
  lines = std::move(sorted);
}

/// The longest `most` of them, and as many as are as long as the shortest of these.
void keep_longest(std::vector<Contact>& lines, size_t most, Warnings& warnings) {
  if (lines.size() <= most) return;
  std::vector<double> lengths;
  for (const Contact& c : lines) lengths.push_back(length(c.b - c.a));
  std::nth_element(lengths.begin(), lengths.begin() + std::ptrdiff_t(most), lengths.end(), std::greater<>());
  const double least = lengths[most] * (1 + 1e-5);
  const size_t before = lines.size();
  std::erase_if(lines, [&](const Contact& c) { return length(c.b - c.a) <= least; });
  warnings.add("lines of contact are left out of the mesh: there are too many short ones", before - lines.size());
}

FaceParts cut(const FlatFace& face, std::vector<Contact> lines, double tolerance) {
  order(lines);
  FaceCells cells(face.corners, face.normal, tolerance);
  for (const Contact& line : lines) cells.cut(line.a, line.b);
  FaceParts parts{face.instance, face.face, {}};
  if (cells.cells().size() > 1)
    for (const FacePolygon& cell : cells.cells())
      cut_into_quads(without_straight_corners(cell, kStraight * tolerance), parts.parts);
  return parts;
}

}  // namespace

std::vector<Contact> find_contacts(const std::vector<FlatFace>& faces, double touch, double shortest, bool* too_many) {
  std::vector<uint32_t> large;  // no line on a face is longer than the other face
  std::vector<Bounds> boxes;
  Bounds all;
  for (uint32_t i = 0; i < faces.size(); ++i) {
    all.add(faces[i].box);
    if (faces[i].diameter() < shortest) continue;
    large.push_back(i);
    boxes.push_back(grown(faces[i].box, float(touch)));
  }
  const BoxTree tree(boxes);
  *too_many = estimated_pairs(tree, boxes) > kMostPairs;
  if (*too_many) return {};
  const double tolerance = double(kJunctionTolerance * all.diagonal());
  std::vector<std::vector<Contact>> found(large.size());
  parallel_for(large.size(), 64, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      tree.touching(boxes[i], [&](uint32_t k) {
        if (k == i) return;
        Meeting(faces[large[i]], faces[large[k]], touch, shortest, tolerance).each_line([&](Point3d a, Point3d b) {
          found[i].push_back({large[i], a, b});
        });
      });
  });
  std::vector<Contact> lines;
  for (const auto& each : found) lines.insert(lines.end(), each.begin(), each.end());
  return lines;
}

void cut_at_contacts(SceneFaces& faces, double patch_size, Warnings& warnings) {
  const std::vector<FlatFace> flat = flat_faces(faces);
  const double diagonal = double(bounds(faces).diagonal());
  bool too_many = false;
  std::vector<Contact> lines = find_contacts(flat, kTouch * diagonal, kShortest * patch_size, &too_many);
  if (too_many) warnings.add("lines of contact are left out of the mesh: too many surfaces are near each other");
  keep_longest(lines, size_t(kMostPerPatch * faces.area() / (patch_size * patch_size)) + 1000, warnings);
  cut_along(faces, flat, lines);
}

void cut_along(SceneFaces& faces, const std::vector<FlatFace>& flat, const std::vector<Contact>& lines) {
  const double diagonal = double(bounds(faces).diagonal());
  std::vector<size_t> first;  // of each face that is cut
  for (size_t i = 0; i < lines.size(); ++i)
    if (i == 0 || lines[i].face != lines[i - 1].face) first.push_back(i);
  first.push_back(lines.size());
  std::vector<FaceParts> parts(first.size() - 1);
  parallel_for(parts.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      parts[i] = cut(flat[lines[first[i]].face],
                     {lines.begin() + std::ptrdiff_t(first[i]), lines.begin() + std::ptrdiff_t(first[i + 1])},
                     double(kJunctionTolerance) * diagonal);
  });
  std::erase_if(parts, [](const FaceParts& p) { return p.parts.empty(); });
  replace_faces(faces, parts);
}

}  // namespace aktina
