// Mesa's software rasterizer, llvmpipe, through EGL and OpenGL: the peer of the raster benchmark, where it draws a mesh
// lit by three point lights, and of the hemicube, where it draws which triangle is seen.
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

/// Item buffers: which triangle each pixel sees.
class LlvmpipeItems {
 public:
  /// Pictures of size x size.
  LlvmpipeItems(const Mesh& mesh, int size, int threads);
  ~LlvmpipeItems();
  const std::string& missing() const { return missing_; }

  /// The upper `rows` rows of the picture, from the bottom one of them up: 1 + triangle, 0: nothing. Draws and reads.
  void draw(const Camera& camera, int rows, std::vector<uint32_t>& items);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
  std::string missing_;
};

}  // namespace aktina::bench
