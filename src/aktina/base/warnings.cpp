#include "aktina/base/warnings.h"

#include "aktina/base/error.h"

namespace aktina {

constexpr size_t kMostItems = 1000;

void Warnings::add(std::string_view text, uint64_t count) {
  if (count == 0) return;
  const std::string line = one_line(text);
  for (Item& item : items_)
    if (item.text == line) {
      item.count += count;
      return;
    }
  if (items_.size() < kMostItems)
    items_.push_back({line, count});
  else if (items_.size() == kMostItems)
    items_.push_back({"more warnings of other kinds, not listed", count});
  else
    items_.back().count += count;
}

void Warnings::add(const Warnings& other) {
  for (const Item& item : other.items_) add(item.text, item.count);
}

}  // namespace aktina
