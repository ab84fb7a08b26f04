# One set of flags for everything we write. -ffp-contract=off: the same bytes whatever the inlining;
# SIMD code asks for fused multiply-add where it wants it.
add_library(aktina_flags INTERFACE)
target_compile_options(aktina_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow=local -Wnon-virtual-dtor -ffp-contract=off -fno-math-errno)
