// Exchange areas A_i F_ij between all surfaces of a scene, each pair once.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "aktina/base/progress.h"
#include "aktina/radiosity/viewfactor/exchange_store.h"
#include "aktina/radiosity/viewfactor/leaves.h"

namespace aktina {

/// Between the fragments of two leaves, the first of lower number.
struct LeafExchange {
  uint32_t a, b;  // leaves
  std::span<const Exchange> pairs;
};

struct Exchanges {
  std::unique_ptr<ExchangeStore> store;          // holds the pairs
  std::vector<std::vector<LeafExchange>> lists;  // of each leaf
  size_t complete = 0;                           // of them, the first ones that are: less than all where it was stopped
  double largest_excess = 0;                     // of a factor above its unobstructed value, before it was held to that
  uint64_t held = 0;                             // pairs
};

class ExchangeFinder {
 public:
  /// @param target_error  of F_ij and of F_ji
  ExchangeFinder(const Faces& faces, double target_error);
  ~ExchangeFinder();
  const Leaves& leaves() const;

  /// Pairs of fragments that may see something of each other, and of those the ones with something in between; from a
  /// sample of the leaves.
  struct Forecast {
    double pairs = 0, obstructed = 0;
  };
  Forecast forecast() const;

  /// Between every two leaves, once. Stopped: what is known of the first leaves.
  /// @param folder  where exchanges are kept, see LargeBlock
  Exchanges find(const std::filesystem::path& folder, Progress* progress) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace aktina
