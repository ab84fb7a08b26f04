// Rays: Aktina's scene against raw Embree calls on the same mesh; path tracing and Whitted's method on known scenes,
// and how they gain by threads.
#include <embree3/rtcore.h>

#include <cstdlib>
#include <memory>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/trace/accelerator/accelerator.h"
#include "aktina/trace/camera_rays.h"
#include "aktina/trace/trace.h"
#include "bench/report.h"
#include "bench/trace_scenes.h"

namespace {

using namespace aktina;

constexpr int kSide = 512;  // rays of a picture's side

/// The scene's triangles in one mesh of Embree's own.
struct RawEmbree {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);

  explicit RawEmbree(const Scene& from) {
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    for (const Mesh& mesh : from.meshes) {
      RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
      auto* p = static_cast<Point3*>(
          rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.positions.size()));
      std::copy(mesh.positions.begin(), mesh.positions.end(), p);
      auto* t = static_cast<std::array<uint32_t, 3>*>(
          rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
      std::copy(mesh.triangles.begin(), mesh.triangles.end(), t);
      rtcCommitGeometry(g);
      rtcAttachGeometry(scene, g);
      rtcReleaseGeometry(g);
    }
    rtcCommitScene(scene);
  }
  ~RawEmbree() { rtcReleaseScene(scene), rtcReleaseDevice(device); }
  RawEmbree(const RawEmbree&) = delete;
  RawEmbree& operator=(const RawEmbree&) = delete;

  void trace(const std::vector<RayPacket>& packets, bool coherent, float& sum) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[16];
    std::fill_n(valid, 16, -1);
    for (const RayPacket& in : packets) {
      alignas(64) RTCRayHit16 r;
      std::copy_n(in.origin[0], 16, r.ray.org_x), std::copy_n(in.origin[1], 16, r.ray.org_y);
      std::copy_n(in.origin[2], 16, r.ray.org_z), std::copy_n(in.direction[0], 16, r.ray.dir_x);
      std::copy_n(in.direction[1], 16, r.ray.dir_y), std::copy_n(in.direction[2], 16, r.ray.dir_z);
      std::copy_n(in.near, 16, r.ray.tnear), std::copy_n(in.far, 16, r.ray.tfar);
      for (int i = 0; i < 16; ++i)
        r.ray.time[i] = 0, r.ray.mask[i] = ~0U, r.ray.flags[i] = 0, r.hit.geomID[i] = r.hit.instID[0][i] = ~0U;
      rtcIntersect16(valid, scene, &context, &r);
      sum += r.ray.tfar[0];
    }
  }
};

/// Blocks of 4 x 4 pixels.
std::vector<RayPacket> primary_rays(const Scene& scene) {
  const CameraRays camera(scene.cameras[0], kSide, kSide);
  std::vector<RayPacket> packets(kSide * kSide / kPacket);
  for (size_t b = 0; b < packets.size(); ++b)
    for (int lane = 0; lane < kPacket; ++lane) {
      const int x = int(b % (kSide / 4)) * 4 + lane % 4, y = int(b / (kSide / 4)) * 4 + lane / 4;
      packets[b].set(lane, camera.at(float(x) + 0.5f, float(y) + 0.5f));
    }
  return packets;
}

/// From where those rays end into random directions.
std::vector<RayPacket> diffuse_rays(const Accelerator& accelerator, std::vector<RayPacket> packets) {
  uint32_t i = 0;
  for (RayPacket& packet : packets) {
    HitPacket hits;
    accelerator.intersect(packet, kAllLanes, hits, Coherence::coherent);
    for (int lane = 0; lane < kPacket; ++lane, ++i) {
      const Ray ray = packet.at(lane);
      const Hit hit = hits.at(lane);
      Vec3 n = normalize_or(hit.normal, -ray.direction);
      if (dot(n, ray.direction) > 0) n = -n;
      const Vec3 d = Frame(n).to_world(sample_cosine_hemisphere(sobol_owen(i, 1)));
      packet.set(lane, {ray.origin + hit.distance * ray.direction + 1e-4f * n, d});
    }
  }
  return packets;
}

