// Rows of a view-factor matrix from the exchange areas of the surfaces' fragments.
#pragma once

#include "aktina/radiosity/viewfactor/exchange.h"
#include "aktina/radiosity/viewfactor/view_factors.h"

namespace aktina {

/// Which fragments make up which surface.
class Ownership {
 public:
  Ownership(const ViewFactorScene& scene, const Faces& faces, const Leaves& leaves);
  size_t surfaces() const { return areas_.size(); }
  const std::vector<double>& areas() const { return areas_; }
  /// Whether each surface is one fragment.
  bool is_one_each() const { return owners_.size() == areas_.size(); }
  /// Fragments in a leaf.
  uint32_t count(uint32_t leaf) const { return leaves_.leaves[leaf].count; }
  /// Of the fragment in a lane of a leaf.
  uint32_t owner(uint32_t leaf, uint32_t lane) const { return owners_[leaves_.leaves[leaf].first + lane]; }
  /// By surface: 1 where all its fragments are in the first `leaves`.
  std::vector<uint8_t> within(size_t leaves) const;
  /// Leaves with fragments of any of the surfaces, ascending.
  std::vector<uint32_t> leaves_of(std::span<const uint32_t> surfaces) const;
  /// The surfaces in the order of their first leaves: those that share leaves are near each other.
  const std::vector<uint32_t>& order() const { return order_; }

 private:
  const Leaves& leaves_;
  std::vector<double> areas_;
  std::vector<uint32_t> owners_, order_;
  std::vector<std::vector<uint32_t>> of_surface_;  // leaves
};

/// How many factors above 0 each row has.
std::vector<uint64_t> count_rows(const Ownership& ownership, const Exchanges& exchanges);
/// The rows, where `starts` says that they begin.
void fill_rows(const Ownership& ownership, const Exchanges& exchanges, ViewFactors& result);

}  // namespace aktina
