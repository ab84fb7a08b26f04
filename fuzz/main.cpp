// libFuzzer's entry.
#include "aktina/base/parallel.h"
#include "fuzz.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  aktina::set_thread_count(1);  // what fails must fail again
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  fuzz({data, size});
  return 0;
}
