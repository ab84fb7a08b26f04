// Assimp's scene -> Document. Runs apart (apart.h): Assimp is known to crash and to hang on damaged files.
#pragma once

#include "aktina/import/assimp/document.h"

struct aiMaterial;
struct aiScene;

namespace aktina::assimp {

/// @param most_bytes  of memory for the result
/// @throws Error bad_input, limit, with an empty place
Document parse(std::span<const uint8_t> bytes, Format format, uint64_t most_bytes);

/// The parts of it.
class Counted {
 public:
  explicit Counted(Document& document) : document_(document) {}
  void add(const std::string& text, uint64_t count = 1);

 private:
  Document& document_;
};
void parse_meshes(const aiScene& scene, Document& document, uint64_t most_bytes);
void parse_materials(const aiScene& scene, Format format, Document& document);
void parse_lights_and_cameras(const aiScene& scene, Format format, Document& document);

}  // namespace aktina::assimp
