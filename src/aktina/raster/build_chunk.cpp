#include <algorithm>
#include <bit>
#include <numeric>

#include "aktina/raster/raster_frame.h"
#include "aktina/raster/triangle_group.h"

namespace aktina {
namespace {

/// One chunk on its way: appends group after group.
class ChunkBuilder {
 public:
  ChunkBuilder(const RasterFrame& frame, TriangleChunk& chunk) : frame_(frame), chunk_(chunk) {
    chunk_.count = 0, chunk_.group_count = 0;
    chunk_.runs.clear();
    chunk_.bands.resize(size_t(frame.bands())), chunk_.blended.resize(size_t(frame.bands()));
    for (auto& band : chunk_.bands) band.clear();
    for (auto& band : chunk_.blended) band.clear();
  }

  void add_part(uint32_t part, TriangleRange range) {
    pipeline_ = frame_.pipelines.of_part[part];
    const Pipeline& pipeline = frame_.pipelines.all[pipeline_];
    if (!pipeline.blended()) chunk_.runs.push_back({chunk_.count, pipeline_});
    gather_triangles(frame_.list, frame_.screen, frame_.view, range, pipeline.cull,
                     [&](const CornerGroup& group) { add(pipeline, group); });
  }

 private:
  void reserve() {
    const size_t wanted = chunk_.count + kLanes;
    if (chunk_.records.size() >= wanted) return;
    const size_t size = std::max(wanted, chunk_.records.size() * 3 / 2);
    chunk_.records.resize(size), chunk_.sources.resize(size);
    chunk_.planes.resize(size * frame_.stride());
  }

  void add(const Pipeline& pipeline, const CornerGroup& corners) {
    reserve();
    ScreenPlanes planes;
    set_up_triangles(corners, frame_.view.width(), frame_.view.height(), &chunk_.records[chunk_.count], planes);
    if (pipeline.layout.size() > 0) {
      const Samples samples(samples_, pipeline.layout.channels);
      if (pipeline.layout.channels > 0) sample(pipeline, corners, samples);
      write_planes(pipeline.layout, corners, planes, frame_.view.perspective(), samples_,
                   chunk_.planes.data() + chunk_.count * frame_.stride(), frame_.stride());
    }
    if (pipeline.spans()) keep_group(pipeline, corners);
    sort_in(pipeline, corners);
    chunk_.count += uint32_t(corners.count);
  }

  void sample(const Pipeline& pipeline, const CornerGroup& corners, const Samples& samples) {
    fill_group(frame_, pipeline, corners, group_);
    pipeline.method->prepare(group_, pipeline.light, samples);
    if (pipeline.textured || is_black(pipeline.emission) || pipeline.plan.kind != ShadingPlan::Kind::colour) return;
    const bool both = pipeline.emits_on(false);
    for (int point = 0; point < int(lattice(pipeline.plan.degree).size()); ++point)
      for (int k = 0; k < 3; ++k)
        for (size_t i = 0; i < kLanes; ++i)
          if (both || corners.side[i] > 0) samples(point, k)[i] += pipeline.emission[k];
  }

  void keep_group(const Pipeline& pipeline, const CornerGroup& corners) {
    if (chunk_.groups.size() == chunk_.group_count) chunk_.groups.emplace_back();
    fill_group(frame_, pipeline, corners, chunk_.groups[chunk_.group_count++]);
  }

  void sort_in(const Pipeline& pipeline, const CornerGroup& corners) {
    for (size_t i = 0; i < size_t(corners.count) && !pipeline.immediate; ++i)
      chunk_.sources[chunk_.count + i] = {corners.triangle[i], uint16_t(pipeline_), corners.side[i] > 0, uint8_t(i),
                                          chunk_.group_count - 1};
    if (pipeline.blended()) return sort_in_blended(corners);
    // Triangles that follow each other mostly lie in the same bands: they are put there together.
    for (uint32_t i = 0, end = 0; i < uint32_t(corners.count); i = end) {
      const Bands bands = bands_of(chunk_.count + i);
      while (++end < uint32_t(corners.count) && bands_of(chunk_.count + end) == bands) {
      }
      for (uint32_t band = bands.first; band <= bands.last; ++band) {
        std::vector<uint32_t>& list = chunk_.bands[band];
        const size_t at = list.size();
        list.resize(at + end - i);
        std::iota(list.begin() + std::ptrdiff_t(at), list.end(), chunk_.count + i);
      }
    }
  }

  void sort_in_blended(const CornerGroup& corners) {
    for (uint32_t i = 0; i < uint32_t(corners.count); ++i) {
      const Bands bands = bands_of(chunk_.count + i);
      const float depth = (corners.depth[0][i] + corners.depth[1][i] + corners.depth[2][i]) / 3;
      for (uint32_t band = bands.first; band <= bands.last; ++band)
        chunk_.blended[band].push_back({chunk_.count + i, depth});
    }
  }

  struct Bands {
    uint32_t first, last;
    bool operator==(const Bands&) const = default;
  };
  Bands bands_of(uint32_t record) const {
    const TriangleRecord& r = chunk_.records[record];
    return {r.first_y / uint32_t(kBandRows), r.last_y / uint32_t(kBandRows)};
  }

  const RasterFrame& frame_;
  TriangleChunk& chunk_;
  uint32_t pipeline_ = 0;
  TriangleGroup group_{};
  Lanes samples_[kMostLatticePoints * kMostChannels];
};

}  // namespace

void build_chunk(const RasterFrame& frame, uint32_t index) {
  ChunkBuilder builder(frame, frame.chunks[index]);
  const uint32_t begin = (frame.first_chunk + index) * kChunkTriangles;
  const uint32_t end = std::min(begin + kChunkTriangles, frame.list.triangle_count());
  const auto parts = frame.list.parts();
  auto part = std::upper_bound(parts.begin(), parts.end(), begin,
                               [](uint32_t t, const DrawPart& p) { return t < p.first_triangle; });
  for (--part; part != parts.end() && part->first_triangle < end; ++part)
    builder.add_part(uint32_t(part - parts.begin()), {std::max(begin, part->first_triangle),
                                                      std::min(end, part->first_triangle + part->triangle_count)});
}

}  // namespace aktina
