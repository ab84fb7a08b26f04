// Methods on spans: after visibility is known, each triangle's visible runs of pixels are gathered scanline by scanline
// and handed to the method, many spans at a time.
#include <algorithm>
#include <cmath>

#include "aktina/raster/band.h"
#include "aktina/raster/shading/span.h"

namespace aktina {
namespace {

constexpr size_t kPixelsAtOnce = 2048;  // their light stays in the cache
constexpr int kLongest = 1024;          // px; longer runs are cut

/// One triangle of a band.
class SpanShader {
 public:
  SpanShader(const RasterFrame& frame, uint32_t name, uint32_t* seen, RasterBand& band)
      : frame_(frame),
        name_(name),
        source_(frame.source(name)),
        group_(frame.chunk_of(name).groups[source_.group]),
        pipeline_(frame.pipelines.all[source_.pipeline]),
        layout_(band.visible.layout),
        seen_(seen),
        band_(band),
        out_(band.on_spans) {}

  void draw() {
    Vec2 screen[3];
    for (int v = 0; v < 3; ++v) screen[v] = {group_.screen[v][0][source_.lane], group_.screen[v][1][source_.lane]};
    const TriangleRecord& record = frame_.record(name_);
    const int first = std::max<int>(record.first_y, layout_.first_row);
    const int last = std::min<int>(record.last_y, layout_.first_row + layout_.rows - 1);
    for (int y = first; y <= last; ++y) {
      const Span whole = span_at(screen, float(y) + 0.5f);
      if (whole.left.x > whole.right.x) continue;
      // A pixel more on both sides: which are covered is known exactly, by name.
      find_runs(whole, y, std::max<int>(record.first_x, int(std::floor(whole.left.x)) - 1),
                std::min<int>(record.last_x, int(std::floor(whole.right.x)) + 1));
    }
    flush();
  }

 private:
  size_t offset(int x, int y) const { return layout_.offset_of_pixel(x, y); }

  void find_runs(Span span, int y, int begin, int end) {
    for (int x = begin; x <= end;) {
      while (x <= end && seen_[offset(x, y)] != name_) ++x;
      span.first = x;
      while (x <= end && x - span.first < kLongest && seen_[offset(x, y)] == name_) ++x;
      span.count = x - span.first;
      if (span.count > 0) add(span);
    }
  }

  void add(Span span) {
    const size_t size = padded(size_t(span.count));
    if (out_.used + size > kPixelsAtOnce) flush();
    span.output = out_.used;
    out_.used += size;
    out_.spans.push_back(span);
  }

  void flush() {
    if (out_.spans.empty()) return;
    LitArrays lit;
    for (int k = 0; k < 3; ++k) {
      out_.lit_diffuse[k].resize(kPixelsAtOnce), out_.lit_specular[k].resize(kPixelsAtOnce);
      lit.diffuse[k] = out_.lit_diffuse[k].data(), lit.specular[k] = out_.lit_specular[k].data();
    }
    pipeline_.method->shade_spans(group_, source_.lane, out_.spans, pipeline_.light, lit);
    const bool plain = !pipeline_.textured;
    const bool shines = plain && (source_.front || pipeline_.emits_on(false));
    const Rgb emission = shines ? pipeline_.emission : Rgb();
    for (const Span& span : out_.spans) {
      if (plain) {
        write_colour(span, lit, emission);
      } else {
        keep(span, lit);
      }
    }
    out_.spans.clear();
    out_.used = 0;
  }

  void write_colour(const Span& span, const LitArrays& lit, Rgb emission) {
    const int y = int(span.y);
    for (int i = 0; i < span.count; ++i) {
      const size_t at = offset(span.first + i, y), from = span.output + size_t(i);
      for (int k = 0; k < 3; ++k) band_.colour[k][at] = lit.diffuse[k][from] + lit.specular[k][from] + emission[k];
      seen_[at] = kNobody;
    }
  }

  void keep(const Span& span, const LitArrays& lit) {
    const int y = int(span.y);
    for (int i = 0; i < span.count; ++i) {
      const size_t at = offset(span.first + i, y), from = span.output + size_t(i);
      for (int k = 0; k < 3; ++k)
        out_.diffuse[k][at] = lit.diffuse[k][from], out_.specular[k][at] = lit.specular[k][from];
    }
  }

  const RasterFrame& frame_;
  const uint32_t name_;
  const RecordSource& source_;
  const TriangleGroup& group_;
  const Pipeline& pipeline_;
  const BlockLayout& layout_;
  uint32_t* const seen_;
  RasterBand& band_;
  SpanBuffers& out_;
};

}  // namespace

void shade_spans_of(const RasterFrame& frame, uint32_t name, uint32_t* seen, RasterBand& band) {
  SpanShader(frame, name, seen, band).draw();
}

void shade_spans(const RasterFrame& frame, int index, RasterBand& band) {
  for (uint32_t c = 0; c < frame.chunks.size(); ++c)
    for (const uint32_t record : frame.chunks[c].bands[size_t(index)]) {
      const uint32_t name = c << kChunkBits | record;
      if (frame.pipelines.all[frame.source(name).pipeline].spans())
        shade_spans_of(frame, name, band.visible.seen.data(), band);
    }
}

}  // namespace aktina
