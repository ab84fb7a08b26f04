// Files that a scene file names: beside it or below, never elsewhere.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "aktina/import/import.h"

namespace aktina {

/// Reads what a scene file refers to, each picture once.
class Beside {
 public:
  Beside(Path folder, const ImportOptions& options) : folder_(std::move(folder)), left_(options.most_bytes) {}

  /// Path below the folder for a name as files have it: backslashes of Windows, blanks. A file that is not where the
  /// name says (an absolute path, another folder) is looked for beside the scene under its last part. None: not there.
  std::optional<Path> find(std::string name) const;
  /// @throws Error io, limit
  std::vector<uint8_t> read(const Path& path);

  /// Index into scene.images of a picture; -1, with a counted warning, where it is missing or broken.
  int image(Scene& scene, const std::string& name);
  /// A picture that came within the scene file; `key` names it.
  int image(Scene& scene, const std::string& key, std::vector<uint8_t> encoded);

  /// A picture of others in the scene, added to it: the colours of one (-1: white) with the opacity that another shows,
  /// by its alpha where it has any, else by its grey. @return its index
  int with_alpha(Scene& scene, int colour, int opacity);
  /// The same: metallic in blue, roughness in green; one of both may be -1, which is 1 everywhere.
  int metallic_roughness(Scene& scene, int metallic, int roughness);

 private:
  Path folder_;
  uint64_t left_;
  std::map<std::string, int> images_;
};

/// @throws Error limit if a scene of that size is more than the options allow
void check_memory(uint64_t bytes, const std::string& where, const ImportOptions& options);

}  // namespace aktina
