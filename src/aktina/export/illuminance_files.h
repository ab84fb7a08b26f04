// Illuminance at the points of a measuring field -> files that other programs open.
#pragma once

#include <span>

#include "aktina/export/export.h"
#include "aktina/scene/measuring_field.h"

namespace aktina {

struct IlluminanceFile {
  const MeasuringField& field;
  std::span<const double> lux;     // at each point; NaN where nothing was measured
  std::span<const double> errors;  // standard errors, lx
  Metadata metadata{};
};

/// By the extension: .csv (a line a point), .vtu (ParaView: the cells of a grid, else points), .png (false colours with
/// a scale, of grids: the first row at the bottom, so that a work plane is a plan).
/// @throws Error io, usage (another extension; a picture of what is no grid)
void write_illuminance(const Path& path, const IlluminanceFile& file);

void write_illuminance_csv(const Path& path, const IlluminanceFile& file);
void write_illuminance_vtu(const Path& path, const IlluminanceFile& file);
void write_illuminance_picture(const Path& path, const IlluminanceFile& file);

}  // namespace aktina
