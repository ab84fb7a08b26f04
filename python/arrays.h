// NumPy arrays across the border: buffers of one type, rows after rows. <pybind11/numpy.h> would cost six seconds of
// compile time a file and is not needed: the Python side makes the arrays, this side reads and fills them in place.
#pragma once

#include <fmt/core.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "aktina/base/error.h"
#include "aktina/base/rgb.h"
#include "aktina/base/vec.h"

namespace aktina::python {

namespace py = pybind11;

/// A C-contiguous array of T with `columns` values in its last dimension, read in place. Lives with the buffer.
/// `Rows<const float>` is an argument, `Rows<float>` a result that the caller has allocated.
template <class T>
class Rows {
 public:
  Rows(const py::buffer& buffer, py::ssize_t columns, const char* name)
      : info_(buffer.request(!std::is_const_v<T>)), columns_(size_t(columns)) {
    using Value = std::remove_const_t<T>;
    py::ssize_t stride = info_.itemsize;
    bool fits = info_.format == py::format_descriptor<Value>::format() && info_.ndim >= 1 &&
                (columns == 1 || info_.shape.back() == columns);
    for (py::ssize_t i = info_.ndim; i-- > 0; stride *= info_.shape[size_t(i)])
      fits = fits && (info_.shape[size_t(i)] <= 1 || info_.strides[size_t(i)] == stride);
    if (!fits)
      throw Error(Code::usage, name, "the array does not fit",
                  fmt::format("contiguous '{}' in rows of {}", py::format_descriptor<Value>::format(), columns));
  }

  size_t size() const { return size_t(info_.size) / columns_; }
  T* row(size_t i) const { return static_cast<T*>(info_.ptr) + i * columns_; }
  /// Row i, or the only row: one value for everything.
  T* row_or_only(size_t i) const { return row(size() == 1 ? 0 : i); }
  T* data() const { return static_cast<T*>(info_.ptr); }
  std::span<T> values() const { return {data(), size_t(info_.size)}; }

 private:
  py::buffer_info info_;
  size_t columns_;
};

inline Vec3 vec3(const float* p) { return {p[0], p[1], p[2]}; }
inline Vec3d vec3d(const double* p) { return {p[0], p[1], p[2]}; }
inline Rgb rgb(const float* p) { return {p[0], p[1], p[2]}; }

/// @throws Error usage unless `rows` has n rows
template <class T>
void expect_rows(const Rows<T>& rows, size_t n, const char* name) {
  if (rows.size() != n) throw Error(Code::usage, name, fmt::format("has {} rows, not {}", rows.size(), n));
}

/// Memory of ours that NumPy reads in place (np.asarray), kept alive by `owner`.
struct Array {
  std::shared_ptr<const void> owner;
  const void* data;
  std::string format;
  py::ssize_t item_size;
  std::vector<py::ssize_t> shape;
};

template <class T>
Array array(std::shared_ptr<const std::vector<T>> values, std::vector<py::ssize_t> shape) {
  return {values, values->data(), py::format_descriptor<T>::format(), sizeof(T), std::move(shape)};
}
template <class T>
Array array(std::vector<T>&& values, std::vector<py::ssize_t> shape) {
  return array(std::make_shared<const std::vector<T>>(std::move(values)), std::move(shape));
}
/// A view into something that `owner` keeps alive: `n` rows of the values of T in a structure.
template <class T>
Array array_view(std::shared_ptr<const void> owner, const T* data, std::vector<py::ssize_t> shape) {
  return {std::move(owner), data, py::format_descriptor<T>::format(), sizeof(T), std::move(shape)};
}

}  // namespace aktina::python
