// Bands of blocks -> rows of pictures.
#pragma once

#include "aktina/image/image.h"
#include "aktina/raster/band.h"

namespace aktina {

/// Copies the colour of a band to its rows of a picture of as many pixels; `background` where nothing is seen, unless
/// the band is filled.
void resolve_colour(const RasterBand& band, const View& view, Rgb background, Image& out);
/// The same where each pixel has side x side samples: their mean. @pre  filled
void average_colour(const RasterBand& band, int side, Image& out);

/// PictureLayers of a picture, or null: albedo, N, P take three channels, Z one. A pixel shows its middle sample.
struct PictureLayers {
  Image *albedo = nullptr, *normal = nullptr, *position = nullptr, *depth = nullptr;
};
void resolve_layers(const RasterBand& band, const View& view, int side, const PictureLayers& out);

}  // namespace aktina
