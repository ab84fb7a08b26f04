// Small files in the three formats, written by hand: the same plate of 100 x 50 inches twice under a parent (at 0 0
// 100, turned by 90 degrees about z), +z up.
#pragma once

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "test_files.h"

namespace aktina::test {

/// tests/import/assimp/files/NAME
inline std::string sample_file(const std::string& name) {
  std::ifstream file(repository() / "tests/import/assimp/files" / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
inline const std::string kFbx = sample_file("plate.fbx"), kCollada = sample_file("plate.dae");

/// Chunks of 3D Studio: a number, a length, a body.
class Chunks {
 public:
  static std::string chunk(uint16_t id, const std::string& body) {
    return number(id) + number(uint32_t(6 + body.size())) + body;
  }
  template <class T>
  static std::string number(T value) {
    std::string bytes(sizeof value, ' ');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
  }
  static std::string floats(std::initializer_list<float> values) {
    std::string bytes;
    for (const float v : values) bytes += number(v);
    return bytes;
  }
  static std::string words(std::initializer_list<int> values) {
    std::string bytes;
    for (const int v : values) bytes += number(uint16_t(v));
    return bytes;
  }
  static std::string name(const std::string& text) { return text + '\0'; }
  static std::string colour(float r, float g, float b) { return chunk(0x0010, floats({r, g, b})); }
  static std::string percent(int value) { return chunk(0x0030, words({value})); }
};

/// A red plate of 100 x 50 with a lamp, a spot and a camera, +z up.
inline std::string max3ds_file() {
  using C = Chunks;
  const std::string material =
      C::chunk(0xAFFF, C::chunk(0xA000, C::name("Red")) + C::chunk(0xA010, C::colour(.1f, .1f, .1f)) +
                           C::chunk(0xA020, C::colour(.8f, .1f, .1f)) + C::chunk(0xA030, C::colour(.4f, .4f, .4f)) +
                           C::chunk(0xA040, C::percent(25)) + C::chunk(0xA041, C::percent(50)) +
                           C::chunk(0xA050, C::percent(25)) + C::chunk(0xA100, C::words({3})));
  const std::string points = C::chunk(0x4110, C::words({4}) + C::floats({0, 0, 0, 100, 0, 0, 100, 50, 0, 0, 50, 0}));
  const std::string faces =
      C::chunk(0x4120, C::words({2, 0, 1, 2, 7, 0, 2, 3, 7}) + C::chunk(0x4130, C::name("Red") + C::words({2, 0, 1})));
  const std::string plate = C::chunk(0x4000, C::name("Plate") + C::chunk(0x4100, points + faces));
  const std::string lamp =
      C::chunk(0x4000, C::name("Lamp") + C::chunk(0x4600, C::floats({0, 0, 200}) + C::colour(1, .5f, .25f)));
  const std::string spot =
      C::chunk(0x4000, C::name("Spot") + C::chunk(0x4600, C::floats({0, 0, 200}) + C::colour(1, 1, 1) +
                                                              C::chunk(0x4610, C::floats({0, 0, 0, 20, 60}))));
  const std::string camera =
      C::chunk(0x4000, C::name("Eye") + C::chunk(0x4700, C::floats({0, -300, 0, 0, 0, 0, 0, 48})));
  const std::string edit =
      C::chunk(0x3D3D, C::chunk(0x3D3E, C::number(uint32_t(3))) + C::chunk(0x0100, C::floats({1})) + material + plate +
                           lamp + spot + camera);
  return C::chunk(0x4D4D, C::chunk(0x0002, C::number(uint32_t(3))) + edit);
}

}  // namespace aktina::test
