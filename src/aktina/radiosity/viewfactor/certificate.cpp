#include "aktina/radiosity/viewfactor/certificate.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/statistics.h"

namespace aktina {
namespace {

constexpr double kClosed = 1e-3;  // rows of an enclosure come nearer to 1 than this
constexpr size_t kWorst = 10;

void look_at_entries(const ViewFactors& f, Certificate& c) {
  bool first = true;
  for (size_t i = 0; i < f.size(); ++i)
    for (uint64_t k = f.starts[i]; k < f.starts[i + 1]; ++k) {
      const uint32_t j = f.columns[k];
      const double value = f.factors[k], error = double(f.errors[k]);
      c.least = first ? value : std::min(c.least, value), c.most = first ? value : std::max(c.most, value);
      first = false;
      c.out_of_bounds += !(value >= 0 && value <= 1 + 1e-12);
      if (error > c.largest_error)
        c.largest_error = error, c.largest_error_row = uint32_t(i), c.largest_error_column = j;
    }
}

/// Rows ascend, and so do the entries of a row: each row's partners come by in its own order.
void look_at_reciprocity(const ViewFactors& f, Certificate& c) {
  std::vector<uint64_t> next(f.starts.begin(), f.starts.end() - 1);
  for (uint32_t i = 0; i < f.size(); ++i)
    for (uint64_t k = f.starts[i]; k < f.starts[i + 1]; ++k) {
      const uint32_t j = f.columns[k];
      uint64_t& at = next[j];
      while (at < f.starts[j + 1] && f.columns[at] < i) ++at;
      const double other = at < f.starts[j + 1] && f.columns[at] == i ? f.factors[at] : 0;
      const double difference = std::abs(f.areas[i] * f.factors[k] - f.areas[j] * other);
      c.worst_reciprocity = std::max(c.worst_reciprocity, difference / std::min(f.areas[i], f.areas[j]));
    }
}

}  // namespace

Certificate certify(const ViewFactors& f) {
  Certificate c;
  c.largest_excess = f.largest_excess, c.held = f.held;
  look_at_entries(f, c);
  look_at_reciprocity(f, c);
  Sum squares, area;
  std::vector<Certificate::Row> rows;
  for (size_t i = 0; i < f.size(); ++i) {
    if (!f.known(i, i)) continue;
    double error = 0;
    for (uint64_t k = f.starts[i]; k < f.starts[i + 1]; ++k) error += double(f.errors[k]);
    rows.push_back({uint32_t(i), f.row_sum(i), error});
    squares.add(f.areas[i] * (rows.back().sum - 1) * (rows.back().sum - 1)), area.add(f.areas[i]);
  }
  if (rows.empty()) return c;
  c.mean_closure = std::sqrt(squares.value() / area.value());
  const auto [least, most] =
      std::minmax_element(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.sum < b.sum; });
  c.least_sum = least->sum, c.most_sum = most->sum;
  c.closed = std::abs(c.least_sum - 1) <= kClosed && std::abs(c.most_sum - 1) <= kClosed;
  // In an open scene a low sum is no fault.
  const auto badness = [&](const Certificate::Row& row) { return c.closed ? std::abs(row.sum - 1) : row.error; };
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return badness(a) > badness(b); });
  rows.resize(std::min(rows.size(), kWorst));
  c.worst = std::move(rows);
  return c;
}

}  // namespace aktina
