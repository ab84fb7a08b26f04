// Comma-separated values: the matrix with a head line of names, or one line an entry where it is large.
#include <fmt/format.h>

#include "aktina/base/error.h"
#include "aktina/export/csv.h"
#include "aktina/export/view_factor_files.h"

namespace aktina {
namespace {

void add_matrix(std::string& text, const ViewFactors& f) {
  text += "surface,area_m2";
  for (const std::string& name : f.names) text += "," + csv_field(name);
  text += "\r\n";
  for (size_t i = 0; i < f.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{}", csv_field(f.names[i]), f.areas[i]);
    for (const double factor : dense_row(f, i)) fmt::format_to(std::back_inserter(text), ",{}", factor);
    text += "\r\n";
  }
}

void add_entries(std::string& text, const ViewFactors& f) {
  text += "from,to,from_name,to_name,from_area_m2,F,error\r\n";
  std::vector<std::string> names;
  for (const std::string& name : f.names) names.push_back(csv_field(name));
  for (size_t i = 0; i < f.size(); ++i)
    for (uint64_t k = f.starts[i]; k < f.starts[i + 1]; ++k)
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\r\n", i, f.columns[k], names[i],
                     names[f.columns[k]], f.areas[i], f.factors[k], f.errors[k]);
}

void add_bodies(std::string& text, const ViewFactorFile& file) {
  text += "\r\nsurface,emissivity,temperature_K,radiosity_W_m2,flux_W_m2\r\n";
  for (size_t i = 0; i < file.factors.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\r\n", csv_field(file.factors.names[i]),
                   (*file.bodies)[i].emissivity, file.balance->temperatures[i], file.balance->radiosities[i],
                   file.balance->fluxes[i]);
}

void add_script_f(std::string& text, const ViewFactorFile& file) {
  const size_t n = file.factors.size();
  text += "\r\nscript_F,emissivity";
  for (const std::string& name : file.factors.names) text += "," + csv_field(name);
  text += "\r\n";
  for (size_t i = 0; i < n; ++i) {
    fmt::format_to(std::back_inserter(text), "{},{}", csv_field(file.factors.names[i]), (*file.bodies)[i].emissivity);
    for (size_t j = 0; j < n; ++j) fmt::format_to(std::back_inserter(text), ",{}", file.exchange->script_f[i * n + j]);
    text += "\r\n";
  }
}

}  // namespace

void write_view_factors_csv(const Path& path, const ViewFactorFile& file) {
  std::string text;
  for (const auto& [name, value] : file.metadata) text += fmt::format("# {}: {}\r\n", one_line(name), one_line(value));
  file.factors.size() <= kMostDense ? add_matrix(text, file.factors) : add_entries(text, file.factors);
  if (file.exchange && file.factors.size() <= kMostDense) add_script_f(text, file);
  if (file.balance) add_bodies(text, file);
  write_file(path, text);
}

}  // namespace aktina
