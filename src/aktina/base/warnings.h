// What was repaired, dropped or guessed while reading or computing: never hidden, never printed by the library.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace aktina {

/// A counted list: the same text again only raises its count.
class Warnings {
 public:
  struct Item {
    std::string text;
    uint64_t count;
  };

  void add(std::string_view text, uint64_t count = 1);
  void add(const Warnings& other);
  const std::vector<Item>& items() const { return items_; }
  bool empty() const { return items_.empty(); }

 private:
  std::vector<Item> items_;
};

}  // namespace aktina
