#include "aktina/radiosity/lightmap/layout.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/radiosity/lightmap/given_uv.h"
#include "aktina/radiosity/lightmap/pack.h"

namespace aktina {
namespace {

constexpr int kMostPages = 16;
constexpr int kLargestPage = 16384;                        // texels: what graphics hardware takes
constexpr double kMostTexels = double(uint64_t(1) << 25);  // of all pages: about 1 GB while they are computed

void check(const LightmapOptions& o) {
  const auto refuse = [](const char* what, double got, const char* accepted) {
    throw Error(Code::bad_param, what, fmt::format("got {:g}", got), accepted);
  };
  if (!(o.texel_size >= 0 && o.texel_size <= 1e6)) refuse("texel_size", o.texel_size, "0 .. 1e6 m; 0: what fits");
  if (o.size < 8 || o.size > kLargestPage) refuse("lightmap_size", o.size, "8 .. 16384 texels");
  if (o.padding < 0 || o.padding > 64) refuse("padding", o.padding, "0 .. 64 texels");
  if (o.direct_samples < 0 || o.direct_samples > 65536) refuse("direct_samples", o.direct_samples, "0 .. 65536");
  if (o.gather_samples < 0 || o.gather_samples > 65536) refuse("gather_samples", o.gather_samples, "0 .. 65536");
}

struct Loose {
  Chart chart;
  uint32_t surface;
  bool given;  // keeps its shape: both directions have one scale
};

/// Texels from the first middle on a chart's rectangle to the last.
int steps(float extent, double texel) { return std::max(1, int(std::ceil(double(extent) / texel - 1e-3))); }

class Packer {
 public:
  Packer(const std::vector<Loose>& loose, const LightmapOptions& options) : loose_(loose), options_(options) {
    for (const Loose& l : loose) area_ += double(l.chart.size.x) * double(l.chart.size.y);
  }

  /// The finest texel at which all fits on one page, to a few percent.
  double finest() {
    const double side = options_.size;
    double coarse = std::max(std::sqrt(area_) / side, 1e-9), fine = 0;
    for (int tries = 0; !(fits_one_page(coarse) && pack_at(coarse, 1)); ++tries) {
      if (tries == 60) throw no_room();
      fine = coarse, coarse *= 1.15;
    }
    if (fine == 0) return coarse;
    for (int i = 0; i < 3; ++i) {
      const double middle = 0.5 * (coarse + fine);
      (fits_one_page(middle) && pack_at(middle, 1) ? coarse : fine) = middle;
    }
    return coarse;
  }

  void pack(double texel) {
    if (!within_limits(texel) || (pages = pack_at(texel, options_.texel_size > 0 ? kMostPages : 1)) == 0)
      throw Error(Code::limit, "lightmap",
                  fmt::format("{:g} m a texel do not fit on {} pages of {} x {}", texel, kMostPages, options_.size,
                              options_.size),
                  fmt::format("--texel-size {:.2g} fits on one page{}", suggested(),
                              options_.size < kLargestPage ? ", or take a larger --lightmap-size" : ""));
  }

  std::vector<PackedBox> boxes;
  int pages = 0;

 private:
  double suggested() { return finest() * 1.05; }
  Error no_room() const {
    const double one = 2 + 2 * options_.padding;
    return {Code::limit, "lightmap",
            fmt::format("{} charts have no room on a page of {} texels", loose_.size(), options_.size),
            fmt::format("--lightmap-size {:.0f} or more", std::ceil(1.1 * one * std::sqrt(double(loose_.size()))))};
  }

  PackedBox box(const Loose& l, double texel) const {
    const int more = 1 + 2 * options_.padding;
    PackedBox b;
    b.width = steps(l.chart.size.x, texel) + more, b.height = steps(l.chart.size.y, texel) + more;
    return b;
  }
  double texels(double texel) const {
    double sum = 0;
    const double more = 1 + 2 * options_.padding;
    for (const Loose& l : loose_)
      sum += (std::max(1.0, double(l.chart.size.x) / texel) + more) *
             (std::max(1.0, double(l.chart.size.y) / texel) + more);
    return sum;
  }
  bool fits_one_page(double texel) const {
    return texels(texel) <= double(options_.size) * double(options_.size) && within_limits(texel);
  }
  /// Whether sizes are small enough to be looked at.
  bool within_limits(double texel) const {
    const double side = options_.size - 1 - 2 * options_.padding;
    for (const Loose& l : loose_)
      if (double(std::max(l.chart.size.x, l.chart.size.y)) / texel > side) return false;
    return texels(texel) <= kMostTexels;
  }
  int pack_at(double texel, int most_pages) {
    boxes.clear();
    for (const Loose& l : loose_) boxes.push_back(box(l, texel));
    return aktina::pack(boxes, options_.size, most_pages);
  }

