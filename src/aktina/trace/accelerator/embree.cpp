// Intel's Embree: bounding volume hierarchies of triangles with hand-tuned SIMD traversal.
// Meshes that are placed once are put into world space; meshes placed often share one hierarchy; analytic primitives
// stand beside them. Cost: a build of about half a second a million triangles and core, then logarithmic in their
// number. Weakness: the hierarchy takes several times the memory of an indexed mesh.
//
// I. Wald, S. Woop, C. Benthin, G. S. Johnson, M. Ernst, "Embree: A Kernel Framework for Efficient CPU Ray Tracing",
// ACM Transactions on Graphics 33(4), 2014.
#include <embree3/rtcore.h>
#include <fmt/core.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_inverse.hpp>
#include <vector>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/scene/scene.h"
#include "aktina/trace/accelerator/accelerator.h"
#include "aktina/trace/placed_primitive.h"

namespace aktina {
namespace {

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, Release>;
using SceneHandle = std::unique_ptr<RTCSceneTy, Release>;
using Geometry = std::unique_ptr<RTCGeometryTy, Release>;

constexpr size_t kWorthSharing = 256;  // triangles; smaller meshes are copied into world space however often they occur

Ray ray_at(RTCRayN* rays, unsigned n, unsigned i) {
  return {{RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)},
          {RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)},
          RTCRayN_tnear(rays, n, i),
          RTCRayN_tfar(rays, n, i)};
}

void primitive_bounds(const RTCBoundsFunctionArguments* args) {
  const Bounds box = static_cast<const PlacedPrimitive*>(args->geometryUserPtr)->bounds();
  *args->bounds_o = {box.low.x, box.low.y, box.low.z, 0, box.high.x, box.high.y, box.high.z, 0};
}

void intersect_primitive(const RTCIntersectFunctionNArguments* args) {
  const auto& primitive = *static_cast<const PlacedPrimitive*>(args->geometryUserPtr);
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
  const unsigned n = args->N;
  for (unsigned i = 0; i < n; ++i) {
    if (args->valid[i] == 0) continue;
    const auto hit = primitive.intersect(ray_at(rays, n, i));
    if (!hit) continue;
    RTCRayN_tfar(rays, n, i) = hit->distance;
    RTCHitN_Ng_x(hits, n, i) = hit->normal.x;
    RTCHitN_Ng_y(hits, n, i) = hit->normal.y;
    RTCHitN_Ng_z(hits, n, i) = hit->normal.z;
    RTCHitN_u(hits, n, i) = RTCHitN_v(hits, n, i) = 0;
    RTCHitN_primID(hits, n, i) = 0;
    RTCHitN_geomID(hits, n, i) = args->geomID;
    RTCHitN_instID(hits, n, i, 0) = RTC_INVALID_GEOMETRY_ID;
  }
}

void occlude_by_primitive(const RTCOccludedFunctionNArguments* args) {
  const auto& primitive = *static_cast<const PlacedPrimitive*>(args->geometryUserPtr);
  for (unsigned i = 0; i < args->N; ++i)
    if (args->valid[i] != 0 && primitive.intersect(ray_at(args->ray, args->N, i)))
      RTCRayN_tfar(args->ray, args->N, i) = -kInfinity;
}

void intersect_n(const int* valid, RTCScene s, RTCIntersectContext* c, RTCRayHitNt<8>* r) {
  rtcIntersect8(valid, s, c, reinterpret_cast<RTCRayHit8*>(r));
}
void intersect_n(const int* valid, RTCScene s, RTCIntersectContext* c, RTCRayHitNt<16>* r) {
  rtcIntersect16(valid, s, c, reinterpret_cast<RTCRayHit16*>(r));
}
void occluded_n(const int* valid, RTCScene s, RTCIntersectContext* c, RTCRayNt<8>* r) {
  rtcOccluded8(valid, s, c, reinterpret_cast<RTCRay8*>(r));
}
void occluded_n(const int* valid, RTCScene s, RTCIntersectContext* c, RTCRayNt<16>* r) {
  rtcOccluded16(valid, s, c, reinterpret_cast<RTCRay16*>(r));
}

/// Copies lanes [first, first + N) into Embree's layout; `valid` gets -1 for those to be traced, 0 for the others.
/// Embree asks for numbers within 1.8e18 and near >= 0: rays that are not so meet nothing.
template <int N>
void fill(const RayPacket& in, int first, uint32_t bits, RTCRayNt<N>& out, int valid[N]) {
  const auto copy = [first](float* to, const float* from) { std::memcpy(to, from + first, N * sizeof(float)); };
  copy(out.org_x, in.origin[0]), copy(out.org_y, in.origin[1]), copy(out.org_z, in.origin[2]);
  copy(out.dir_x, in.direction[0]), copy(out.dir_y, in.direction[1]), copy(out.dir_z, in.direction[2]);
  copy(out.tnear, in.near), copy(out.tfar, in.far);
  const auto tame = [](float x) { return int(std::abs(x) < 1.8e18f); };
  for (int i = 0; i < N; ++i) {
    out.time[i] = 0, out.mask[i] = ~0U, out.id[i] = 0, out.flags[i] = 0;
    const int sound = tame(out.org_x[i]) & tame(out.org_y[i]) & tame(out.org_z[i]) & tame(out.dir_x[i]) &
                      tame(out.dir_y[i]) & tame(out.dir_z[i]) & int(out.tnear[i] >= 0) &
                      int(out.tfar[i] > out.tnear[i]);
    valid[i] = -(int(bits >> i & 1) & sound);
  }
}

