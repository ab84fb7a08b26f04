#include "aktina/export/illuminance_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"
#include "aktina/image/legend.h"
#include "aktina/image/metric.h"

namespace aktina {

void write_illuminance(const Path& path, const IlluminanceFile& file) {
  const std::string extension = lower_extension(path);
  if (extension == "csv") return write_illuminance_csv(path, file);
  if (extension == "vtu") return write_illuminance_vtu(path, file);
  if (extension == "png") return write_illuminance_picture(path, file);
  throw Error(Code::usage, display(path), "cannot tell the format from the name", "one of .csv, .vtu, .png");
}

void write_illuminance_csv(const Path& path, const IlluminanceFile& file) {
  std::string text;
  for (const auto& [name, value] : file.metadata) text += fmt::format("# {}: {}\r\n", one_line(name), one_line(value));
  text += "x_m,y_m,z_m,normal_x,normal_y,normal_z,area_m2,illuminance_lx,standard_error_lx\r\n";
  const MeasuringField& f = file.field;
  for (size_t i = 0; i < f.points.size(); ++i) {
    if (!std::isfinite(file.lux[i])) continue;
    const Point3 p = f.points[i];
    const Vec3 n = f.normals[i];
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{:.6g},{:.3g}\r\n", p.x, p.y, p.z, n.x, n.y, n.z,
                   f.areas[i], file.lux[i], file.errors[i]);
  }
  write_file(path, text);
}

void write_illuminance_picture(const Path& path, const IlluminanceFile& file) {
  constexpr int kLongestSide = 640;
  const MeasuringField& f = file.field;
  if (!f.is_grid())
    throw Error(Code::usage, display(path), "only grids and work planes have a picture", "write .csv or .vtu");
  double most = 0;
  for (const double e : file.lux)
    if (std::isfinite(e)) most = std::max(most, e);
  const double width = double(length(f.u)) * f.columns, depth = double(length(f.v)) * f.rows;
  const double pixels = kLongestSide / std::max(width, depth);
  Image map(std::max(int(width * pixels), 1), std::max(int(depth * pixels), 1), 1);
  const auto at = [&](int x, int y) {
    const int column = std::min(x * f.columns / map.width, f.columns - 1);
    const int row = f.rows - 1 - std::min(y * f.rows / map.height, f.rows - 1);
    return file.lux[size_t(row) * size_t(f.columns) + size_t(column)];
  };
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) *map.at(x, y) = most > 0 ? float(at(x, y) / most) : 0;
  Image picture = false_colour(map);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      if (!std::isfinite(at(x, y))) picture.set_rgb(x, y, Rgb(0.5f));
  ImageWriteOptions options;
  options.tone_mapping.exposure = 1;
  options.metadata = file.metadata;
  write_image(path, with_legend(picture, 0, most, "lx"), options);
}

}  // namespace aktina
