// Rows of four numbers that lie anywhere, to columns of many lanes and back: what gathers and scatters would do, in a
// fraction of their time.
// Included by *_simd.cpp files after "aktina/base/simd.h", once for each instruction set.

#if defined(AKTINA_RASTER_ROWS_SIMD_H_) == defined(HWY_TARGET_TOGGLE)  // per-target include guard
#ifdef AKTINA_RASTER_ROWS_SIMD_H_
#undef AKTINA_RASTER_ROWS_SIMD_H_
#else
#define AKTINA_RASTER_ROWS_SIMD_H_
#endif

#include "aktina/base/simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

/// A vector of the rows first, first + 4, first + 8 ..., each of four numbers.
template <class D, class Row>
HWY_INLINE hn::Vec<D> join_rows(D tag, size_t first, const Row& row) {
  if constexpr (hn::MaxLanes(D()) == 4) {
    return hn::Load(tag, row(first));
  } else {
    const hn::Half<D> half;
    return hn::Combine(tag, join_rows(half, first + hn::MaxLanes(half), row), join_rows(half, first, row));
  }
}

/// The reverse.
template <class D, class Row>
HWY_INLINE void part_rows(D tag, hn::Vec<D> v, size_t first, const Row& row) {
  if constexpr (hn::MaxLanes(D()) == 4) {
    hn::Store(v, tag, row(first));
  } else {
    const hn::Half<D> half;
    part_rows(half, hn::LowerHalf(half, v), first, row);
    part_rows(half, hn::UpperHalf(half, v), first + hn::MaxLanes(half), row);
  }
}

/// In each four lanes, four vectors as the rows of a matrix become its columns.
HWY_INLINE void transpose_fours(F (&v)[4]) {
  const auto wide = [](F x) HWY_ATTR { return hn::BitCast(hn::Repartition<double, FloatTag>(), x); };
  const auto narrow = [](auto x) HWY_ATTR { return hn::BitCast(kFloat, x); };
  const hn::Repartition<double, FloatTag> pairs;
  const auto low01 = wide(hn::InterleaveLower(kFloat, v[0], v[1])),
             low23 = wide(hn::InterleaveLower(kFloat, v[2], v[3]));
  const auto up01 = wide(hn::InterleaveUpper(kFloat, v[0], v[1])), up23 = wide(hn::InterleaveUpper(kFloat, v[2], v[3]));
  v[0] = narrow(hn::InterleaveLower(pairs, low01, low23)), v[1] = narrow(hn::InterleaveUpper(pairs, low01, low23));
  v[2] = narrow(hn::InterleaveLower(pairs, up01, up23)), v[3] = narrow(hn::InterleaveUpper(pairs, up01, up23));
}

#endif

/// Lane i of column k: number k of row(i), which is aligned to 16 bytes.
template <class Row>
HWY_INLINE void load_rows(const Row& row, F (&columns)[4]) {
#if HWY_TARGET == HWY_SCALAR
  for (size_t k = 0; k < 4; ++k) columns[k] = set(row(0)[k]);
#else
  for (size_t q = 0; q < 4; ++q) columns[q] = join_rows(kFloat, q, row);
  transpose_fours(columns);
#endif
}

template <class Row>
HWY_INLINE void store_rows(F c0, F c1, F c2, F c3, const Row& row) {
  F v[4] = {c0, c1, c2, c3};
#if HWY_TARGET == HWY_SCALAR
  for (size_t k = 0; k < 4; ++k) store(v[k], row(0) + k);
#else
  transpose_fours(v);
  for (size_t q = 0; q < 4; ++q) part_rows(kFloat, v[q], q, row);
#endif
}

}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
