// Mesa's software rasterizer, llvmpipe, drawing a mesh lit by three point lights through EGL and OpenGL: the peer of
// the raster benchmark.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "aktina/scene/scene.h"

namespace aktina::bench {

class Llvmpipe {
 public:
  /// Draws mesh 0 of a scene of one classic material and point lights, into a size x size RGBA8 picture.
  /// @param threads  rasterizer threads; 0: all in the calling thread
  Llvmpipe(const Scene& scene, int size, int threads);
  ~Llvmpipe();

  /// Empty where all went well; else why there is nothing to compare with.
  const std::string& missing() const { return missing_; }
  const std::string& renderer() const { return renderer_; }

  /// A whole frame: clear, draw, finish. @param per_pixel  Phong's shading; else Gouraud's
  void draw(bool per_pixel);
  /// The picture: size x size x 3, rows from top to bottom, 0 to 1.
  std::vector<float> read() const;

 private:
  struct Context;
  std::unique_ptr<Context> context_;
  std::string missing_, renderer_;
};

}  // namespace aktina::bench
