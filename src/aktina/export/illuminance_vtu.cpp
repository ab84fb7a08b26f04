#include <cmath>

#include "aktina/export/illuminance_files.h"
#include "aktina/export/vtu_writer.h"

namespace aktina {
namespace {

constexpr uint8_t kVertex = 1, kQuad = 9;  // VTK's cell types

/// What the file holds of each measured point: the corners of its cell, or itself.
struct Cells {
  std::vector<float> positions;
  std::vector<int64_t> corners, ends;
  void add(Point3 p) {
    corners.push_back(int64_t(corners.size()));
    positions.insert(positions.end(), {p.x, p.y, p.z});
  }
};

Cells cells_of(const IlluminanceFile& file) {
  const MeasuringField& f = file.field;
  Cells cells;
  for (size_t i = 0; i < f.points.size(); ++i) {
    if (!std::isfinite(file.lux[i])) continue;
    if (f.is_grid())
      for (const Vec2 side : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
        cells.add(f.points[i] + 0.5f * (side.x * f.u + side.y * f.v));
    else
      cells.add(f.points[i]);
    cells.ends.push_back(int64_t(cells.corners.size()));
  }
  return cells;
}

std::vector<double> measured(const IlluminanceFile& file, std::span<const double> values) {
  std::vector<double> out;
  for (size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(file.lux[i])) out.push_back(values[i]);
  return out;
}

}  // namespace

void write_illuminance_vtu(const Path& path, const IlluminanceFile& file) {
  const Cells cells = cells_of(file);
  VtuWriter out(file.metadata, cells.corners.size(), cells.ends.size());
  out.open(R"(CellData Scalars="illuminance")");
  out.array("illuminance", "lx", 1, measured(file, file.lux));
  out.array("standard_error", "lx", 1, measured(file, file.errors));
  out.array("area", "m^2", 1, measured(file, file.field.areas));
  out.close("CellData");
  out.open("Points");
  out.array("Points", "m", 3, cells.positions);
  out.close("Points");
  out.open("Cells");
  out.array("connectivity", "", 1, cells.corners);
  out.array("offsets", "", 1, cells.ends);
  out.array("types", "", 1, std::vector<uint8_t>(cells.ends.size(), file.field.is_grid() ? kQuad : kVertex));
  out.close("Cells");
  out.finish(path);
}

}  // namespace aktina
