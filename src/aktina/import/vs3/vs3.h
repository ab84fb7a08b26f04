// View3D's input files (.vs3): surfaces for view factors, not for pictures. G. Walton, "Calculation of Obstructed View
// Factors by Adaptive Integration", NISTIR 6925, 2002; View3D 3.3 user manual.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "aktina/base/vec.h"
#include "aktina/base/warnings.h"

namespace aktina {

/// Coordinates in metres, as they stand in the file. Fronts are where the corners run counter-clockwise.
struct Vs3 {
  enum class Kind : uint8_t { surface, null, obstruction };
  struct Surface {
    Kind kind;
    int64_t number;
    std::vector<Point3d> corners;  // three or four
    int64_t base;                  // number of the surface that it is a part of, 0: none
    int64_t combine;               // number of the surface that it is counted with, 0: none
    double emissivity;
    std::string name;
  };
  std::string title;
  std::vector<Surface> surfaces;
  Warnings warnings;
};

/// Format F=3 with V, S, N and O lines; controls (C) are read over.
/// @param where  for messages
/// @throws Error bad_input (no such vertex or surface, no number), unsupported (F=3a, F=2, masking surfaces)
Vs3 read_vs3(std::string_view text, const std::string& where);

}  // namespace aktina
