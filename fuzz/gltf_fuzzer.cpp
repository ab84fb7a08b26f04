// glTF, as text or binary; references to other files lead nowhere.
#include "aktina/import/import.h"
#include "fuzz.h"

void fuzz(std::span<const uint8_t> bytes) {
  using namespace aktina;
  ImportOptions options;
  options.most_bytes = uint64_t(256) << 20;
  fuzz::attempt([&] { read_gltf(bytes, "/nowhere", "fuzz", options); });
}
