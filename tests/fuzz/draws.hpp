// Decisions drawn from the bytes of an input: for the fuzz targets that call an interface as they like.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace rmpl::fuzz {

/// Zeros where the bytes are used up.
class Draws {
 public:
  Draws(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  std::size_t below(std::size_t bound) { return (at_ < size_ ? data_[at_++] : 0U) % bound; }
  [[nodiscard]] bool empty() const { return at_ >= size_; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

}  // namespace rmpl::fuzz
