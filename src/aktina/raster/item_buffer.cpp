#include "aktina/raster/item_buffer.h"

#include <algorithm>
#include <mutex>

#include "aktina/base/parallel.h"
#include "aktina/raster/limits.h"
#include "aktina/raster/visibility.h"

namespace aktina {

/// What one call needs beside the triangles.
struct ItemRasterizer::Frame {
  ScreenVertices screen;
  VisibilityBuffer buffer;

  void draw(const DrawList& list, const View& view, int rows, bool cull) {
    screen.resize(list.vertex_count());
    project_vertices(list, view, 0, list.vertex_count(), screen);
    buffer.clear({.first_row = 0, .rows = rows, .width = view.width()}, view.farthest());
    gather_triangles(list, screen, view, {0, list.triangle_count()}, cull, [&](const CornerGroup& group) {
      TriangleRecord records[kLanes];
      ScreenPlanes planes;
      set_up_triangles(group, view.width(), view.height(), records, planes);
      draw_visibility(records, group.triangle.v, group.count, buffer);
    });
  }
};

namespace {

void copy_out(const VisibilityBuffer& from, const View& view, ItemBuffer& out) {
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const size_t at = from.layout.offset_of_pixel(x, y), to = size_t(y) * size_t(out.width) + size_t(x);
      out.item[to] = from.seen[at];
      out.distance[to] = from.seen[at] == kNobody ? kInfinity : view.distance(from.depth[at]);
    }
}

}  // namespace

/// The triangles, and frames that wait for their next call.
class ItemRasterizer::Frames {
 public:
  template <class... Arguments>
  explicit Frames(Arguments&&... arguments) : list(std::forward<Arguments>(arguments)...) {}

  std::unique_ptr<Frame> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<Frame>();
    std::unique_ptr<Frame> frame = std::move(free_.back());
    free_.pop_back();
    return frame;
  }
  void give_back(std::unique_ptr<Frame> frame) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(frame));
  }

  const DrawList list;

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Frame>> free_;
};

ItemRasterizer::ItemRasterizer(const Scene& scene) : frames_(std::make_unique<Frames>(scene)) {}
ItemRasterizer::ItemRasterizer(std::span<const Point3> positions, std::span<const std::array<uint32_t, 3>> triangles)
    : frames_(std::make_unique<Frames>(positions, triangles)) {}
ItemRasterizer::~ItemRasterizer() = default;

uint32_t ItemRasterizer::item_count() const { return frames_->list.triangle_count(); }

std::unique_ptr<ItemRasterizer::Frame> ItemRasterizer::drawn(const Camera& camera, int width, int height, int rows,
                                                             bool cull) const {
  check_picture(camera, width, height);
  std::unique_ptr<Frame> frame = frames_->take();
  const FlushDenormals flush;
  frame->draw(frames_->list, View(camera, width, height), rows > 0 ? std::min(rows, height) : height, cull);
  return frame;
}

void ItemRasterizer::draw(const Camera& camera, int width, int height, ItemBuffer& out, int rows, bool cull) const {
  std::unique_ptr<Frame> frame = drawn(camera, width, height, rows, cull);
  out.width = width, out.height = frame->buffer.layout.rows;
  const size_t pixels = size_t(out.width) * size_t(out.height);
  out.item.resize(pixels), out.distance.resize(pixels);
  copy_out(frame->buffer, View(camera, width, height), out);
  frames_->give_back(std::move(frame));
}

void ItemRasterizer::look(const Camera& camera, int width, int height, int rows, Look look) const {
  std::unique_ptr<Frame> frame = drawn(camera, width, height, rows, false);
  const BlockLayout& layout = frame->buffer.layout;
  look(layout, {&frame->buffer.seen[0], layout.blocks() * kLanes});
  frames_->give_back(std::move(frame));
}

}  // namespace aktina
