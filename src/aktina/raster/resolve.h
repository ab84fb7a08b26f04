// Bands of blocks -> rows of pictures.
#pragma once

#include "aktina/image/image.h"
#include "aktina/raster/band.h"

namespace aktina {

/// Copies the colour of a band to its rows of a picture of as many pixels.
void resolve_colour(const Band& band, Image& out);
/// The same where each pixel has side x side samples: their mean.
void average_colour(const Band& band, int side, Image& out);

/// Layers of a picture, or null: albedo, N, P take three channels, Z one. A pixel shows its middle sample.
struct Layers {
  Image *albedo = nullptr, *normal = nullptr, *position = nullptr, *depth = nullptr;
};
void resolve_layers(const Band& band, const View& view, int side, const Layers& out);

}  // namespace aktina
