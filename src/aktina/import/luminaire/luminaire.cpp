#include "aktina/import/luminaire/luminaire.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace aktina {
namespace {

constexpr uint64_t kLargestLuminaire = 64 << 20;  // bytes

/// Angle at which a plane first falls below `limit`, degrees.
double falls_below(const PhotometricTable& table, size_t plane, double limit) {
  const float* candela = &table.candela[plane * table.gamma.size()];
  for (size_t i = 1; i < table.gamma.size(); ++i)
    if (double(candela[i]) < limit) {
      const double a = double(candela[i - 1]), b = double(candela[i]);
      return double(table.gamma[i - 1]) + double(table.gamma[i] - table.gamma[i - 1]) * (a - limit) / (a - b);
    }
  return double(table.gamma.back());
}

}  // namespace

bool is_luminaire(std::span<const uint8_t> bytes, const std::string& extension) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), std::min<size_t>(bytes.size(), 16));
  return extension == "ies" || extension == "ldt" || text.starts_with("IESNA") || text.starts_with("IES:LM-63");
}

Luminaire load_luminaire(const Path& path) {
  const std::vector<uint8_t> bytes = read_file(path, kLargestLuminaire);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const bool ies = lower_extension(path) == "ies" || text.find("TILT=") != text.npos;
  return ies ? read_ies(bytes, path.parent_path(), display(path)) : read_eulumdat(bytes, display(path));
}

double opening_angle(const PhotometricTable& table, double share) {
  if (table.gamma.front() > 0 || table.candela[0] <= 0) return 0;
  const size_t planes = table.c.size() > 1 ? table.c.size() - 1 : 1;  // 360 is 0 again
  double sum = 0;
  for (size_t i = 0; i < planes; ++i)
    sum += falls_below(table, i, share * double(table.candela[i * table.gamma.size()]));
  return 2 * sum / double(planes);
}

float tilt_factor(const LampTilt& tilt, Vec3 aim) {
  if (tilt.angles.empty()) return 1;
  const float angle = std::acos(std::clamp(-aim.y, -1.0f, 1.0f)) * float(180 / kPi);
  const size_t above = size_t(std::upper_bound(tilt.angles.begin(), tilt.angles.end(), angle) - tilt.angles.begin());
  if (above == 0) return tilt.factors.front();
  if (above == tilt.angles.size()) return tilt.factors.back();
  const float t = (angle - tilt.angles[above - 1]) / (tilt.angles[above] - tilt.angles[above - 1]);
  return tilt.factors[above - 1] + (tilt.factors[above] - tilt.factors[above - 1]) * t;
}

}  // namespace aktina
