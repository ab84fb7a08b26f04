#include "aktina/import/assimp/document.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "aktina/base/error.h"

namespace aktina::assimp {
namespace {

class Writer {
 public:
  explicit Writer(const Sink& sink) : sink_(sink) {}
  template <class... T>
  void operator()(T&... values) {
    (put(values), ...);
  }

 private:
  template <class T>
  void put(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
      raw(&value, sizeof value);
    else
      value.fields(*this);
  }
  void put(std::string& text) { put_size(text.size()), raw(text.data(), text.size()); }
  template <class T>
  void put(std::vector<T>& list) {
    put_size(list.size());
    if constexpr (std::is_trivially_copyable_v<T>)
      raw(list.data(), list.size() * sizeof(T));
    else
      for (T& value : list) put(value);
  }
  void put_size(uint64_t size) { raw(&size, sizeof size); }
  void raw(const void* data, size_t size) { sink_({static_cast<const uint8_t*>(data), size}); }

  const Sink& sink_;
};

/// Takes memory only for bytes that have come.
class Reader {
 public:
  Reader(const Source& source, uint64_t most_bytes, const std::string& where)
      : source_(source), left_(most_bytes), where_(where) {}
  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }

 private:
  static constexpr size_t kChunk = size_t(1) << 20;  // bytes

  template <class T>
  void get(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
      raw(&value, sizeof value);
    else
      value.fields(*this);
  }
  void get(std::string& text) { get_raw(text); }
  template <class T>
  void get(std::vector<T>& list) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      get_raw(list);
    } else {
      uint64_t count = 0;
      for (get(count); count > 0; --count) {
        charge(sizeof(T));
        get(list.emplace_back());
      }
    }
  }
  template <class List>
  void get_raw(List& list) {
    constexpr size_t kSize = sizeof(typename List::value_type);
    uint64_t count = 0;
    for (get(count); count > 0;) {
      const size_t before = list.size(), more = size_t(std::min<uint64_t>(count, kChunk / kSize));
      list.resize(before + more);
      raw(list.data() + before, more * kSize);
      count -= more;
    }
  }
  void raw(void* data, size_t size) {
    charge(size);
    source_({static_cast<uint8_t*>(data), size});
  }
  void charge(uint64_t size) {
    if (size > left_) throw Error(Code::limit, where_, "needs more memory than is allowed", "simplify the scene");
    left_ -= size;
  }

  const Source& source_;
  uint64_t left_;
  const std::string& where_;
};

class Check {
 public:
  explicit Check(const std::string& where) : where_(where) {}

  void run(const Document& d) const {
    holds(std::isfinite(d.metres_per_unit) && d.metres_per_unit > 0);
    for (size_t i = 0; i < d.nodes.size(); ++i) index(d.nodes[i].parent, i);
    for (const FileMesh& mesh : d.meshes) index(mesh.material, d.materials.size()), check(mesh);
    for (const FileMeshUse& use : d.uses)
      index(use.node, d.nodes.size()), index(use.mesh, d.meshes.size()), holds(use.node >= 0 && use.mesh >= 0);
    for (const FileLight& light : d.lights) index(light.node, d.nodes.size());
    for (const FileCamera& camera : d.cameras) index(camera.node, d.nodes.size());
  }

 private:
  void check(const FileMesh& m) const {
    const size_t count = m.positions.size();
    for (const size_t size : {m.normals.size(), m.uv[0].size(), m.uv[1].size(), m.colours.size()})
      holds(size == 0 || size == count);
    uint64_t corners = 0;
    for (const uint32_t size : m.sizes) corners += size, holds(size >= 3);
    holds(corners == m.corners.size());
    holds(std::all_of(m.corners.begin(), m.corners.end(), [&](uint32_t c) { return c < count; }));
  }
  void index(int32_t i, size_t size) const { holds(i >= -1 && (i < 0 || size_t(i) < size)); }
  void holds(bool condition) const {
    if (!condition) throw Error(Code::bad_input, where_, "its parts do not fit together", "the file is damaged");
  }

  const std::string& where_;
};

}  // namespace

void write(Document& document, const Sink& sink) {
  Writer writer(sink);
  writer(document);
}

Document read(const Source& source, uint64_t most_bytes, const std::string& where) {
  Document document;
  Reader reader(source, most_bytes, where);
  reader(document);
  Check(where).run(document);
  return document;
}

}  // namespace aktina::assimp
