// How much memory a piece of work takes at most.
#pragma once

namespace aktina {

/// Counts from its construction. Where the system cannot tell (other than Linux) the answer is NaN.
class PeakMemory {
 public:
  PeakMemory();
  /// Largest resident memory since then above what there was then, bytes.
  double bytes() const;

 private:
  double before_;
};

}  // namespace aktina
