// Polygon files: the first byte chooses the reader, as real files begin. Nothing on disk is reached: the folder does
// not exist.
#include "aktina/import/import.h"
#include "aktina/import/obj/obj.h"
#include "fuzz.h"

namespace {

void read_materials(std::span<const uint8_t> bytes) {
  using namespace aktina;
  Scene scene;
  Beside beside("/nonexistent", {});
  std::map<std::string, int> index;
  obj::read_mtl({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, "fuzz", beside, scene, index);
}

void read(std::span<const uint8_t> bytes) {
  using namespace aktina;
  ImportOptions options;
  options.most_bytes = uint64_t(512) << 20;
  switch (bytes[0]) {
    case 'p':
      read_ply(bytes, "fuzz", options);
      return;
    case 's':
      read_stl(bytes, "fuzz", options);
      return;
    case 'O':
      read_off(bytes, "fuzz", options);
      return;
    case 'n':  // newmtl
      read_materials(bytes);
      return;
    default:
      read_obj(bytes, "/nonexistent", "fuzz", options);
  }
}

}  // namespace

void fuzz(std::span<const uint8_t> bytes) {
  if (!bytes.empty()) aktina::fuzz::attempt([&] { read(bytes); });
}
