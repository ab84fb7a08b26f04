// Lists, strips and fans of triangles.
#include "aktina/import/gltf/meshes.h"

namespace aktina::gltf {

std::vector<std::array<uint32_t, 3>> triangulate(const std::vector<uint32_t>& v, uint64_t mode) {
  std::vector<std::array<uint32_t, 3>> out;
  if (v.size() < 3) return out;
  out.reserve(mode == 4 ? v.size() / 3 : v.size() - 2);
  if (mode == 4)
    for (size_t i = 0; i + 2 < v.size(); i += 3) out.push_back({v[i], v[i + 1], v[i + 2]});
  if (mode == 5)  // every second triangle of a strip turns the other way
    for (size_t i = 0; i + 2 < v.size(); ++i) out.push_back({v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
  if (mode == 6)
    for (size_t i = 1; i + 1 < v.size(); ++i) out.push_back({v[i], v[i + 1], v[0]});
  return out;
}

}  // namespace aktina::gltf
