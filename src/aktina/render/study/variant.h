// One method of a family, made ready to draw a scene.
#pragma once

#include <memory>
#include <optional>

#include "aktina/raster/rasterize.h"
#include "aktina/render/study/study.h"

namespace aktina {

/// How the methods of a family are drawn.
struct StudyFamily {
  std::string_view id;
  std::string_view reference;  // a method of the family, an integrator, or kOwnNormals
  bool rasterized;
  void (*choose)(RenderOptions& options, const std::string& method);
};
inline constexpr std::string_view kOwnNormals = "own";  // of the scene, as its file has them

/// @throws Error usage, listing the families
const StudyFamily& find_study_family(std::string_view id);

/// @throws Error no_such_method
RenderOptions options_of(const StudyFamily& family, const std::string& method, const StudyOptions& study);

/// The scene with the vertex normals of a method of family "normals". @throws Error no_such_method
Scene with_normals(const Scene& scene, const std::string& method);

/// A method and the scene that it draws.
class Variant {
 public:
  /// Both must outlive it.
  Variant(const Scene& scene, const StudyFamily& family, const std::string& method, const StudyOptions& study);

  /// Linear, cd/m^2. @throws Error as render()
  Image draw(const Camera& camera, int width, int height, int samples, Progress& outer) const;

  /// One frame after another of the same view, as quickly as the engine can: one sample a pixel where it rasterizes,
  /// the study's samples where it traces.
  class Frames {
   public:
    Frames(const Variant& variant, const Camera& camera, int width, int height);
    void draw(Progress& outer);
    const FrameCost& cost() const { return cost_; }

   private:
    const Variant& variant_;
    const Camera& camera_;
    int width_, height_;
    std::optional<Rasterizer> rasterizer_;
    LayeredImage out_;
    FrameCost cost_;
  };

  const RenderOptions& options() const { return options_; }
  const Scene& scene() const { return own_ ? *own_ : scene_; }
  bool rasterized() const { return rasterized_; }

 private:
  const Scene& scene_;
  std::optional<Scene> own_;
  RenderOptions options_;
  bool rasterized_;
};

}  // namespace aktina
