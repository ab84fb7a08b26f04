// Exchange areas A_i F_ij between all surfaces of a scene, each pair once.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "aktina/base/progress.h"
#include "aktina/radiosity/viewfactor/leaves.h"

namespace aktina {

/// Between two fragments.
struct Exchange {
  uint8_t of_a, of_b;  // places in their leaves
  float error;         // estimate, m^2
  double area;         // A_i F_ij, m^2; above 0
};

/// Between the fragments of two leaves, the first of lower number.
struct LeafExchange {
  uint32_t a, b;  // leaves
  uint32_t count;
  std::unique_ptr<Exchange[]> pairs;
  std::span<const Exchange> all() const { return {pairs.get(), count}; }
};

struct Exchanges {
  std::vector<std::vector<LeafExchange>> lists;  // of each leaf asked for
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

  /// Between the leaves asked for (ascending) and all leaves; what lies between two that are asked for comes once.
  /// Stopped: what is known of the first leaves.
  Exchanges find(std::span<const uint32_t> leaves, Progress* progress) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace aktina
