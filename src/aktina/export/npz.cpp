// NumPy's .npz: a ZIP archive (stored, ZIP64) of .npy arrays, as numpy.lib.format describes them. Sparse matrices have
// the arrays that scipy.sparse.load_npz reads.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "aktina/base/error.h"
#include "aktina/export/view_factor_files.h"

namespace aktina {
namespace {

/// PKZIP's CRC-32, eight bytes at a time.
/// M. Kounavis, F. Berry, "A Systematic Approach to Building High Performance Software-Based CRC Generators", ISCC
/// 2005.
class Crc32 {
 public:
  void add(std::string_view bytes) {
    size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
      uint64_t word = 0;
      std::memcpy(&word, bytes.data() + i, 8);
      word ^= value_;
      value_ = 0;
      for (size_t k = 0; k < 8; ++k) value_ ^= kTables[7 - k][word >> 8 * k & 0xff];
    }
    for (; i < bytes.size(); ++i) value_ = kTables[0][(value_ ^ uint8_t(bytes[i])) & 0xff] ^ (value_ >> 8);
  }
  uint32_t value() const { return ~value_; }

 private:
  using Tables = std::array<std::array<uint32_t, 256>, 8>;
  static constexpr Tables kTables = [] {
    Tables tables{};
    for (uint32_t i = 0; i < 256; ++i) {
      uint32_t c = i;
      for (int bit = 0; bit < 8; ++bit) c = c & 1 ? 0xedb88320U ^ (c >> 1) : c >> 1;
      tables[0][i] = c;
    }
    for (size_t k = 1; k < 8; ++k)
      for (size_t i = 0; i < 256; ++i) tables[k][i] = tables[0][tables[k - 1][i] & 0xff] ^ (tables[k - 1][i] >> 8);
    return tables;
  }();
  uint32_t value_ = 0xffffffffU;
};

template <class T>
void put(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// @param values  numbers that follow each other
template <class Values>
std::string_view bytes_of(const Values& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(*values.data())};
}

/// .npy: magic, version 1.0, a Python dictionary padded to 64 bytes.
std::string npy_head(std::string_view type, std::string_view shape) {
  std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type, shape);
  text.append(63 - (10 + text.size()) % 64, ' ');
  text += '\n';
  std::string head = "\x93NUMPY\x01";
  head += '\0';
  put(head, uint16_t(text.size()));
  return head + text;
}

std::string shape_of(size_t n) { return fmt::format("({},)", n); }
std::string shape_of(size_t n, size_t m) { return fmt::format("({}, {})", n, m); }

/// UTF-8 -> code points; what is no UTF-8 becomes U+FFFD.
std::vector<uint32_t> code_points(std::string_view text) {
  std::vector<uint32_t> points;
  for (size_t i = 0; i < text.size();) {
    const auto lead = uint8_t(text[i]);
    const size_t length = lead < 0x80 ? 1 : lead >> 5 == 6 ? 2 : lead >> 4 == 14 ? 3 : lead >> 3 == 30 ? 4 : 0;
    uint32_t point = length == 1 ? lead : length == 0 ? 0xfffd : lead & (0xffU >> (length + 1));
    for (size_t k = 1; k < length; ++k)
      point = i + k < text.size() ? point << 6 | (uint8_t(text[i + k]) & 0x3f) : 0xfffd;
    points.push_back(point > 0x10ffff ? 0xfffd : point);
    i += std::max<size_t>(length, 1);
  }
  return points;
}

class NpzWriter {
 public:
  explicit NpzWriter(const Path& path) : out_(path, std::ios::binary) {}

  /// The parts follow one another in the array.
  void array(const std::string& name, std::string_view type, const std::string& shape,
             std::span<const std::string_view> parts) {
    const std::string file = name + ".npy", head = npy_head(type, shape);
    Crc32 crc;
    crc.add(head);
    uint64_t size = head.size();
    for (const std::string_view part : parts) crc.add(part), size += part.size();
    const Entry entry{file, crc.value(), size, offset_};
    write(local_head(entry));
    write(head);
    for (const std::string_view part : parts) write(part);
    entries_.push_back(entry);
  }
  template <class Values>
  void numbers(const std::string& name, std::string_view type, const Values& values, const std::string& shape) {
    const std::string_view part = bytes_of(values);
    array(name, type, shape, {&part, 1});
  }
  void texts(const std::string& name, const std::vector<std::string>& values, const std::string& shape) {
    std::vector<std::vector<uint32_t>> points;
    size_t longest = 1;
    for (const std::string& value : values) {
      points.push_back(code_points(value));
      longest = std::max(longest, points.back().size());
    }
    std::vector<uint32_t> table;
    for (std::vector<uint32_t>& value : points) {
      value.resize(longest, 0);
      table.insert(table.end(), value.begin(), value.end());
    }
    numbers(name, fmt::format("<U{}", longest), table, shape);
  }

  void finish() {
    const uint64_t begin = offset_;
    for (const Entry& entry : entries_) write(central_head(entry));
    const uint64_t size = offset_ - begin, end = offset_;
    std::string tail;
    put(tail, uint32_t(0x06064b50)), put(tail, uint64_t(44)), put(tail, uint16_t(45)), put(tail, uint16_t(45));
    put(tail, uint32_t(0)), put(tail, uint32_t(0));
    put(tail, uint64_t(entries_.size())), put(tail, uint64_t(entries_.size())), put(tail, size), put(tail, begin);
    put(tail, uint32_t(0x07064b50)), put(tail, uint32_t(0)), put(tail, end), put(tail, uint32_t(1));
    put(tail, uint32_t(0x06054b50)), put(tail, uint16_t(0)), put(tail, uint16_t(0));
    put(tail, uint16_t(entries_.size())), put(tail, uint16_t(entries_.size()));
    put(tail, uint32_t(0xffffffff)), put(tail, uint32_t(0xffffffff)), put(tail, uint16_t(0));
    write(tail);
    out_.close();
    if (!out_) throw Error(Code::io, "", "the archive cannot be written", "is the disk full?");
  }

