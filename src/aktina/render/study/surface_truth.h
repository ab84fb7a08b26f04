// Places on a scene's surfaces and the light there, path traced: what radiosity solutions are held against.
#pragma once

#include <vector>

#include "aktina/radiosity/solution.h"
#include "aktina/render/study/study.h"

namespace aktina {

/// The scene as radiosity takes it: metals and gloss scatter evenly, glass is opaque.
Scene matt_scene(const Scene& scene);

class SurfaceTruth {
 public:
  /// @param scene  without primitives; must outlive this. @throws Error as measure_illuminance()
  SurfaceTruth(const Scene& scene, uint32_t seed, Progress& progress);

  /// Relative errors of the illuminance at the places that some light reaches.
  struct Errors {
    double median = kNotMeasured, rms = kNotMeasured;  // evenly over the surfaces; rms without the worst 5 %
    double contact = kNotMeasured;                     // median near where surfaces meet
  };
  Errors errors(const Solution& solution) const;

  size_t size() const { return places_.size(); }
  double noise() const { return noise_; }  // standard error of the light over its mean

 private:
  struct Place {
    Point3 position;  // on the surface
    Vec3 normal;
    bool contact = false, any = false;  // belongs to the places near contacts; to those evenly over the surfaces
    double lux = 0;
  };
  void choose_places(uint32_t seed);
  void mark_contacts(std::vector<Place>& places) const;
  std::vector<double> light_of(const Solution& solution) const;

  const Scene& scene_;
  float size_;  // m, of the scene
  std::vector<Place> places_;
  double mean_ = 0, noise_ = 0;
};

}  // namespace aktina