class Embree final : public Accelerator {
 public:
  void build(const Scene& scene) override;
  void intersect(const RayPacket& rays, uint32_t lanes, HitPacket& hits, Coherence coherence) const override {
    native16_ ? intersect_by<16>(rays, lanes, hits, coherence) : intersect_by<8>(rays, lanes, hits, coherence);
  }
  uint32_t occluded(const RayPacket& rays, uint32_t lanes, Coherence coherence) const override {
    return native16_ ? occluded_by<16>(rays, lanes, coherence) : occluded_by<8>(rays, lanes, coherence);
  }

 private:
  void build_here(const Scene& scene);
  SceneHandle new_scene() const;
  Geometry triangles(const Mesh& mesh, const Mat4& to_world) const;
  Geometry shared(const Scene& scene, size_t mesh, const Mat4& to_world);
  Geometry primitive(const Primitive& shape, const Mat4& to_world);
  void check(std::string_view doing) const;

  template <int N>
  void intersect_by(const RayPacket& rays, uint32_t lanes, HitPacket& hits, Coherence coherence) const;
  template <int N>
  uint32_t occluded_by(const RayPacket& rays, uint32_t lanes, Coherence coherence) const;
  template <int N>
  void store(RTCRayHitNt<N>& from, uint32_t lanes, HitPacket& hits, int first) const;

  Device device_;
  bool native16_ = false;
  std::vector<SceneHandle> shared_scenes_;                    // one per mesh that is placed often; else empty
  std::vector<std::unique_ptr<PlacedPrimitive>> primitives_;  // Embree keeps their addresses
  std::vector<Mat3> normal_to_world_;                         // per instance; where normals_turn_
  bool normals_turn_ = false;  // some hits carry normals in mesh space, or of a mirrored mesh
  SceneHandle top_;
};

void Embree::check(std::string_view doing) const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_NONE) return;
  const bool memory = error == RTC_ERROR_OUT_OF_MEMORY;
  throw Error(memory ? Code::limit : Code::bad_input, "embree", fmt::format("{}: error {}", doing, int(error)),
              memory ? "out of memory" : "");
}

SceneHandle Embree::new_scene() const {
  SceneHandle scene(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);  // no gaps between triangles that share an edge
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_HIGH);
  return scene;
}

Geometry Embree::triangles(const Mesh& mesh, const Mat4& to_world) const {
  Geometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  auto* positions = static_cast<Point3*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Point3), mesh.positions.size()));
  auto* indices = static_cast<uint32_t*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
  check("taking memory for " + mesh.name);
  for (size_t i = 0; i < mesh.positions.size(); ++i) positions[i] = transform_point(to_world, mesh.positions[i]);
  for (const auto& t : mesh.triangles)
    for (const uint32_t vertex : t) {
      if (vertex >= mesh.positions.size())
        throw Error(Code::bad_input, mesh.name, fmt::format("a triangle names vertex {}", vertex),
                    fmt::format("there are {}", mesh.positions.size()));
      *indices++ = vertex;
    }
  rtcCommitGeometry(geometry.get());
  return geometry;
}

Geometry Embree::shared(const Scene& scene, size_t mesh, const Mat4& to_world) {
  SceneHandle& own = shared_scenes_[mesh];
  if (!own) {
    own = new_scene();
    rtcAttachGeometry(own.get(), triangles(scene.meshes[mesh], Mat4(1)).get());
    rtcCommitScene(own.get());
  }
  Geometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(geometry.get(), own.get());
  rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &to_world[0][0]);
  rtcCommitGeometry(geometry.get());
  return geometry;
}

Geometry Embree::primitive(const Primitive& shape, const Mat4& to_world) {
  primitives_.push_back(std::make_unique<PlacedPrimitive>(shape, to_world));
  Geometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryUserPrimitiveCount(geometry.get(), 1);
  rtcSetGeometryUserData(geometry.get(), primitives_.back().get());
  rtcSetGeometryBoundsFunction(geometry.get(), primitive_bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry.get(), intersect_primitive);
  rtcSetGeometryOccludedFunction(geometry.get(), occlude_by_primitive);
  rtcCommitGeometry(geometry.get());
  return geometry;
}

void Embree::build(const Scene& scene) {
  within_thread_limit([&] { build_here(scene); });
}

