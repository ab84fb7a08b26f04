// Every image reader: which one is chosen by the first bytes, as in a file.
#include "aktina/image/file_format.h"
#include "fuzz.h"

void fuzz(std::span<const uint8_t> bytes) {
  using namespace aktina;
  fuzz::attempt([&] { read_image_header(bytes, "fuzz"); });
  fuzz::attempt([&] { decode_layered_image(bytes, "fuzz"); });
  fuzz::attempt([&] { decode_texture(bytes, "fuzz"); });
}
