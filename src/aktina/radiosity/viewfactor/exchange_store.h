// Where exchanges are kept until the matrix is made: in memory, or in files of a folder.
#pragma once

#include <filesystem>
#include <mutex>
#include <span>
#include <vector>

#include "aktina/radiosity/viewfactor/large_array.h"

namespace aktina {

/// Between two fragments.
struct Exchange {
  uint8_t of_a, of_b;  // places in their leaves
  float error;         // estimate, m^2
  double area;         // A_i F_ij, m^2; above 0
};

class ExchangeStore {
 public:
  /// @param folder  see LargeBlock
  explicit ExchangeStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// One for each thread. The store must outlive it.
  class Writer {
   public:
    explicit Writer(ExchangeStore& store) : store_(store) {}
    ~Writer() { store_.give_back(free_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    /// A copy that stays where it is as long as the store. @throws Error limit, io (no room)
    std::span<const Exchange> keep(std::span<const Exchange> pairs);

   private:
    ExchangeStore& store_;
    std::span<Exchange> free_;
  };

 private:
  std::span<Exchange> chunk(size_t least);
  void give_back(std::span<Exchange> rest);

  std::filesystem::path folder_;
  std::mutex mutex_;
  std::vector<LargeBlock> chunks_;
  std::vector<std::span<Exchange>> rests_;
};

}  // namespace aktina
