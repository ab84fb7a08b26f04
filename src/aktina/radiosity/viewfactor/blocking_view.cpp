#include "aktina/radiosity/viewfactor/blocking_view.h"

#include <algorithm>
#include <cmath>

namespace aktina {

template <class T>
void BlockingView<T>::set(const Blocker& blocker, const Leaf& receiver, const Leaf& source, const Place& place,
                          double tolerance) {
  blocker_ = &blocker, receiver_ = &receiver, source_ = &source, place_ = place, tolerance_ = float(tolerance);
  of_receiver.set(receiver, blocker, tolerance);
  of_source.set(source, blocker, tolerance);
  cut_ = false;
}

template <class T>
void BlockingView<T>::cut() {
  if (cut_) return;
  cut_ = true;
  parts_.clear(), contours_.clear(), polygons_.clear(), outlines_.clear();
  for (const Contour& face : blocker_->faces) {
    const Contour& part = parts_.emplace_back(clip(clip(face, lifted(receiver_->plane), 0), lifted(source_->plane), 0));
    if (!part.empty()) contours_.push_back(part);
    if (part.size() > kMostBlocking) continue;
    BlockingPolygon<T>& polygon = polygons_.emplace_back();
    polygon = {};
    place(part, polygon);
    polygon.two_sided = !blocker_->closed, polygon.closed = blocker_->closed;
    Vec3d normal(0);
    for (size_t k = 2; k < face.size(); ++k) normal += cross(face[k - 1] - face[0], face[k] - face[0]);
    normal = normalize(normal);
    for (int k = 0; k < 3; ++k) polygon.normal[k] = T(normal[k]);
    polygon.offset = T(dot(normal, face[0] - place_.origin) / place_.unit);
  }
  if (!polygons_.empty()) polygons_[0].first = true;
}

template <class T>
void BlockingView<T>::place(const Contour& contour, BlockingPolygon<T>& polygon) const {
  polygon.count = int(contour.size());
  for (size_t k = 0; k < contour.size(); ++k)
    for (int axis = 0; axis < 3; ++axis)
      polygon.corners[k][axis] = T((contour[k][axis] - place_.origin[axis]) / place_.unit);
}

/// Edges that lie in the planes of receiver or source would coincide with those of the source.
template <class T>
Plane BlockingView<T>::lifted(const Plane& plane) const {
  return {plane.point + (sizeof(T) == 4 ? 1e-6 : 1e-11) * place_.unit * plane.normal, plane.normal};
}

template <class T>
const std::vector<Contour>& BlockingView<T>::contours() {
  cut();
  return contours_;
}

template <class T>
std::span<const BlockingPolygon<T>> BlockingView<T>::seen_from(size_t receiver_lane) {
  cut();
  if (const std::optional<uint32_t> faces = fronts(receiver_lane))
    if (const Outline& o = outline(*faces); o.usable) return {&o.polygon, 1};
  return polygons_;
}

template <class T>
std::optional<uint32_t> BlockingView<T>::fronts(size_t lane) const {
  uint32_t faces = 0;
  for (size_t k = 0; k < blocker_->faces.size(); ++k) {
    float low = INFINITY, high = -INFINITY;
    for (size_t c = 0; c < 4; ++c) {
      const float h = of_receiver.height(lane, c, k);
      low = std::min(low, h), high = std::max(high, h);
    }
    if (low < -tolerance_ && high > tolerance_) return std::nullopt;
    if (high > tolerance_) faces |= 1U << k;
    if (!blocker_->closed && high <= tolerance_ && low >= -tolerance_) return std::nullopt;
  }
  if (blocker_->closed && faces == 0) return std::nullopt;  // inside
  return faces;
}

template <class T>
const typename BlockingView<T>::Outline& BlockingView<T>::outline(uint32_t faces) {
  for (const Outline& known : outlines_)
    if (known.faces == faces) return known;
  const Contour contour = outline_of(faces);
  Outline& made = outlines_.emplace_back();
  made.faces = faces, made.usable = contour.size() >= 3 && contour.size() <= kMostBlocking;
  made.polygon = {};
  if (!made.usable) return made;
  place(contour, made.polygon);
  made.polygon.offset = -1, made.polygon.first = true;
  return made;
}

/// Edges of these faces that no two of them share, in order; empty where they are no single loop.
template <class T>
Contour BlockingView<T>::outline_of(uint32_t faces) const {
  if (!blocker_->closed) {
    Contour seen = parts_[0];
    if (faces == 0) std::reverse(seen.begin(), seen.end());
    return seen;
  }
  std::vector<std::pair<Point3d, Point3d>> edges;
  for (size_t k = 0; k < parts_.size(); ++k)
    if (faces >> k & 1)
      for (size_t c = 0; c < parts_[k].size(); ++c) {
        const Point3d from = parts_[k][c], to = parts_[k][c + 1 == parts_[k].size() ? 0 : c + 1];
        const auto twin = std::find(edges.begin(), edges.end(), std::pair(to, from));
        if (twin == edges.end())
          edges.emplace_back(from, to);
        else
          edges.erase(twin);
      }
  Contour loop;
  if (edges.empty()) return loop;
  const Point3d begin = edges[0].first;
  Point3d at = begin;
  do {
    const auto next = std::find_if(edges.begin(), edges.end(), [&](const auto& edge) { return edge.first == at; });
    if (next == edges.end()) return {};
    loop.push_back(at);
    at = next->second;
    edges.erase(next);
  } while (at != begin);
  return edges.empty() ? loop : Contour{};
}

template class BlockingView<float>;
template class BlockingView<double>;

}  // namespace aktina
