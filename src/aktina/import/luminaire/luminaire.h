// Photometric files of luminaires: IES LM-63 and EULUMDAT.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "aktina/base/file.h"
#include "aktina/base/vec.h"
#include "aktina/base/warnings.h"
#include "aktina/illumination/light/photometric_table.h"

namespace aktina {

/// The shape that shines. Lengths in m.
struct LuminousOpening {
  enum class Shape : uint8_t { point, rectangle, ellipse, sphere, cylinder };
  Shape shape = Shape::point;
  float width = 0, length = 0, height = 0;  // along C90, along C0, along the axis
};

/// Share of the light that lamps give when their luminaire is turned. Degrees between its aim and straight down,
/// rising.
struct LampTilt {
  std::vector<float> angles, factors;  // none: lamps do not mind
};

struct Luminaire {
  std::string name, manufacturer, lamp;
  std::string format;                             // "IES LM-63-2002", "EULUMDAT"
  std::shared_ptr<const PhotometricTable> table;  // cd, all factors but the tilt's applied
  std::string symmetry;                           // "around the axis", "to C0-C180", ...
  LuminousOpening opening;
  LampTilt tilt;
  double lamp_flux = 0;  // lm, of all lamps; 0: absolute photometry, lamps are not stated apart
  double watts = 0;      // electrical
  Warnings warnings;
};

/// By content. @throws Error bad_input with the line, io, limit, unsupported
Luminaire load_luminaire(const Path& path);
/// Whether the first bytes or the extension are those of a luminaire.
bool is_luminaire(std::span<const uint8_t> bytes, const std::string& extension);

/// Factor of a luminaire's light, where it hangs: between the tilt's angles linear, beyond them as at the last.
/// @param aim  unit, world space: gamma = 0
float tilt_factor(const LampTilt& tilt, Vec3 aim);

/// IES LM-63 of 1986, 1991, 1995, 2002 and 2019; photometry of type A, B (resampled by 0.5 to 2.5 degrees) and C.
/// @param folder  where a TILT file lies
Luminaire read_ies(std::span<const uint8_t> bytes, const Path& folder, const std::string& where);
Luminaire read_eulumdat(std::span<const uint8_t> bytes, const std::string& where);

/// Full angle within which the intensity is at least `share` of that on the axis, mean over the planes. degrees
/// (share 0.5: beam angle; 0.1: field angle, IES Lighting Handbook.) 0 where the axis is dark.
double opening_angle(const PhotometricTable& table, double share);

}  // namespace aktina
