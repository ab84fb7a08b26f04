// FBX as bytes: records of an end, a count and a length of properties, a name; properties; records within.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace aktina::test {

struct FbxRecord {
  std::string name;
  std::vector<std::string> properties;  // as bytes
  std::vector<FbxRecord> within;
};

template <class T>
std::string raw(const T& value) {
  std::string bytes(sizeof value, ' ');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}
inline std::string fbx(const std::string& text) { return 'S' + raw(uint32_t(text.size())) + text; }
inline std::string fbx(int32_t value) { return 'I' + raw(value); }
inline std::string fbx(int64_t value) { return 'L' + raw(value); }
inline std::string fbx(double value) { return 'D' + raw(value); }
template <class T>
std::string fbx_array(char type, const std::vector<T>& values) {
  std::string bytes = type + raw(uint32_t(values.size())) + raw(uint32_t(0)) + raw(uint32_t(values.size() * sizeof(T)));
  for (const T& value : values) bytes += raw(value);
  return bytes;
}

inline void append_record(std::string& file, const FbxRecord& record) {
  constexpr size_t kHead = 13;  // bytes; a head of zeros ends a list of records
  const size_t start = file.size();
  std::string properties;
  for (const std::string& property : record.properties) properties += property;
  file += std::string(kHead, '\0') + record.name + properties;
  for (const FbxRecord& inner : record.within) append_record(file, inner);
  if (!record.within.empty()) file += std::string(kHead, '\0');
  const std::string head = raw(uint32_t(file.size())) + raw(uint32_t(record.properties.size())) +
                           raw(uint32_t(properties.size())) + raw(uint8_t(record.name.size()));
  file.replace(start, kHead, head);
}

/// A triangle of 1 x 2 units, two of which are a metre.
inline std::string binary_fbx_file() {
  const std::string geometry = std::string("Plate\0\1Geometry", 15), model = std::string("A\0\1Model", 8);
  const FbxRecord unit = {"P", {fbx("UnitScaleFactor"), fbx("double"), fbx("Number"), fbx(""), fbx(50.0)}, {}};
  const FbxRecord mesh = {"Geometry",
                          {fbx(int64_t(10)), fbx(geometry), fbx("Mesh")},
                          {{"Vertices", {fbx_array<double>('d', {0, 0, 0, 1, 0, 0, 0, 2, 0})}, {}},
                           {"PolygonVertexIndex", {fbx_array<int32_t>('i', {0, 1, -3})}, {}}}};
  const FbxRecord node = {"Model", {fbx(int64_t(20)), fbx(model), fbx("Mesh")}, {{"Version", {fbx(232)}, {}}}};
  std::string file = std::string("Kaydara FBX Binary  \0\x1a\0", 23) + raw(uint32_t(7400));
  append_record(file, {"FBXHeaderExtension", {}, {{"FBXVersion", {fbx(7400)}, {}}}});
  append_record(file, {"GlobalSettings", {}, {{"Version", {fbx(1000)}, {}}, {"Properties70", {}, {unit}}}});
  append_record(file, {"Objects", {}, {mesh, node}});
  append_record(file, {"Connections",
                       {},
                       {{"C", {fbx("OO"), fbx(int64_t(20)), fbx(int64_t(0))}, {}},
                        {"C", {fbx("OO"), fbx(int64_t(10)), fbx(int64_t(20))}, {}}}});
  return file + std::string(13, '\0');
}

}  // namespace aktina::test
