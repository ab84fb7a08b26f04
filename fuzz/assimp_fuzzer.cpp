// FBX, COLLADA and 3DS, as their files begin; anything else is taken for what the reading process sends, which is not
// trusted. Assimp's own faults happen in that process, and are right answers; what they do here is not.
#include <algorithm>
#include <string_view>

#include "aktina/import/assimp/document.h"
#include "aktina/import/import.h"
#include "fuzz.h"

namespace {

using namespace aktina;

void read_as_sent(std::span<const uint8_t> bytes) {
  const assimp::Source source = [&](std::span<uint8_t> out) {
    if (out.size() > bytes.size()) throw Error(Code::io, "", "cut off");
    std::copy_n(bytes.begin(), out.size(), out.begin());
    bytes = bytes.subspan(out.size());
  };
  assimp::read(source, uint64_t(64) << 20, "fuzz");
}

void read(std::span<const uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  ImportOptions options;
  options.most_bytes = uint64_t(256) << 20;
  if (text.starts_with(";") || text.starts_with("Kaydara"))
    read_fbx(bytes, "/nowhere", "fuzz", options);
  else if (text.starts_with("<"))
    read_collada(bytes, "/nowhere", "fuzz", options);
  else if (text.starts_with("MM"))
    read_3ds(bytes, "/nowhere", "fuzz", options);
  else
    read_as_sent(bytes);
}

}  // namespace

void fuzz(std::span<const uint8_t> bytes) {
  aktina::fuzz::attempt([&] { read(bytes); });
}
