#include "aktina/import/gltf/meshopt.h"

#include <meshoptimizer.h>

namespace aktina::gltf {
namespace {

struct Packed {
  std::span<const uint8_t> bytes;
  size_t count = 0, stride = 0;
  std::string_view mode, filter;
};

Packed open_packed(Document& document, const Value& place) {
  const auto buffer = document.buffer(size_t(place["buffer"].whole(0)));
  const uint64_t offset = place["byteOffset"].whole(0), length = place["byteLength"].whole(0);
  if (offset > buffer.size() || length > buffer.size() - offset) place.fail("lies beyond its buffer");
  Packed out;
  out.bytes = buffer.subspan(size_t(offset), size_t(length));
  out.count = size_t(place["count"].whole(0)), out.stride = size_t(place["byteStride"].whole(0));
  out.mode = place["mode"].text_view();
  out.filter = place["filter"] ? place["filter"].text_view() : "NONE";
  return out;
}

/// The codecs' own preconditions, which they do not check.
void check(const Packed& p, const Value& place) {
  const bool vertices = p.mode == "ATTRIBUTES", indices = p.mode == "TRIANGLES" || p.mode == "INDICES";
  if (!vertices && !indices) place["mode"].fail("is not one of ATTRIBUTES, TRIANGLES, INDICES");
  if (p.count == 0 || p.stride == 0 || p.stride > 256) place.fail("count and byteStride do not describe data");
  if (vertices && p.stride % 4 != 0) place["byteStride"].fail("should be a multiple of 4, at most 256");
  if (indices && p.stride != 2 && p.stride != 4) place["byteStride"].fail("should be 2 or 4");
  if (p.mode == "TRIANGLES" && p.count % 3 != 0) place["count"].fail("should be a multiple of 3");
  if (p.filter == "OCTAHEDRAL" && p.stride != 4 && p.stride != 8) place["byteStride"].fail("should be 4 or 8");
  if (p.filter == "QUATERNION" && p.stride != 8) place["byteStride"].fail("should be 8");
}

int decode(const Packed& p, uint8_t* out) {
  if (p.mode == "ATTRIBUTES") return meshopt_decodeVertexBuffer(out, p.count, p.stride, p.bytes.data(), p.bytes.size());
  if (p.mode == "TRIANGLES") return meshopt_decodeIndexBuffer(out, p.count, p.stride, p.bytes.data(), p.bytes.size());
  return meshopt_decodeIndexSequence(out, p.count, p.stride, p.bytes.data(), p.bytes.size());
}

void apply_filter(const Packed& p, uint8_t* out, const Value& place) {
  if (p.filter == "OCTAHEDRAL")
    meshopt_decodeFilterOct(out, p.count, p.stride);
  else if (p.filter == "QUATERNION")
    meshopt_decodeFilterQuat(out, p.count, p.stride);
  else if (p.filter == "EXPONENTIAL" && p.stride % 4 == 0)
    meshopt_decodeFilterExp(out, p.count, p.stride);
  else if (p.filter != "NONE")
    place["filter"].fail("is not one of NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL");
}

}  // namespace

std::vector<uint8_t> unpack_meshopt(Document& document, const Value& place) {
  const Packed packed = open_packed(document, place);
  check(packed, place);
  if (packed.count > (uint64_t(1) << 32)) place["count"].fail("is too large", Code::limit);
  document.allowance.take(uint64_t(packed.count) * packed.stride, place);
  std::vector<uint8_t> out(packed.count * packed.stride);
  if (decode(packed, out.data()) != 0) place.fail("the packed data are corrupt");
  apply_filter(packed, out.data(), place);
  return out;
}

}  // namespace aktina::gltf
