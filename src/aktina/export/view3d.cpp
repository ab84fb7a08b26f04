// View3D's text format: a head line of 31 bytes, the areas, N rows, the emissivities. View3D itself writes six
// decimals; here every number has all its digits, which its readers (scanf, split) take as well.
#include <fmt/format.h>

#include "aktina/export/view_factor_files.h"

namespace aktina {
namespace {

void add_line(std::string& text, const std::vector<double>& values) {
  fmt::format_to(std::back_inserter(text), "{}", fmt::join(values, " "));
  text += '\n';
}

}  // namespace

void write_view3d(const Path& path, const ViewFactorFile& file) {
  const ViewFactors& f = file.factors;
  // Program, version of the format, 0: text, whether it was made an enclosure, whether emissivities are in it, N.
  std::string text = fmt::format("{:<30}\n", fmt::format("View3D 3.3 0 0 0 {}", f.size()));
  add_line(text, f.areas);
  for (size_t i = 0; i < f.size(); ++i) add_line(text, dense_row(f, i));
  std::vector<double> emissivities(f.size(), 1);
  if (file.bodies)
    for (size_t i = 0; i < f.size(); ++i) emissivities[i] = (*file.bodies)[i].emissivity;
  add_line(text, emissivities);
  write_file(path, text);
}

}  // namespace aktina
