// What a file holds that Assimp reads, as plain data: it crosses from the process that reads it to ours (apart.h).
// fields() names the fields of each struct in the order in which they are sent and received.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "aktina/base/vec.h"
#include "aktina/base/warnings.h"

namespace aktina::assimp {

enum class Format : uint8_t { fbx, collada, max3ds };

struct FileNode {
  std::string name;
  int32_t parent = -1;  // before this one
  Mat4 local{1};        // the root's brings the file's units and axes to metres and +y up
  template <class Wire>
  void fields(Wire& wire) {
    wire(name, parent, local);
  }
};

/// Polygons over vertices of their own: nothing is shared yet.
struct FileMesh {
  std::string name;
  int32_t material = -1;
  std::vector<Vec3> positions, normals;
  std::array<std::vector<Vec2>, 2> uv;  // v up
  std::vector<Vec4> colours;
  std::vector<uint32_t> sizes, corners;  // corners of each polygon; their vertices, polygon after polygon
  template <class Wire>
  void fields(Wire& wire) {
    wire(name, material, positions, normals, uv[0], uv[1], colours, sizes, corners);
  }
};
struct FileMeshUse {
  int32_t node = -1, mesh = -1;
};

struct FileTexture {
  std::string file;  // empty: none
  int32_t uv_set = 0;
  Vec2 offset{0}, scale{1};
  uint8_t wrap_u = 0, wrap_v = 0;  // Wrap
  template <class Wire>
  void fields(Wire& wire) {
    wire(file, uv_set, offset, scale, wrap_u, wrap_v);
  }
};

struct FileMaterial {
  std::string name;
  Vec3 ka{0}, kd{0.8f}, ks{0}, kr{0}, emission{0};
  float exponent = 1, index = 1, opacity = 1;  // exponent: Phong's
  uint8_t double_sided = 0;
  FileTexture diffuse, emissive, normal, alpha;
  template <class Wire>
  void fields(Wire& wire) {
    wire(name, ka, kd, ks, kr, emission, exponent, index, opacity, double_sided);
    wire(diffuse, emissive, normal, alpha);
  }
};

struct FileLight {
  enum Kind : uint8_t { point, spot, directional, ambient };
  std::string name;
  uint8_t kind = point;
  int32_t node = -1;
  Vec3 position{0}, direction{0, 0, -1}, colour{1};      // in the node's space; colour as the classic models have it
  Vec3 attenuation{1, 0, 0};                             // 1 / (a + b d + c d^2), d in the file's units
  float inner_angle = 0, outer_angle = 0, exponent = 0;  // rad, from the axis
  template <class Wire>
  void fields(Wire& wire) {
    wire(name, kind, node, position, direction, colour, attenuation, inner_angle, outer_angle, exponent);
  }
};

struct FileCamera {
  std::string name;
  int32_t node = -1;
  Vec3 position{0}, forward{0, 0, -1}, up{0, 1, 0};  // in the node's space
  float width_angle = 0.8f, aspect = 0;              // rad, whole; width / height, 0: not said
  float half_width = 0;                              // orthographic where above 0; file's units
  float near = 0, far = 0;                           // file's units
  template <class Wire>
  void fields(Wire& wire) {
    wire(name, node, position, forward, up, width_angle, aspect, half_width, near, far);
  }
};

/// A picture within the file, encoded as PNG, JPEG or whatever it says.
struct FilePicture {
  std::string name;
  std::vector<uint8_t> bytes;
  template <class Wire>
  void fields(Wire& wire) {
    wire(name, bytes);
  }
};

struct FileWarning {
  std::string text;
  uint64_t count = 1;
  template <class Wire>
  void fields(Wire& wire) {
    wire(text, count);
  }
};

struct Document {
  std::string generator;
  double metres_per_unit = 1;  // already in the root's matrix
  std::vector<FileNode> nodes;
  std::vector<FileMesh> meshes;
  std::vector<FileMeshUse> uses;
  std::vector<FileMaterial> materials;
  std::vector<FileLight> lights;
  std::vector<FileCamera> cameras;
  std::vector<FilePicture> pictures;
  std::vector<FileWarning> warnings;
  template <class Wire>
  void fields(Wire& wire) {
    wire(generator, metres_per_unit, nodes, meshes, uses, materials, lights, cameras, pictures, warnings);
  }
};

using Sink = std::function<void(std::span<const uint8_t>)>;
using Source = std::function<void(std::span<uint8_t>)>;  // fills all of it, or throws

void write(Document& document, const Sink& sink);
/// Checks every index against what it points into: whoever wrote the bytes is not trusted.
/// @param most_bytes  more is refused
/// @throws Error bad_input, limit; what `source` throws
Document read(const Source& source, uint64_t most_bytes, const std::string& where);

}  // namespace aktina::assimp
