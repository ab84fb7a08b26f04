// What a method says about itself. The program, the Python module, the studio and docs/methods/ read only this.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aktina {

struct Param {
  std::string_view id, unit, help;  // unit: "1", "m", "rad", "px", "lx"
  double value, min, max;           // default, and the closed range that is accepted
  bool whole = false;               // only whole numbers
};

struct MethodInfo {
  std::string_view id;       // the file's stem = word on the command line = name in Python = key in JSON
  std::string_view title;    // "Gouraud intensity interpolation"
  std::string_view cite;     // key in docs/references.bib
  std::string_view summary;  // one sentence: what it gives, what it costs, where it fails
  std::span<const Param> params = {};
};

/// Values for the parameters of one method: defaults first, each checked when it is set.
class ParamSet {
 public:
  explicit ParamSet(const MethodInfo& method);

  /// @throws Error bad_param (outside the range, not a number, not whole) or usage (unknown id; lists the known ones)
  void set(std::string_view id, double value);
  double operator[](std::string_view id) const;
  const MethodInfo& method() const { return *method_; }

 private:
  size_t index(std::string_view id) const;
  const MethodInfo* method_;
  std::vector<double> values_;
};

/// One row of a family's table. Product: std::unique_ptr<Interface>, or a plain struct in a variant.
template <class Product>
struct Method {
  MethodInfo info;
  Product (*make)(const ParamSet&);
};

/// "hemicube:resolution=256,rotate=1" -> {"hemicube", {{"resolution", 256}, {"rotate", 1}}}.
struct MethodChoice {
  std::string id;
  std::vector<std::pair<std::string, double>> values;
};
/// @throws Error usage (also where a parameter is given twice)
MethodChoice parse_method(std::string_view text);

[[noreturn]] void no_such_method(std::string_view family, std::string_view id, std::string_view choices);

/// The row called `id`. @throws Error no_such_method, listing the choices
template <class Row>
const Row& find_method(std::span<const Row* const> table, std::string_view family, std::string_view id) {
  std::string choices;
  for (const Row* row : table) {
    if (row->info.id == id) return *row;
    choices += (choices.empty() ? "" : ", ") + std::string(row->info.id);
  }
  no_such_method(family, id, choices);
}

/// Makes the method that `choice` ("gouraud" or "hemicube:resolution=256") names.
template <class Product>
Product make_method(std::span<const Method<Product>* const> table, std::string_view family, std::string_view choice) {
  const MethodChoice parsed = parse_method(choice);
  const Method<Product>& row = find_method(table, family, parsed.id);
  ParamSet params(row.info);
  for (const auto& [id, value] : parsed.values) params.set(id, value);
  return row.make(params);
}

}  // namespace aktina
