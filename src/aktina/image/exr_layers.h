// How pictures lie in the channels of an OpenEXR file: "albedo.R" is channel R of the layer "albedo".
#pragma once

#include <string>
#include <vector>

#include "aktina/image/image.h"

namespace aktina {

struct ExrLayer {
  std::string name;                   // empty: the picture
  std::vector<std::string> channels;  // full names, in the order in which an Image has them
  bool luminance_chroma = false;      // Y, RY, BY (and A) instead of R, G, B
  bool colour = false;                // R, G, B: the file's primaries apply

  /// Channels of the Image: Y, RY, BY are decoded to R, G, B.
  int image_channels() const { return int(channels.size()); }
};

/// The file's channels as layers: of each name before the last dot the colours (R G B A, Y RY BY A, Y A) or the vector
/// (X Y Z); what is left becomes a layer of one channel, called by its full name. The picture comes first: what has no
/// name, or else the first layer with colours, or else the first.
std::vector<ExrLayer> group_exr_channels(const std::vector<std::string>& channels);

/// Names for the channels of a layer that is written: R G B A, or X Y Z for the vectors N and P, or Y A; depth is "Z".
std::vector<std::string> exr_channel_names(const std::string& layer, int channels);

}  // namespace aktina
