#include "aktina/radiosity/mesher/face_cells.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

double distance_to_segment(Point3d p, Point3d a, Point3d b) {
  const Vec3d along = b - a;
  const double squared = squared_length(along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
  return length(p - a - t * along);
}

}  // namespace

bool clip_segment(Point3d a, Point3d b, const FacePolygon& polygon, Vec3d normal, double tolerance, double& from,
                  double& to) {
  from = 0, to = 1;
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Vec3d edge = polygon[(k + 1) % polygon.size()] - polygon[k], inward = cross(normal, edge);
    const double scale = length(inward);
    if (!(scale > 0)) continue;
    const double da = dot(inward, a - polygon[k]) / scale, db = dot(inward, b - polygon[k]) / scale;
    if (da <= tolerance && db <= tolerance) return false;  // outside, or along this edge
    if (da < 0) from = std::max(from, da / (da - db));
    if (db < 0) to = std::min(to, da / (da - db));
  }
  return (to - from) * length(b - a) > tolerance;
}

FacePolygon without_straight_corners(FacePolygon p, double tolerance) {
  for (size_t k = 0; k < p.size() && p.size() >= 3;) {
    const size_t n = p.size();
    if (distance_to_segment(p[k], p[(k + n - 1) % n], p[(k + 1) % n]) <= tolerance)
      p.erase(p.begin() + std::ptrdiff_t(k)), k = 0;
    else
      ++k;
  }
  return p;
}

void cut_into_quads(const FacePolygon& polygon, std::vector<FacePolygon>& parts) {
  const size_t n = polygon.size();
  if (n <= 4) {
    if (n >= 3) parts.push_back(polygon);
    return;
  }
  size_t first = 0, last = 2;
  double least = 1e300;
  for (size_t i = 0; i < n; ++i)
    for (size_t j = i + 2; j < n && j - i <= n - 2; ++j)
      if (const double squared = squared_length(polygon[i] - polygon[j]); squared < least)
        least = squared, first = i, last = j;
  const auto at = [&](size_t k) { return polygon.begin() + std::ptrdiff_t(k); };
  cut_into_quads(FacePolygon(at(first), at(last) + 1), parts);
  FacePolygon rest(at(last), polygon.end());
  rest.insert(rest.end(), polygon.begin(), at(first) + 1);
  cut_into_quads(rest, parts);
}

FaceCells::FaceCells(FacePolygon outline, Vec3d unit_normal, double tolerance)
    : normal_(unit_normal), tolerance_(tolerance), nodes_(1) {
  nodes_[0].cell = 0;
  cells_.push_back(std::move(outline));
}

void FaceCells::cut(Point3d a, Point3d b) {
  const Vec3d across = cross(normal_, b - a);
  const Line line{across / length(across), dot(across, a) / length(across)};
  struct Piece {
    int node;
    Point3d a, b;
  };
  std::vector<Piece> open = {{0, a, b}};
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    if (!(length(piece.b - piece.a) > tolerance_)) continue;
    const Node& node = nodes_[size_t(piece.node)];
    if (node.cell >= 0) {
      split(size_t(piece.node), line);
      continue;
    }
    const double da = node.line.distance(piece.a), db = node.line.distance(piece.b);
    if (std::abs(da) <= tolerance_ && std::abs(db) <= tolerance_) continue;  // cut there already
    if (da >= -tolerance_ && db >= -tolerance_) {
      open.push_back({node.front, piece.a, piece.b});
    } else if (da <= tolerance_ && db <= tolerance_) {
      open.push_back({node.back, piece.a, piece.b});
    } else {
      const Point3d middle = piece.a + (piece.b - piece.a) * (da / (da - db));
      const int first = da > 0 ? node.front : node.back, second = da > 0 ? node.back : node.front;
      open.push_back({first, piece.a, middle});
      open.push_back({second, middle, piece.b});
    }
  }
}

void FaceCells::split(size_t at, const Line& line) {
  const auto cell = size_t(nodes_[at].cell);
  const FacePolygon whole = cells_[cell];
  double low = 0, high = 0;
  for (const Point3d p : whole) low = std::min(low, line.distance(p)), high = std::max(high, line.distance(p));
  if (low >= -tolerance_ || high <= tolerance_) return;
  FacePolygon front, back;
  for (size_t k = 0; k < whole.size(); ++k) {
    const Point3d p = whole[k], q = whole[(k + 1) % whole.size()];
    const double dp = line.distance(p), dq = line.distance(q);
    if (dp >= -tolerance_) front.push_back(p);
    if (dp <= tolerance_) back.push_back(p);
    if ((dp > tolerance_ && dq < -tolerance_) || (dp < -tolerance_ && dq > tolerance_)) {
      const Point3d on = dp > 0 ? p + (q - p) * (dp / (dp - dq)) : q + (p - q) * (dq / (dq - dp));
      front.push_back(on), back.push_back(on);
    }
  }
  cells_[cell] = std::move(front);
  cells_.push_back(std::move(back));
  nodes_[at] = {line, int(nodes_.size()), int(nodes_.size()) + 1, -1};
  nodes_.push_back({{}, -1, -1, int(cell)});
  nodes_.push_back({{}, -1, -1, int(cells_.size()) - 1});
}

}  // namespace aktina
