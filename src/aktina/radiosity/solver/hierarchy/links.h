// Links: which node receives light from which, sorted by receiver.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace aktina {

struct Link {
  uint32_t sender;
  float factor;   // mean form factor from the receiver to the sender, as if nothing were in between
  float spread;   // its error
  float visible;  // share of rays that pass; below 0: nobody has looked yet, for there was no light to send
};
static_assert(sizeof(Link) == 16);

/// Nodes that are to be linked.
struct NodePair {
  uint32_t receiver, sender;
};

class Links {
 public:
  static constexpr double kMostBytes = 1U << 31;  // of unsorted links; as much again while they are sorted
  static double bytes(double links, size_t coefficients) {
    return links * double(sizeof(Link) + sizeof(uint32_t) + coefficients * sizeof(float));
  }

  /// @param coefficients  of a link beside its factor; 0 where the factor is all
  explicit Links(size_t coefficients) : per_link_(coefficients) {}

  size_t size() const { return links_.size(); }
  size_t nodes() const { return first_.size() - 1; }
  std::span<const Link> of(uint32_t receiver) const {
    return {links_.data() + first_[receiver], first_[receiver + 1] - first_[receiver]};
  }
  /// Of the k-th of them.
  const float* coefficients(uint32_t receiver, size_t k) const {
    return coefficients_.data() + (first_[receiver] + k) * per_link_;
  }

  /// Links in any order, with their receivers.
  struct Unsorted {
    std::vector<uint32_t> receivers;
    std::vector<Link> links;
    std::vector<float> coefficients;
    void add(uint32_t receiver, const Link& link, std::span<const float> own) {
      receivers.push_back(receiver), links.push_back(link);
      coefficients.insert(coefficients.end(), own.begin(), own.end());
    }
  };
  size_t per_link() const { return per_link_; }
  void replace(const Unsorted& all, size_t nodes);

 private:
  size_t per_link_;
  std::vector<Link> links_;
  std::vector<float> coefficients_;
  std::vector<size_t> first_{0};  // by node
};

}  // namespace aktina
