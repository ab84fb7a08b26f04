#include "aktina/radiosity/viewfactor/exchange_store.h"

#include <algorithm>

namespace aktina {
namespace {

constexpr size_t kChunk = size_t(1) << 19;  // exchanges: 8 MB

}  // namespace

std::span<Exchange> ExchangeStore::chunk(size_t least) {
  const std::lock_guard lock(mutex_);
  while (!rests_.empty()) {
    const std::span<Exchange> rest = rests_.back();
    rests_.pop_back();
    if (rest.size() >= least) return rest;
  }
  chunks_.emplace_back(kChunk * sizeof(Exchange), folder_);
  return {static_cast<Exchange*>(chunks_.back().data()), kChunk};
}

void ExchangeStore::give_back(std::span<Exchange> rest) {
  const std::lock_guard lock(mutex_);
  if (!rest.empty()) rests_.push_back(rest);
}

std::span<const Exchange> ExchangeStore::Writer::keep(std::span<const Exchange> pairs) {
  if (free_.size() < pairs.size()) free_ = store_.chunk(pairs.size());
  const std::span<Exchange> place = free_.first(pairs.size());
  std::copy(pairs.begin(), pairs.end(), place.begin());
  free_ = free_.subspan(pairs.size());
  return place;
}

}  // namespace aktina
