// Methods on spans: after visibility is known, each triangle's visible runs of pixels are gathered scanline by scanline
// and handed to the method, many spans at a time.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

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
                std::min<int>(record.last_x, int(std::floor(whole.right.x)) + 1) + 1);
    }
    flush();
  }

 private:
  /// Of the first pixel of the four that lie together in a block's row.
  size_t piece(int x, int y) const { return layout_.offset_of_pixel(x & ~(kBlock - 1), y); }

  /// Which of 64 pixels from x on, a multiple of 4, show this triangle.
  uint64_t who_is_seen(int x, int y, int end) const {
    uint64_t bits = 0;
    const uint32_t* names = seen_ + piece(x, y);
    for (int i = 0; i < 64 && x + i < end; i += kBlock, names += kLanes) {
      const unsigned four = unsigned(names[0] == name_) | unsigned(names[1] == name_) << 1 |
                            unsigned(names[2] == name_) << 2 | unsigned(names[3] == name_) << 3;
      bits |= uint64_t(four) << i;
    }
    return bits;
  }

  /// Runs of pixels that show this triangle, among begin .. end - 1.
  void find_runs(Span span, int y, int begin, int end) {
    span.count = 0;
    for (int x = begin & ~(kBlock - 1); x < end; x += 64) {
      uint64_t bits = who_is_seen(x, y, end);
      int at = x;
      while (bits != 0) {
        const int gap = std::countr_zero(bits), run = std::countr_one(bits >> gap);
        if (gap > 0 || span.count + run > kLongest) finish(span);
        at += gap;
        if (span.count == 0) span.first = at;
        span.count += run, at += run;
        bits = gap + run < 64 ? bits >> (gap + run) : 0;
      }
      if (at < x + 64) finish(span);
    }
    finish(span);
  }

  void finish(Span& span) {
    if (span.count > 0) add(span);
    span.count = 0;
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

  /// Calls write(to, from, n) for the n pixels of a span in each block that it crosses.
  template <class Write>
  void in_pieces(const Span& span, const Write& write) {
    const int y = int(span.y), end = span.first + span.count;
    for (int x = span.first; x < end;) {
      const int n = std::min(kBlock - x % kBlock, end - x);
      write(piece(x, y) + size_t(x % kBlock), span.output + size_t(x - span.first), n);
      x += n;
    }
  }

  void write_colour(const Span& span, const LitArrays& lit, Rgb emission) {
    in_pieces(span, [&](size_t to, size_t from, int n) {
      for (int k = 0; k < 3; ++k) {
        float* const colour = band_.colour[k].data() + to;
        const float *d = lit.diffuse[k] + from, *s = lit.specular[k] + from;
        float sum[kBlock];
        for (int i = 0; i < kBlock; ++i) sum[i] = d[i] + s[i] + emission[k];  // reads padding where there are fewer
        if (n == kBlock) {                                                    // most pieces are whole
          std::memcpy(colour, sum, sizeof(sum));
        } else {
          for (int i = 0; i < n; ++i) colour[i] = sum[i];
        }
      }
      for (int i = 0; i < n; ++i) seen_[to + size_t(i)] = kNobody;
    });
  }

  void keep(const Span& span, const LitArrays& lit) {
    in_pieces(span, [&](size_t to, size_t from, int n) {
      for (int k = 0; k < 3; ++k) {
        std::copy_n(lit.diffuse[k] + from, n, out_.diffuse[k].data() + to);
        std::copy_n(lit.specular[k] + from, n, out_.specular[k].data() + to);
      }
    });
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
