// Structures as Python dictionaries: one list of fields a structure (`fields_of`), read and written by the same
// visitors.
#pragma once

#include <fmt/core.h>
#include <pybind11/pybind11.h>

#include <cmath>
#include <concepts>
#include <set>
#include <string>
#include <vector>

#include "aktina/base/error.h"
#include "aktina/base/quantity.h"
#include "aktina/base/vec.h"

namespace aktina::python {

namespace py = pybind11;

/// Sets the fields that a dictionary names.
class FromDict {
 public:
  /// @param where  what the dictionary is, for messages: "light"
  FromDict(const py::dict& dict, std::string where) : dict_(dict), where_(std::move(where)) {}

  template <class T>
  void operator()(const char* name, T& value) {
    known_.insert(name);
    if (!dict_.contains(name)) return;
    try {
      read(dict_[name], value);
    } catch (const py::error_already_set& error) {
      fail(name);
    } catch (const py::cast_error& error) {
      fail(name);
    }
  }

  /// A field that somebody else reads.
  void expect_known(const char* name) { known_.insert(name); }

  /// @throws Error usage if the dictionary holds a key that no field has
  void expect_all_read() const {
    std::string choices;
    for (const std::string& name : known_) choices += (choices.empty() ? "" : ", ") + name;
    for (const auto& [key, value] : dict_)
      if (const std::string name = py::str(key); !known_.count(name))
        throw Error(Code::usage, where_ + "." + name, "no such field", "there are: " + choices);
  }

 private:
  [[noreturn]] void fail(const char* name) const {
    throw Error(Code::usage, where_ + "." + name, "cannot read " + std::string(py::repr(dict_[name])));
  }

  static void read(const py::handle& from, std::string& to) { to = py::cast<std::string>(from); }
  static void read(const py::handle& from, bool& to) { to = py::cast<bool>(from); }
  static void read(const py::handle& from, int& to) { to = py::cast<int>(from); }
  template <std::floating_point T>
  static void read(const py::handle& from, T& to) {
    to = T(py::cast<double>(from));
    if (!std::isfinite(to)) throw py::cast_error("not finite");
  }
  template <int n, class T>
  static void read(const py::handle& from, glm::vec<n, T>& to) {
    const py::list values(py::reinterpret_borrow<py::object>(from));
    if (values.size() != size_t(n)) throw py::cast_error("wrong length");
    for (int i = 0; i < n; ++i) read(values[size_t(i)], to[i]);
  }
  template <class T>
  static void read(const py::handle& from, std::vector<T>& to) {
    for (const py::handle& item : py::list(py::reinterpret_borrow<py::object>(from))) read(item, to.emplace_back());
  }
  static void read(const py::handle& from, Rgb& to) {
    if (!py::hasattr(from, "__len__")) {  // one number: grey
      float grey = 0;
      read(from, grey);
      to = Rgb(grey);
      return;
    }
    Vec3 values;
    read(from, values);
    to = {values.x, values.y, values.z};
  }
  template <class Tag>
  static void read(const py::handle& from, Quantity<Tag>& to) {
    read(from, to.v);
  }

  const py::dict& dict_;
  std::string where_;
  std::set<std::string> known_;
};

/// Collects all fields.
class ToDict {
 public:
  template <class T>
  void operator()(const char* name, const T& value) {
    dict_[name] = write(value);
  }
  py::dict dict() const { return dict_; }

 private:
  template <class T>
  static py::object write(const T& value) {
    return py::cast(value);
  }
  template <int n, class T>
  static py::object write(const glm::vec<n, T>& value) {
    py::tuple values(n);
    for (int i = 0; i < n; ++i) values[size_t(i)] = value[i];
    return values;
  }
  static py::object write(const Rgb& value) { return py::make_tuple(value.r, value.g, value.b); }
  template <class Tag>
  static py::object write(const Quantity<Tag>& value) {
    return write(value.v);
  }

  py::dict dict_;
};

/// A structure from a dictionary, its other fields as they are by default.
template <class T>
T from_dict(const py::dict& dict, const std::string& where) {
  T value;
  FromDict reader(dict, where);
  fields_of(value, reader);
  reader.expect_all_read();
  return value;
}

template <class T>
py::dict to_dict(T value) {
  ToDict writer;
  fields_of(value, writer);
  return writer.dict();
}

}  // namespace aktina::python
