// A triangle split in four where it can show a highlight, and its parts again: light that is linear on each part.
#pragma once

#include <array>

#include "aktina/raster/shading/highlight.h"
#include "aktina/raster/shading/span_pixels.h"

namespace aktina {

class SplitTriangle {
 public:
  static constexpr int kDeepest = 4;

  /// @param least  HighlightCurve::cosine_at() the share of a highlight's peak that counts
  SplitTriangle(const CornerValues& corners, const Illuminator& light, const HighlightCurve& curve, float least,
                int depth);

  bool whole() const { return part_count_ == 1; }
  void shade(const SpanPixels& pixels, const LitArrays& out) const;

 private:
  static constexpr int kMostPoints = ((1 << kDeepest) + 1) * ((1 << kDeepest) + 2) / 2;
  static constexpr int kMostParts = ((4 << (2 * kDeepest)) - 1) / 3;

  struct Point {
    Point3 position;
    Vec3 normal;
    Lit light;
    int from, to;  // the ends of the edge it is in the middle of
    bool own;      // it is lit itself; else linear between them
  };
  struct Part {
    int corner[3];   // points
    bool linear[3];  // edges that lie on one without a point of its own: they stay linear
    int child;       // the first of four parts: at corners 0, 1, 2, and between; 0: not split
  };

  void split(const Illuminator& light, int part);
  bool edge_shines(const Illuminator& light, const Part& part, int edge) const;
  int middle(int from, int to, bool own);
  void add_child(const std::array<int, 3>& corner, const std::array<bool, 3>& linear);
  void light_points(const Illuminator& light, int first);
  Lit at(float b1, float b2) const;

  const HighlightCurve& curve_;
  float least_;
  int point_count_ = 3, part_count_ = 1;
  Point points_[kMostPoints];
  Part parts_[kMostParts];
};

}  // namespace aktina
