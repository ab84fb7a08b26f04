#include <fmt/core.h>

#include "aktina/export/lightmap_files.h"
#include "aktina/image/file_format.h"

namespace aktina {

std::vector<Path> write_lightmap_pictures(const Path& path, const Lightmap& lightmap, const Metadata& metadata) {
  std::vector<Path> files;
  ImageWriteOptions options;
  options.metadata = metadata;
  options.metadata.emplace_back("Quantity", "irradiance, lx, linear Rec. 709");
  options.metadata.emplace_back("Texel size", fmt::format("{:g} m", lightmap.layout.texel_size));
  for (size_t page = 0; page < lightmap.irradiances.size(); ++page) {
    Path file = path;
    if (page > 0) file.replace_extension(fmt::format(".{}.exr", page));
    write_image(file, lightmap.irradiances[page], options);
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace aktina
