// View3D's input files.
#include "aktina/import/text.h"
#include "aktina/import/vs3/vs3.h"
#include "fuzz.h"

void fuzz(std::span<const uint8_t> bytes) {
  using namespace aktina;
  fuzz::attempt([&] { read_vs3(decode_text(bytes), "fuzz"); });
}
