// Solutions in one binary file: "AKTINAS1", a checksum of the rest, lists with their lengths; little endian.
#include <bit>
#include <cstring>
#include <type_traits>

#include "aktina/base/error.h"
#include "aktina/base/hash.h"
#include "aktina/radiosity/solution.h"

namespace aktina {
namespace {

static_assert(std::endian::native == std::endian::little, "lists are written as they stand in memory");

constexpr char kMagic[9] = "AKTINAS1";  // the last character is the version
constexpr size_t kHeader = 16;          // magic, checksum

uint64_t checksum(std::span<const uint8_t> bytes) {
  Hash64 hash;
  hash.add(std::as_bytes(bytes));
  return hash.value();
}

/// All fields in the order of the file: the one list that writing and reading share.
template <class S, class Visitor>
void visit(S& s, Visitor& v) {
  auto& m = s.mesh;
  v(m.positions), v(m.normals), v(m.places);
  v(m.patches), v(m.centres), v(m.areas), v(m.patch_normals), v(m.reflectances), v(m.transmittances), v(m.emissions);
  v(m.two_sided), v(m.shooters);
  v(s.irradiances), v(s.radiosities), v(s.back_irradiances), v(s.direct_irradiances), v(s.back_direct_irradiances);
  v(s.vertex_irradiances), v(s.vertex_radiosities), v(s.vertex_back_irradiances), v(s.vertex_direct_irradiances);
  v(s.vertex_back_direct_irradiances);
  v(s.settings), v(s.scene_hash), v(s.seed), v(s.steps), v(s.unshot), v(s.emitted), v(s.absorbed), v(s.escaped);
  v(s.converged);
}

class Writer {
 public:
  std::vector<uint8_t> bytes = std::vector<uint8_t>(kHeader);

  template <class T>
  void operator()(const std::vector<T>& list) {
    number(list.size());
    append(list.data(), list.size() * sizeof(T));
  }
  void operator()(const std::string& text) {
    number(text.size());
    append(text.data(), text.size());
  }
  void operator()(uint64_t value) { number(value); }
  void operator()(double value) { append(&value, sizeof value); }
  void operator()(bool value) { number(value); }
  void number(uint64_t value) { append(&value, sizeof value); }

 private:
  void append(const void* data, size_t size) {
    const auto* first = static_cast<const uint8_t*>(data);
    bytes.insert(bytes.end(), first, first + size);
  }
};

class Reader {
 public:
  Reader(std::span<const uint8_t> bytes, const std::string& where) : rest_(bytes.subspan(kHeader)), where_(where) {}

  template <class T>
  void operator()(std::vector<T>& list) {
    static_assert(std::is_trivially_copyable_v<T>);
    list.resize(count(sizeof(T)));
    take(list.data(), list.size() * sizeof(T));
  }
  void operator()(std::string& text) {
    text.resize(count(1));
    take(text.data(), text.size());
  }
  void operator()(uint64_t& value) { take(&value, sizeof value); }
  void operator()(double& value) { take(&value, sizeof value); }
  void operator()(bool& value) { value = number() != 0; }
  uint64_t number() {
    uint64_t value = 0;
    take(&value, sizeof value);
    return value;
  }
  void expect_end() const {
    if (!rest_.empty()) fail("bytes are left over");
  }
  [[noreturn]] void fail(const char* what) const {
    throw Error(Code::bad_input, where_, what, "solve again, or take another copy of the file");
  }

 private:
  /// A length, no longer than what is left of the file: no claim takes memory that the file does not fill.
  size_t count(size_t size) {
    const uint64_t n = number();
    if (n > rest_.size() / size) fail("a list is longer than the file");
    return size_t(n);
  }
  void take(void* to, size_t size) {
    if (size > rest_.size()) fail("the file ends early");
    if (size > 0) std::memcpy(to, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }

  std::span<const uint8_t> rest_;
  const std::string& where_;
};

/// Whatever wrote the file: lists that belong together have one length, and indices point into them.
void check(const Solution& s, const Reader& reader) {
  const PatchMesh& m = s.mesh;
  const size_t vertices = m.positions.size(), patches = m.patches.size();
  for (const size_t n :
       {m.normals.size(), m.places.size(), s.vertex_irradiances.size(), s.vertex_radiosities.size(),
        s.vertex_back_irradiances.size(), s.vertex_direct_irradiances.size(), s.vertex_back_direct_irradiances.size()})
    if (n != vertices) reader.fail("lists of vertices differ in length");
  for (const size_t n :
       {m.centres.size(), m.areas.size(), m.patch_normals.size(), m.reflectances.size(), m.transmittances.size(),
        m.emissions.size(), m.two_sided.size(), s.irradiances.size(), s.radiosities.size(), s.back_irradiances.size(),
        s.direct_irradiances.size(), s.back_direct_irradiances.size()})
    if (n != patches) reader.fail("lists of patches differ in length");
  for (const auto& patch : m.patches)
    for (const uint32_t v : patch)
      if (v >= vertices) reader.fail("a patch names a vertex that is not there");
  uint64_t next = 0;
  for (const PatchMesh::Shooter& shooter : m.shooters) {
    if (shooter.first != next || shooter.count == 0) reader.fail("patches do not follow one another");
    next += shooter.count;
    for (const uint32_t v : shooter.corners)
      if (v >= vertices) reader.fail("a patch names a vertex that is not there");
  }
  if (next != patches) reader.fail("patches do not follow one another");
}

}  // namespace

void save_solution(const Path& path, const Solution& solution) {
  Writer writer;
  visit(solution, writer);
  writer.number(solution.warnings.items().size());
  for (const Warnings::Item& item : solution.warnings.items()) writer(item.text), writer.number(item.count);
  std::memcpy(writer.bytes.data(), kMagic, 8);
  const uint64_t sum = checksum(std::span(writer.bytes).subspan(kHeader));
  std::memcpy(writer.bytes.data() + 8, &sum, 8);
  write_file(path, writer.bytes);
}

Solution load_solution(const Path& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  return decode_solution(bytes, display(path));
}

Solution decode_solution(std::span<const uint8_t> bytes, const std::string& where) {
  if (bytes.size() < kHeader || std::memcmp(bytes.data(), kMagic, 7) != 0)
    throw Error(Code::bad_input, where, "is not a solution of Aktina");
  if (bytes[7] != uint8_t(kMagic[7]))
    throw Error(Code::bad_input, where, "is a solution of another version", "solve again");
  Reader reader(bytes, where);
  uint64_t sum = 0;
  std::memcpy(&sum, bytes.data() + 8, 8);
  if (sum != checksum(bytes.subspan(kHeader))) reader.fail("the checksum is wrong: the file is damaged");
  Solution solution;
  visit(solution, reader);
  for (uint64_t n = reader.number(); n > 0; --n) {
    std::string text;
    reader(text);
    solution.warnings.add(text, reader.number());
  }
  reader.expect_end();
  check(solution, reader);
  return solution;
}

}  // namespace aktina
