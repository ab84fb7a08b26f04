// Photometric files: IES by its words, EULUMDAT for the rest, as load_luminaire() chooses.
#include "aktina/import/luminaire/luminaire.h"
#include "fuzz.h"

void fuzz(std::span<const uint8_t> bytes) {
  using namespace aktina;
  fuzz::attempt([&] { read_ies(bytes, "/nowhere", "fuzz"); });
  fuzz::attempt([&] { read_eulumdat(bytes, "fuzz"); });
}