  const std::vector<Loose>& loose_;
  const LightmapOptions& options_;
  double area_ = 0;  // of all rectangles, m^2
};

PlacedChart placed(const Loose& loose, const PackedBox& box, double texel, int padding) {
  PlacedChart out;
  out.surface = loose.surface, out.page = box.page;
  out.x = box.x, out.y = box.y, out.width = box.width, out.height = box.height;
  out.triangles = loose.chart.triangles;
  const Vec2 size = loose.chart.size;
  Vec2 scale(float(1 / texel));
  if (!loose.given) {
    if (size.x > 0) scale.x = float(steps(size.x, texel)) / size.x;
    if (size.y > 0) scale.y = float(steps(size.y, texel)) / size.y;
  }
  const Vec2 origin = Vec2(float(box.x + padding), float(box.y + padding)) + 0.5f;
  for (const FlatTriangle& t : loose.chart.corners)
    out.texels.push_back({origin + t[0] * scale, origin + t[1] * scale, origin + t[2] * scale});
  return out;
}

std::vector<Loose> loose_charts(LightmapLayout& layout, bool keep_uv) {
  std::vector<std::vector<Chart>> charts(layout.surfaces.size());
  std::vector<uint8_t> given(layout.surfaces.size(), 0);
  for (size_t i = 0; i < charts.size() && keep_uv; ++i)
    if (Chart chart = given_chart(layout.surfaces[i], layout.warnings); !chart.triangles.empty())
      given[i] = 1, charts[i].push_back(std::move(chart));
  parallel_for(charts.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      if (!given[i]) charts[i] = make_charts(layout.surfaces[i]);
  });
  std::vector<Loose> loose;
  for (uint32_t i = 0; i < charts.size(); ++i) {
    layout.kept += given[i];
    for (Chart& chart : charts[i]) loose.push_back({std::move(chart), i, given[i] != 0});
  }
  return loose;
}

/// The file's own page: coordinates stay as they are.
void keep_page(LightmapLayout& layout, const LightmapOptions& options) {
  double area = 0, flat = 0;
  for (const LightmapSurface& s : layout.surfaces) {
    area += s.area();
    for (const FlatTriangle& t : s.given) flat += 0.5 * std::fabs(double(twice_area(t)));
  }
  const double side = std::sqrt(area / flat);  // m
  const double wanted = options.texel_size > 0 ? std::ceil(side / options.texel_size) : options.size;
  if (wanted > double(options.size))
    throw Error(Code::limit, "lightmap",
                fmt::format("{:g} m a texel on the scene's own page take {:.0f} texels", options.texel_size, wanted),
                fmt::format("--lightmap-size {:.0f}, or --texel-size {:.2g}", wanted, side / options.size));
  const int size = std::max(8, int(wanted));
  layout.pages = {{size, size}};
  layout.texel_size = side / size;
  layout.kept = layout.surfaces.size();
  for (uint32_t i = 0; i < layout.surfaces.size(); ++i) {
    PlacedChart chart;
    chart.surface = i, chart.width = size, chart.height = size;
    for (uint32_t t = 0; t < layout.surfaces[i].size(); ++t) {
      chart.triangles.push_back(t);
      FlatTriangle corners = layout.surfaces[i].given[t];
      for (Vec2& p : corners) p = glm::clamp(p, Vec2(0), Vec2(1)) * float(size);
      chart.texels.push_back(corners);
    }
    layout.charts.push_back(std::move(chart));
  }
}

/// Pages are as large as what stands on them, in steps of 4 texels; one alone that was asked for is square.
void size_pages(LightmapLayout& layout, const std::vector<PackedBox>& boxes, int pages, const LightmapOptions& o) {
  layout.pages.assign(size_t(pages), {4, 4});
  for (const PackedBox& b : boxes) {
    LightmapLayout::Page& page = layout.pages[size_t(b.page)];
    page.width = std::max(page.width, std::min(o.size, (b.x + b.width + 3) / 4 * 4));
    page.height = std::max(page.height, std::min(o.size, (b.y + b.height + 3) / 4 * 4));
  }
  if (o.texel_size == 0) layout.pages[0] = {o.size, o.size};
}

}  // namespace

LightmapLayout make_layout(std::vector<LightmapSurface> surfaces, const LightmapOptions& options) {
  check(options);
  LightmapLayout layout;
  layout.surfaces = std::move(surfaces);
  if (layout.surfaces.empty()) throw Error(Code::bad_input, "lightmap", "no surface has an area");
  if (options.keep_uv && share_a_page(layout.surfaces)) {
    keep_page(layout, options);
    return layout;
  }
  const std::vector<Loose> loose = loose_charts(layout, options.keep_uv);
  Packer packer(loose, options);
  layout.texel_size = options.texel_size > 0 ? options.texel_size : packer.finest();
  packer.pack(layout.texel_size);
  for (size_t i = 0; i < loose.size(); ++i)
    layout.charts.push_back(placed(loose[i], packer.boxes[i], layout.texel_size, options.padding));
  size_pages(layout, packer.boxes, packer.pages, options);
  return layout;
}

}  // namespace aktina
