#include "aktina/raster/resolve.h"

namespace aktina {

void average_colour(const RasterBand& band, int side, Image& out) {
  const BlockLayout& layout = band.visible.layout;
  const float share = 1 / float(side * side);
  for (int y = layout.first_row / side; y < (layout.first_row + layout.rows) / side; ++y)
    for (int x = 0; x < out.width; ++x) {
      Rgb sum;
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
          const size_t at = layout.offset_of_pixel(x * side + i, y * side + j);
          for (int k = 0; k < 3; ++k) sum[k] += band.colour[k][at];
        }
      out.set_rgb(x, y, sum * share);
    }
}

void resolve_layers(const RasterBand& band, const View& view, int side, const PictureLayers& out) {
  const BlockLayout& layout = band.visible.layout;
  const auto put = [](Image* image, int x, int y, Vec3 v) {
    if (image) image->set_rgb(x, y, {v.x, v.y, v.z});
  };
  for (int y = layout.first_row / side; y < (layout.first_row + layout.rows) / side; ++y)
    for (int x = 0; x < layout.width / side; ++x) {
      const int sx = x * side + side / 2, sy = y * side + side / 2;
      const size_t at = layout.offset_of_pixel(sx, sy);
      const float depth = band.visible.depth[at];
      const bool seen = depth > view.farthest();
      const auto layer = [&](const LineArray<float>(&from)[3]) { return Vec3(from[0][at], from[1][at], from[2][at]); };
      if (out.albedo) put(out.albedo, x, y, layer(band.albedo));
      if (out.normal) put(out.normal, x, y, layer(band.normal));
      if (out.position) put(out.position, x, y, seen ? view.point(float(sx) + 0.5f, float(sy) + 0.5f, depth) : Vec3(0));
      if (out.depth) *out.depth->at(x, y) = seen ? view.distance(depth) : kInfinity;
    }
}

}  // namespace aktina