void Embree::build_here(const Scene& scene) {
  device_.reset(rtcNewDevice(nullptr));
  if (!device_) throw Error(Code::unsupported, "embree", "this processor is not supported");
  native16_ = rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
  top_ = new_scene();
  shared_scenes_.resize(scene.meshes.size());
  std::vector<uint32_t> uses(scene.meshes.size(), 0);
  for (const Instance& instance : scene.instances)
    if (instance.mesh >= 0) ++uses[size_t(instance.mesh)];

  normal_to_world_.assign(scene.instances.size(), Mat3(1));
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const auto m = size_t(instance.mesh);
    const float determinant = glm::determinant(Mat3(instance.to_world));
    Geometry geometry;
    if (instance.mesh >= 0 && uses[m] > 1 && scene.meshes[m].triangles.size() >= kWorthSharing && determinant != 0) {
      geometry = shared(scene, m, instance.to_world);
      normal_to_world_[i] = glm::inverseTranspose(Mat3(instance.to_world));
      normals_turn_ = true;
    } else if (instance.mesh >= 0) {
      if (scene.meshes[m].triangles.empty()) continue;
      geometry = triangles(scene.meshes[m], instance.to_world);
      if (determinant < 0) normal_to_world_[i] = Mat3(-1), normals_turn_ = true;
    } else if (instance.primitive >= 0) {
      geometry = primitive(scene.primitives[size_t(instance.primitive)], instance.to_world);
    } else {
      continue;
    }
    rtcAttachGeometryByID(top_.get(), geometry.get(), unsigned(i));
  }
  rtcCommitScene(top_.get());
  check("building the hierarchy");
}

template <int N>
void Embree::store(RTCRayHitNt<N>& from, uint32_t lanes, HitPacket& hits, int first) const {
  static_assert(RTC_INVALID_GEOMETRY_ID == kNothing);
  RTCHitNt<N>& hit = from.hit;
  uint32_t instance[N];
  float distance[N];
  for (int i = 0; i < N; ++i) instance[i] = hit.instID[0][i] != kNothing ? hit.instID[0][i] : hit.geomID[i];
  for (int i = 0; i < N; ++i) distance[i] = hit.geomID[i] == kNothing ? kInfinity : from.ray.tfar[i];
  for (int i = 0; i < N && normals_turn_; ++i) {
    if (instance[i] == kNothing) continue;
    const Vec3 normal = normal_to_world_[instance[i]] * Vec3(hit.Ng_x[i], hit.Ng_y[i], hit.Ng_z[i]);
    hit.Ng_x[i] = normal.x, hit.Ng_y[i] = normal.y, hit.Ng_z[i] = normal.z;
  }
  const auto copy = [lanes, first](auto* to, const auto* values) {
    if (lanes == (1U << N) - 1) {
      std::memcpy(to + first, values, N * sizeof(*to));
    } else {
      for (int i = 0; i < N; ++i)
        if (lanes >> i & 1) to[first + i] = values[i];
    }
  };
  copy(hits.distance, distance), copy(hits.instance, instance), copy(hits.triangle, hit.primID);
  copy(hits.normal[0], hit.Ng_x), copy(hits.normal[1], hit.Ng_y), copy(hits.normal[2], hit.Ng_z);
  copy(hits.u, hit.u), copy(hits.v, hit.v);
}

template <int N>
void Embree::intersect_by(const RayPacket& rays, uint32_t lanes, HitPacket& hits, Coherence coherence) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherence == Coherence::coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (int first = 0; first < kPacket; first += N) {
    const uint32_t bits = lanes >> first & ((1U << N) - 1);
    if (bits == 0) continue;
    alignas(64) int valid[N];
    alignas(64) RTCRayHitNt<N> packet;
    fill<N>(rays, first, bits, packet.ray, valid);
    for (int i = 0; i < N; ++i) packet.hit.geomID[i] = packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    intersect_n(valid, top_.get(), &context, &packet);
    store<N>(packet, bits, hits, first);
  }
}

template <int N>
uint32_t Embree::occluded_by(const RayPacket& rays, uint32_t lanes, Coherence /*coherence*/) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  // Never flagged as coherent: Embree 3.13 was seen to loop for ever in such shadow rays.
  uint32_t blocked = 0;
  for (int first = 0; first < kPacket; first += N) {
    const uint32_t bits = lanes >> first & ((1U << N) - 1);
    if (bits == 0) continue;
    alignas(64) int valid[N];
    alignas(64) RTCRayNt<N> packet;
    fill<N>(rays, first, bits, packet, valid);
    occluded_n(valid, top_.get(), &context, &packet);
    for (int i = 0; i < N; ++i) blocked |= uint32_t(packet.tfar[i] == -kInfinity) << (first + i);
  }
  return blocked & lanes;
}

}  // namespace

extern constinit const Method<std::unique_ptr<Accelerator>> embree_accelerator = {
    {"embree", "Embree's bounding volume hierarchies", "wald2014",
     "The fastest for all but a handful of triangles; about half a second of building a million triangles and core."},
    [](const ParamSet&) -> std::unique_ptr<Accelerator> { return std::make_unique<Embree>(); }};

}  // namespace aktina
