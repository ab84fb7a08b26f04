// Wavefront OBJ and MTL: the parts of the reader.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "aktina/import/beside.h"

namespace aktina::obj {

/// Indices from 0 into the file's lists, not yet checked; kNone where the file gives none.
struct Corner {
  int64_t position, uv, normal;
};
inline constexpr int64_t kNone = INT64_MIN;

/// Faces of one object and group, of one material and one smoothing group.
struct Part {
  std::string object, group, material;
  int64_t smoothing;            // -1: not stated; 0: off
  bool has_normals;             // at every corner
  std::vector<uint32_t> sizes;  // corners of each face
  std::vector<Corner> corners;
};

struct File {
  std::vector<Point3> positions;
  std::vector<Vec4> colours;  // linear; as many as positions where any vertex has one
  std::vector<Vec2> uvs;
  std::vector<Vec3> normals;
  std::vector<Part> parts;
  std::vector<std::string> libraries;  // rest of each mtllib line
  uint64_t points = 0, lines = 0, colourless = 0;
  Warnings warnings;
};

/// @throws Error bad_input with the line
File parse(std::string_view text, const std::string& where);

/// Materials of an MTL file, added to the scene; names are put into `index`. A name that is there already is kept.
void read_mtl(std::string_view text, const std::string& where, Beside& beside, Scene& scene,
              std::map<std::string, int>& index);

}  // namespace aktina::obj
