#include "aktina/import/beside.h"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"

namespace aktina {
namespace {

/// Below `folder`, also after links are followed, and there.
std::optional<Path> confined(const Path& folder, const Path& relative) {
  std::error_code error;
  if (relative.empty() || relative.is_absolute()) return {};
  const Path root = std::filesystem::weakly_canonical(folder.empty() ? Path(".") : folder, error);
  if (error) return {};
  const Path full = std::filesystem::weakly_canonical(root / relative, error);
  const Path below = full.lexically_relative(root);
  if (error || below.empty() || *below.begin() == "..") return {};
  if (!std::filesystem::is_regular_file(full, error)) return {};
  return folder / relative;
}

std::string media_type(std::span<const uint8_t> bytes) {
  switch (detect_image_format(bytes)) {
    case ImageFormat::png:
      return "image/png";
    case ImageFormat::jpeg:
      return "image/jpeg";
    case ImageFormat::webp:
      return "image/webp";
    default:
      return "";
  }
}

}  // namespace

std::optional<Path> Beside::find(std::string name) const {
  std::replace(name.begin(), name.end(), '\\', '/');
  if (name.empty() || name.size() > 4096 || name.find('\0') != name.npos) return {};
  const Path relative(std::u8string(name.begin(), name.end()));
  if (auto path = confined(folder_, relative)) return path;
  return confined(folder_, relative.filename());
}

std::vector<uint8_t> Beside::read(const Path& path) {
  std::vector<uint8_t> bytes = read_file(path, std::min(left_, kLargestFile));
  left_ -= bytes.size();
  return bytes;
}

int Beside::image(Scene& scene, const std::string& name) {
  if (const auto known = images_.find(name); known != images_.end()) return known->second;
  const std::optional<Path> path = find(name);
  if (!path) {
    scene.warnings.add(fmt::format("picture '{}' is missing: its surfaces have their plain colour", name));
    return images_[name] = -1;
  }
  const int index = image(scene, name, read(*path));
  if (index >= 0) scene.images[size_t(index)].uri = path->lexically_relative(folder_).generic_string();
  return index;
}

int Beside::image(Scene& scene, const std::string& key, std::vector<uint8_t> encoded) {
  if (const auto known = images_.find(key); known != images_.end()) return known->second;
  TextureImage image;
  image.name = Path(key).filename().string();
  image.media_type = media_type(encoded);
  try {
    image.pixels = decode_texture(encoded, key);
  } catch (const Error& error) {
    scene.warnings.add(fmt::format("{}: its surfaces have their plain colour", error.what()));
    return images_[key] = -1;
  }
  image.encoded = std::move(encoded);
  scene.images.push_back(std::move(image));
  return images_[key] = int(scene.images.size()) - 1;
}

void check_memory(uint64_t bytes, const std::string& where, const ImportOptions& options) {
  if (bytes > options.most_bytes)
    throw Error(Code::limit, where, fmt::format("needs about {} MB of memory", bytes >> 20),
                fmt::format("{} MB are allowed", options.most_bytes >> 20));
}

}  // namespace aktina
