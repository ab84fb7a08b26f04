// Vectors and coefficients of many points at a time. Included by *_simd.* files, once for each instruction set.

#if defined(AKTINA_ILLUMINATION_COEFFICIENTS_SIMD_H_) == defined(HWY_TARGET_TOGGLE)  // per-target include guard
#ifdef AKTINA_ILLUMINATION_COEFFICIENTS_SIMD_H_
#undef AKTINA_ILLUMINATION_COEFFICIENTS_SIMD_H_
#else
#define AKTINA_ILLUMINATION_COEFFICIENTS_SIMD_H_
#endif

#include <algorithm>

#include "aktina/base/simd.h"
#include "aktina/illumination/illuminator.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {

struct V3 {
  F x, y, z;
};
HWY_INLINE V3 broadcast(Vec3 v) { return {set(v.x), set(v.y), set(v.z)}; }
HWY_INLINE V3 load3(const float* const p[3], size_t i) { return {load(p[0] + i), load(p[1] + i), load(p[2] + i)}; }
HWY_INLINE V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE V3 operator*(V3 a, F s) { return {a.x * s, a.y * s, a.z * s}; }
HWY_INLINE F dot(V3 a, V3 b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }
HWY_INLINE V3 cross(V3 a, V3 b) {
  return {hn::MulSub(a.y, b.z, a.z * b.y), hn::MulSub(a.z, b.x, a.x * b.z), hn::MulSub(a.x, b.y, a.y * b.x)};
}
HWY_INLINE F inverse_length(F squared) { return reciprocal_sqrt(hn::Max(squared, set(1e-30f))); }
HWY_INLINE V3 normalized(V3 v) { return v * inverse_length(dot(v, v)); }

/// What models read of a surface. Beyond ka, kd, ks and exponent only what the model at hand asks for is set.
struct Coefficients {
  F ka[3], kd[3], ks[3];
  F exponent, ior;
  F width, width_across;  // of the lobe, in the model's own terms
  // glTF's model: specular reflectance is ks + grazing w in Schlick's weight w; the body gets 1 - the coat's largest
  F grazing[3], coat_most, coat_grazing;
};

/// number(surface) of kPart points from i on, or of the one surface of all points. Neighbours whose `key` is the same
/// share it.
class SurfaceReader {
 public:
  SurfaceReader(const Surface& all, const PointArrays& points, size_t i)
      : all_(all), whole_(points.surface ? points.surface->whole : nullptr), first_(i), last_(points.count - 1) {}
  template <class Number>
  HWY_INLINE F operator()(Number number) const {
    return (*this)(number, number);
  }
  template <class Key, class Number>
  HWY_INLINE F operator()(Key key, Number number) const {
    if (!whole_) return set(number(all_));
    alignas(64) float values[kPart];
    float before = 0;
    for (size_t k = 0; k < kPart; ++k) {
      const Surface& s = whole_[std::min(first_ + k, last_)];
      const float here = key(s);
      values[k] = k > 0 && here == before ? values[k - 1] : number(s);
      before = here;
    }
    return load(values);
  }

 private:
  const Surface& all_;
  const Surface* whole_;
  size_t first_, last_;
};

inline float roughness_of(const Surface& s) { return s.roughness; }
inline float ior_of(const Surface& s) { return s.ior; }

template <class Model>
HWY_INLINE void fill_lobe(const Model&, const SurfaceReader&, Coefficients&) {}
HWY_INLINE void fill_lobe(const Phong& model, const SurfaceReader& read, Coefficients& c) {
  if (model.fresnel) c.ior = read(ior_of);
}
HWY_INLINE void fill_lobe(const TorranceSparrow& model, const SurfaceReader& read, Coefficients& c) {
  c.ior = read(ior_of);
  c.width = read([](const Surface& s) { return s.exponent; }, [&](const Surface& s) { return model.width(s); });
}
HWY_INLINE void fill_lobe(const CookTorrance& model, const SurfaceReader& read, Coefficients& c) {
  c.ior = read(ior_of);
  c.width = read(roughness_of, [&](const Surface& s) { return model.slope > 0 ? model.slope : facet_slope(s); });
}
HWY_INLINE void fill_lobe(const Ward& model, const SurfaceReader& read, Coefficients& c) {
  c.width = read(roughness_of, [&](const Surface& s) { return model.widths(s).x; });
  c.width_across = read(roughness_of, [&](const Surface& s) { return model.widths(s).y; });
}
HWY_INLINE void fill_lobe(const Ggx&, const SurfaceReader& read, Coefficients& c) {
  c.width = read(roughness_of, ggx_width);
  const F metallic = read([](const Surface&s) { return s.metallic; }), dielectric = set(1.0f) - metallic;
  const F body = dielectric * read([](const Surface& s) { return 1 - s.transmission; });
  c.coat_grazing = read([](const Surface& s) { return s.specular_weight; });
  c.coat_most = zero();
  for (int k = 0; k < 3; ++k) {
    const F base = read([k](const Surface& s) { return s.base[k]; });
    const F coat = read([k](const Surface& s) { return dielectric_reflectance(s)[k]; });
    c.coat_most = hn::Max(c.coat_most, coat);
    c.kd[k] = base * body;
    c.ks[k] = fma(dielectric, coat, metallic * base);
    c.grazing[k] = fma(dielectric, c.coat_grazing - coat, metallic * (set(1.0f) - base));
  }
}

template <class Model>
HWY_INLINE void fill(const Model& model, const Surface& s, const PointArrays& points, size_t i, Coefficients& c) {
  const SurfaceArrays* textured = points.surface;
  c.exponent = hn::Max(textured ? load(textured->exponent + i) : set(s.exponent), zero());
  for (int k = 0; k < 3; ++k) {
    c.ka[k] = textured ? load(textured->ka[k] + i) : set(s.ka[k]);
    c.kd[k] = textured ? load(textured->kd[k] + i) : set(s.kd[k]);
    c.ks[k] = textured ? load(textured->ks[k] + i) : set(s.ks[k]);
  }
  fill_lobe(model, SurfaceReader(s, points, i), c);
}

}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
