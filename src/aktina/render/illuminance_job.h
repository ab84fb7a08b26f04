// The illuminance job: what light meters read at points, and what a lighting standard makes of it.
#pragma once

#include "aktina/base/file.h"
#include "aktina/base/progress.h"
#include "aktina/render/report.h"
#include "aktina/scene/measuring_field.h"
#include "aktina/trace/illuminance.h"

namespace aktina {

struct IlluminanceResult {
  Measurement measurement;
  double average = 0;  // lx, over the area
  double minimum = 0, maximum = 0;
  size_t points = 0;  // measured
  Report report;
  double uniformity() const { return average > 0 ? minimum / average : 0; }  // U0 of EN 12665
  double diversity() const { return maximum > 0 ? minimum / maximum : 0; }   // Ud
};

/// @throws Error as measure_illuminance(); bad_param where all points lie inside of bodies
IlluminanceResult illuminance(const Scene& scene, const MeasuringField& field, const MeasureOptions& options,
                              Progress& progress);

/// One object: average, minimum, maximum, uniformity and how well they are known.
std::string illuminance_json(const MeasuringField& field, const IlluminanceResult& result);

/// Points from lines of x,y,z or x,y,z,normal_x,normal_y,normal_z; up where no normal is given. A first line of words
/// and lines that begin with # are left out. @throws Error io, bad_input (a line that is something else), limit
MeasuringField read_points(const Path& path);

}  // namespace aktina
