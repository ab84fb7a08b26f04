// Solutions in files: the bytes are what follows the header, under a checksum that fits, so that lists and indices are
// reached.
#include <cstring>

#include "aktina/base/hash.h"
#include "aktina/radiosity/solution.h"
#include "fuzz.h"

void fuzz(std::span<const uint8_t> bytes) {
  using namespace aktina;
  fuzz::attempt([&] { decode_solution(bytes, "fuzz"); });
  std::vector<uint8_t> file(16);
  file.insert(file.end(), bytes.begin(), bytes.end());
  std::memcpy(file.data(), "AKTINAS1", 8);
  Hash64 hash;
  hash.add(std::as_bytes(bytes));
  const uint64_t sum = hash.value();
  std::memcpy(file.data() + 8, &sum, 8);
  fuzz::attempt([&] { decode_solution(file, "fuzz"); });
}
