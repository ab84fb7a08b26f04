// Which triangle each pixel sees, for many views of one scene: item buffers, as hemicubes need them.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "aktina/base/function_ref.h"
#include "aktina/raster/block_buffer.h"
#include "aktina/scene/scene.h"

namespace aktina {

struct ItemBuffer {
  static constexpr uint32_t kNothing = 0xffffffff;
  int width = 0, height = 0;
  std::vector<uint32_t> item;   // rows from top to bottom: index of a triangle, or kNothing
  std::vector<float> distance;  // along the view axis, m; infinite where nothing is seen
};

/// Built once, drawn from many places. draw() may be called from many threads at a time; each call works in its own
/// thread, keeps its memory for later calls, and so costs little beyond its triangles and pixels.
class ItemRasterizer {
 public:
  /// Items count the triangles through, instance by instance. The scene must outlive the rasterizer.
  /// @throws Error limit, bad_input as DrawList
  explicit ItemRasterizer(const Scene& scene);
  /// Items are indices into `triangles`. Both are copied.
  /// @param positions  m, world
  ItemRasterizer(std::span<const Point3> positions, std::span<const std::array<uint32_t, 3>> triangles);
  ~ItemRasterizer();
  ItemRasterizer(const ItemRasterizer&) = delete;
  ItemRasterizer& operator=(const ItemRasterizer&) = delete;

  uint32_t item_count() const;

  /// @param rows   only the upper rows of the picture are drawn and returned (half a cube's side, say); 0: all
  /// @param cull   triangles seen from their back hide nothing and are not seen
  /// @throws Error limit (size)
  void draw(const Camera& camera, int width, int height, ItemBuffer& out, int rows = 0, bool cull = false) const;
  /// The same, to be looked at where it is drawn: items in the order of the layout, padding included.
  using Look = FunctionRef<void(const BlockLayout& layout, std::span<const uint32_t> items)>;
  void look(const Camera& camera, int width, int height, int rows, Look look) const;

 private:
  class Frames;
  struct Frame;
  std::unique_ptr<Frame> drawn(const Camera& camera, int width, int height, int rows, bool cull) const;
  std::unique_ptr<Frames> frames_;
};

}  // namespace aktina
