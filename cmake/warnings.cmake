# One set of flags for everything we write. -ffp-contract=off: the same bytes whatever the inlining;
# SIMD code asks for fused multiply-add where it wants it. -Wno-restrict: g++ 12 warns wrongly of "x" + std::string
# (GCC bug 105651).
add_library(aktina_flags INTERFACE)
target_compile_options(aktina_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow=local -Wnon-virtual-dtor -Wno-restrict -ffp-contract=off -fno-math-errno)
