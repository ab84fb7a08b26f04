// OpenEXR files in memory.
#pragma once

#include <IexBaseExc.h>
#include <ImfIO.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

namespace aktina {

class ExrInput final : public Imf::IStream {
 public:
  explicit ExrInput(std::span<const uint8_t> bytes) : IStream(""), bytes_(bytes) {}
  bool read(char out[], int count) override {
    if (count < 0 || position_ > bytes_.size() || size_t(count) > bytes_.size() - position_)
      throw Iex::InputExc("the file is truncated");
    std::memcpy(out, bytes_.data() + position_, size_t(count));
    position_ += size_t(count);
    return position_ < bytes_.size();
  }
  uint64_t tellg() override { return position_; }
  void seekg(uint64_t position) override { position_ = position; }

 private:
  std::span<const uint8_t> bytes_;
  uint64_t position_ = 0;
};

class ExrOutput final : public Imf::OStream {
 public:
  ExrOutput() : OStream("") {}
  void write(const char bytes[], int count) override {
    const uint64_t end = position_ + uint64_t(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + position_, bytes, size_t(count));
    position_ = end;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }
  std::vector<uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<uint8_t> bytes_;
  uint64_t position_ = 0;
};

}  // namespace aktina
