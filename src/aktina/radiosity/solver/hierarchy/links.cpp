#include "aktina/radiosity/solver/hierarchy/links.h"

#include <algorithm>
#include <numeric>

namespace aktina {

void Links::replace(const Unsorted& all, size_t nodes) {
  first_.assign(nodes + 1, 0);
  for (const uint32_t receiver : all.receivers) ++first_[receiver + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<size_t> cursor(first_.begin(), first_.end() - 1);
  links_.resize(all.links.size()), coefficients_.resize(all.coefficients.size());
  for (size_t k = 0; k < all.links.size(); ++k) {
    const size_t at = cursor[all.receivers[k]]++;
    links_[at] = all.links[k];
    std::copy_n(all.coefficients.begin() + std::ptrdiff_t(k * per_link_), per_link_,
                coefficients_.begin() + std::ptrdiff_t(at * per_link_));
  }
}

}  // namespace aktina
