#include "aktina/import/environment.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"

namespace aktina {

EnvironmentLight environment_of(std::span<const uint8_t> bytes, const std::string& where, Rgb scale, float rotation,
                                Warnings& warnings) {
  const Image picture = decode_image(bytes, where);
  EnvironmentLight light;
  light.colour = Radiance(scale), light.rotation = rotation;
  light.radiance = Image(picture.width, picture.height, 3);
  uint64_t wrong = 0;
  float most = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      Rgb c = picture.rgb(x, y);
      for (int k = 0; k < 3; ++k)
        if (!(c[k] >= 0 && std::isfinite(c[k]))) c[k] = 0, ++wrong;
      most = std::max(most, max_channel(c));
      light.radiance.set_rgb(x, y, c);
    }
  warnings.add("values of the environment that are not finite or below 0 became 0", wrong);
  if (!(most > 0)) throw Error(Code::bad_input, where, "is black: no light comes from it");
  return light;
}

}  // namespace aktina
