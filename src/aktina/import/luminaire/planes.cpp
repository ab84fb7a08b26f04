#include "aktina/import/luminaire/planes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "aktina/base/error.h"

namespace aktina {
namespace {

/// Adds the mirror image of each plane: at `twice` - c.
void mirror(PhotometricTable& table, float twice) {
  std::map<float, std::vector<float>> planes;
  const size_t n = table.gamma.size();
  for (size_t i = 0; i < table.c.size(); ++i) {
    const std::vector<float> plane(&table.candela[i * n], &table.candela[i * n] + n);
    const auto turned = [](float c) { return c < 0 ? c + 360 : c > 360 ? c - 360 : c; };
    planes[table.c[i]] = plane;
    planes.emplace(turned(twice - table.c[i]), plane);
  }
  table.c.clear(), table.candela.clear();
  for (const auto& [c, plane] : planes) {
    table.c.push_back(c);
    table.candela.insert(table.candela.end(), plane.begin(), plane.end());
  }
}

/// The plane at 0 and at 360 are one.
void close(PhotometricTable& table) {
  const size_t n = table.gamma.size();
  if (table.c.front() == 0 && table.c.back() < 360) {
    table.c.push_back(360);
    for (size_t i = 0; i < n; ++i) table.candela.push_back(table.candela[i]);
  } else if (table.c.front() > 0 && table.c.back() == 360) {
    const std::vector<float> last(table.candela.end() - long(n), table.candela.end());
    table.c.insert(table.c.begin(), 0);
    table.candela.insert(table.candela.begin(), last.begin(), last.end());
  }
}

}  // namespace

const char* complete_planes(PhotometricTable& table) {
  if (table.c.empty()) throw Error(Code::bad_param, "", "has no C planes");
  const float first = table.c.front(), last = table.c.back();
  if (table.c.size() == 1) {
    table.c = {0};
    return "around the axis";
  }
  if (first == 0 && last == 90) {
    mirror(table, 180), mirror(table, 360), close(table);
    return "to C0-C180 and C90-C270";
  }
  if (first == 0 && last == 180) {
    mirror(table, 360), close(table);
    return "to C0-C180";
  }
  if (first == 90 && last == 270) {  // C270 .. C360 and C0 .. C90 are the mirror images
    mirror(table, 540), close(table);
    return "to C90-C270";
  }
  if (!(first == 0 && last > 180 && last <= 360)) throw Error(Code::bad_param, "", "its C planes do not close");
  close(table);
  return "none";
}

}  // namespace aktina