void rays_against_embree() {
  const Scene scene = bench::bumpy_sphere_in_a_box();
  const RawEmbree raw(scene);
  const auto accelerator = build_accelerator(scene);
  const auto primary = primary_rays(scene), diffuse = diffuse_rays(*accelerator, primary);
  float sum = 0;
  const auto ours = [&](const std::vector<RayPacket>& packets, Coherence coherence) {
    for (const RayPacket& packet : packets) {
      HitPacket hits;
      accelerator->intersect(packet, kAllLanes, hits, coherence);
      sum += hits.distance[0];
    }
  };
  const auto t =
      bench::race(5, {[&] { ours(primary, Coherence::coherent); }, [&] { raw.trace(primary, true, sum); },
                      [&] { ours(diffuse, Coherence::incoherent); }, [&] { raw.trace(diffuse, false, sum); }});
  if (!std::isfinite(sum)) std::abort();
  bench::report("trace.coherent.embree", "primary rays a second, 281,248 triangles: over raw calls of Embree",
                t[1] / t[0], "x", bench::Goal{0.9});
  bench::report("trace.diffuse.embree", "diffuse rays a second, 281,248 triangles: over raw calls of Embree",
                t[3] / t[2], "x", bench::Goal{0.9});
}

/// Least seconds of a frame on each number of threads, the hierarchy's build left out, and rays a frame.
struct FrameTimes {
  std::vector<double> seconds;
  double rays = 0;
};
FrameTimes time_frames(const Scene& scene, int width, int height, const TraceOptions& options, int rounds,
                       std::initializer_list<int> thread_counts) {
  FrameTimes times{std::vector<double>(thread_counts.size(), 1e30)};
  for (int round = 0; round < rounds; ++round) {
    size_t i = 0;
    for (const int threads : thread_counts) {
      TraceStatistics statistics;
      set_thread_count(threads);
      trace(scene, scene.cameras[0], width, height, options, nullptr, &statistics);
      set_thread_count(0);
      times.seconds[i] = std::min(times.seconds[i], statistics.trace_seconds);
      times.rays = double(statistics.rays + statistics.shadow_rays);
      ++i;
    }
  }
  return times;
}

void path_tracing(const Scene& scene, const std::string& name, const std::string& what) {
  TraceOptions options;
  options.integrator = "path:depth=8";
  options.samples = 8;
  const FrameTimes t = time_frames(scene, kSide, kSide, options, 3, {1, 2});
  const double samples = double(kSide) * kSide * options.samples;
  bench::report("trace.path." + name, what + ": samples a second on one thread", samples / t.seconds[0] * 1e-6,
                "Msamples/s");
  bench::report("trace.path." + name + ".rays", what + ": rays a second on one thread", t.rays / t.seconds[0] * 1e-6,
                "Mrays/s");
  if (thread_count() >= 2)
    bench::report("trace.path." + name + ".threads", what + ": two threads over one", t.seconds[0] / t.seconds[1], "x",
                  bench::Goal{1.85});
}

void whitted() {
  TraceOptions options;
  options.integrator = "whitted:depth=8";
  options.samples = 1;
  const FrameTimes t = time_frames(bench::spheres(), 800, 600, options, 3, {1});
  bench::report("trace.whitted.spheres", "22 spheres on a checkered floor, two lamps: rays a second on one thread",
                t.rays / t.seconds[0] * 1e-6, "Mrays/s");
}

}  // namespace

int main() {
  rays_against_embree();
  path_tracing(bench::cornell_box_36(), "cornell", "path tracing the Cornell box, 8 bounces");
  path_tracing(bench::bumpy_sphere_in_a_box(), "mesh", "path tracing 281,248 triangles in a box, 8 bounces");
  whitted();
}
