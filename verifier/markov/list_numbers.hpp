// Numbers for lists of numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/hash.hpp"

namespace rmpl::verifier {

/// In the order in which they are met, from 0.
class ListNumbers {
 public:
  using List = std::vector<std::uint32_t>;
  std::uint32_t number(const List& list) {
    const auto [at, fresh] = numbers_.try_emplace(list, static_cast<std::uint32_t>(lists_.size()));
    if (fresh) lists_.push_back(&at->first);
    return at->second;
  }
  [[nodiscard]] const List& operator[](std::uint32_t number) const { return *lists_[number]; }
  [[nodiscard]] std::size_t size() const { return lists_.size(); }

 private:
  struct Hash {
    std::size_t operator()(const List& list) const noexcept {
      std::uint64_t hash = base::hash_seed;
      for (const std::uint32_t value : list) hash = base::mix(hash, value);
      return hash;
    }
  };
  std::unordered_map<List, std::uint32_t, Hash> numbers_;  ///< looked up, never iterated
  std::vector<const List*> lists_;
};

}  // namespace rmpl::verifier