 private:
  struct Entry {
    std::string name;
    uint32_t crc;
    uint64_t size, offset;
  };

  void write(std::string_view bytes) {
    out_.write(bytes.data(), std::streamsize(bytes.size()));
    offset_ += bytes.size();
  }
  /// Version, flags, method (stored), time (1 January 1980: the same bytes every time), CRC and sizes in ZIP64.
  static void common(std::string& head, const Entry& entry) {
    put(head, uint16_t(45)), put(head, uint16_t(0)), put(head, uint16_t(0)), put(head, uint16_t(0));
    put(head, uint16_t(0x21)), put(head, entry.crc), put(head, uint32_t(0xffffffff)), put(head, uint32_t(0xffffffff));
    put(head, uint16_t(entry.name.size()));
  }
  static std::string local_head(const Entry& entry) {
    std::string head;
    put(head, uint32_t(0x04034b50));
    common(head, entry);
    put(head, uint16_t(20));
    head += entry.name;
    put(head, uint16_t(1)), put(head, uint16_t(16)), put(head, entry.size), put(head, entry.size);
    return head;
  }
  static std::string central_head(const Entry& entry) {
    std::string head;
    put(head, uint32_t(0x02014b50)), put(head, uint16_t(45));
    common(head, entry);
    put(head, uint16_t(28)), put(head, uint16_t(0)), put(head, uint16_t(0)), put(head, uint16_t(0));
    put(head, uint32_t(0)), put(head, uint32_t(0xffffffff));
    head += entry.name;
    put(head, uint16_t(1)), put(head, uint16_t(24)), put(head, entry.size), put(head, entry.size);
    put(head, entry.offset);
    return head;
  }

  std::ofstream out_;
  uint64_t offset_ = 0;
  std::vector<Entry> entries_;
};

void add_dense(NpzWriter& npz, const ViewFactors& f) {
  const size_t n = f.size();
  std::vector<double> all;
  std::vector<float> errors(n * n, 0);
  all.reserve(n * n);
  for (size_t i = 0; i < n; ++i) {
    const std::vector<double> row = dense_row(f, i);
    all.insert(all.end(), row.begin(), row.end());
    for (uint64_t k = f.starts[i]; k < f.starts[i + 1]; ++k) errors[i * n + f.columns[k]] = f.errors[k];
  }
  npz.numbers("F", "<f8", all, shape_of(n, n));
  npz.numbers("errors", "<f4", errors, shape_of(n, n));
}

void add_sparse(NpzWriter& npz, const ViewFactors& f) {
  const std::string_view format = "csr";
  npz.array("format", "|S3", "()", {&format, 1});
  npz.numbers("shape", "<i8", std::vector<int64_t>{int64_t(f.size()), int64_t(f.size())}, shape_of(2));
  npz.numbers("indptr", "<i8", f.starts, shape_of(f.starts.size()));
  npz.numbers("indices", "<i4", f.columns, shape_of(f.columns.size()));
  npz.numbers("data", "<f8", f.factors, shape_of(f.factors.size()));
  npz.numbers("errors", "<f4", f.errors, shape_of(f.errors.size()));
}

void add_gray(NpzWriter& npz, const ViewFactorFile& file) {
  const size_t n = file.factors.size();
  if (file.exchange) {
    npz.numbers("script_F", "<f8", file.exchange->script_f, shape_of(n, n));
    npz.numbers("gebhart", "<f8", file.exchange->gebhart, shape_of(n, n));
  }
  if (file.bodies) {
    std::vector<double> emissivities;
    for (const GrayBody& body : *file.bodies) emissivities.push_back(body.emissivity);
    npz.numbers("emissivities", "<f8", emissivities, shape_of(n));
  }
  if (file.balance) {
    npz.numbers("temperatures", "<f8", file.balance->temperatures, shape_of(n));
    npz.numbers("radiosities", "<f8", file.balance->radiosities, shape_of(n));
    npz.numbers("fluxes", "<f8", file.balance->fluxes, shape_of(n));
  }
}

}  // namespace

void write_npz(const Path& path, const ViewFactorFile& file) {
  const ViewFactors& f = file.factors;
  write_through(path, [&](const Path& temporary) {
    NpzWriter npz(temporary);
    f.size() <= kMostDense ? add_dense(npz, f) : add_sparse(npz, f);
    npz.numbers("areas", "<f8", f.areas, shape_of(f.size()));
    if (!f.transmittances.empty()) npz.numbers("transmittances", "<f8", f.transmittances, shape_of(f.size()));
    npz.texts("names", f.names, shape_of(f.size()));
    if (!f.complete.empty()) npz.numbers("complete", "|u1", f.complete, shape_of(f.size()));
    add_gray(npz, file);
    npz.texts("certificate", {file.certificate}, "()");
    for (const auto& [name, value] : file.metadata) npz.texts(name, {value}, "()");
    npz.finish();
  });
}

}  // namespace aktina
