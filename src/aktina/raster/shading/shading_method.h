// How light is interpolated over a triangle: the one interface of all shading methods.
//
// A method says in its plan what it interpolates; the rasterizer does the rest. It gathers triangles sixteen at a time,
// asks the method for the values at a lattice of points on each (prepare), turns them into polynomials on the screen,
// and scans. What the polynomial gives is
//   - the colour itself (Gouraud, quadratic, ...): written at once, without a call per pixel;
//   - attributes (Phong's normal, ...): visible pixels are handed back, many at a time, to be lit (shade);
//   - nothing: methods that the literature defines on a scanline get whole spans with their two ends (shade_spans).
// A method knows nothing of depth, files or windows, and not which illumination model it interpolates.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "aktina/base/method.h"
#include "aktina/illumination/illuminator.h"

namespace aktina {

struct alignas(64) Lanes {
  float v[kLanes];
  float& operator[](size_t i) { return v[i]; }
  float operator[](size_t i) const { return v[i]; }
};

struct ShadingPlan {
  enum class Kind { colour, attributes, spans };
  /// What a method reads of a TriangleGroup; only that is filled.
  enum Needs : unsigned { kPosition = 1, kNormal = 2, kFaceNormal = 4, kRadiance = 8, kScreen = 16 };

  Kind kind = Kind::colour;
  int degree = 1;            // of the polynomial: 0 to 3
  bool perspective = false;  // polynomial on the surface (perspective-correct); else on the screen
  int channels = 0;          // of attributes; colour has TriangleGroup::channels
  bool normal = false;       // attributes 0 to 2 are a normal, of any length: normal maps bend it
  unsigned needs = 0;
};

/// Barycentric coordinates of the points where a polynomial of degree 0 to 3 is sampled: the centroid; the vertices;
/// vertices and mid-edges 01, 12, 20; vertices, points at 1/3 and 2/3 of the edges 01, 12, 20, and the centroid.
std::span<const std::array<float, 3>> lattice(int degree);

inline constexpr int kMostLatticePoints = 10;

/// Up to sixteen triangles of one material. Lanes from `count` on hold copies of valid ones.
struct TriangleGroup {
  int count;
  Lanes position[3][3];  // [vertex][axis], m, world
  Lanes normal[3][3];    // unit, turned to the side that is seen
  Lanes face_normal[3];  // unit, turned to the side that is seen
  Lanes screen[3][2];    // px
  Lanes weight[3];       // 1 / w of the perspective division; 1 in a parallel projection
  int channels;          // of radiance: 3, all light together; or 6, diffuse and specular apart (textured materials)
  Lanes radiance[3][6];  // at the vertices, cd/m^2: the illumination model with the vertex normals. Of a textured
                         // material: as if it were white, without ambient light

  /// Point of the lattice of a plan: the same place for the two triangles of an edge.
  void interpolate(const Lanes (&vertices)[3][3], const std::array<float, 3>& barycentric, bool perspective,
                   Lanes (&out)[3]) const;
};

/// Values at the lattice points of a group, which prepare() fills.
class Samples {
 public:
  Samples(Lanes* values, int channels) : values_(values), channels_(channels) {}
  Lanes& operator()(int point, int channel) const { return values_[point * channels_ + channel]; }
  int channels() const { return channels_; }
  /// Lit values into the channels of a colour: apart, or summed up where there are three.
  void store(int point, const Lanes (&diffuse)[3], const Lanes (&specular)[3]) const;

 private:
  Lanes* values_;
  int channels_;
};

/// Visible pixels of one material, each array padded to a multiple of kLanes.
struct Fragments {
  size_t count;
  const float* const* channel;   // the plan's attributes
  const float* position[3];      // m, world
  const SurfaceArrays* surface;  // of a textured material; else null
  PointArrays points(const float* const normal[3]) const {
    return {count, {position[0], position[1], position[2]}, {normal[0], normal[1], normal[2]}, surface};
  }
  /// Diffuse light from what was interpolated of TriangleGroup::radiance, with its textures.
  void diffuse_of(const float* const* radiance, const Illuminator& light, const LitArrays& out) const;
};

/// One scanline of one triangle, or as much of it as is seen.
struct Span {
  /// Where the scanline's centre meets an edge: (1 - t) times vertex `from` plus t times vertex `to`, on the screen.
  struct End {
    int from, to;
    float t, x;  // x: px
  };
  End left, right;
  int first, count;  // pixels, whose centres lie at first + 0.5 ...
  float y;           // px
  size_t output;     // index of the first pixel in the arrays that shade_spans writes: a multiple of kLanes
};

class ShadingMethod {
 public:
  virtual ~ShadingMethod() = default;

  virtual ShadingPlan plan(const Illuminator& light) const = 0;

  /// Kinds colour and attributes: values at the lattice points of each triangle.
  virtual void prepare(const TriangleGroup& triangles, const Illuminator& light, const Samples& out) const;
  /// Kind attributes: lights fragments.
  virtual void shade(const Fragments& fragments, const Illuminator& light, const LitArrays& out) const;
  /// Kind spans: lights the spans of triangle `lane` of a group, whose radiance has six channels. Each span's arrays
  /// are padded to a multiple of kLanes, padding is written too; without textures, which come after.
  virtual void shade_spans(const TriangleGroup& triangles, int lane, std::span<const Span> spans,
                           const Illuminator& light, const LitArrays& out) const;
};

using ShadingRow = Method<std::unique_ptr<ShadingMethod>>;
std::span<const ShadingRow* const> shading_methods();

}  // namespace aktina
