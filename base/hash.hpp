// Hashing, for tables in memory only: nothing that reaches output is in the order of a hash.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rmpl::base {

inline constexpr std::uint64_t hash_seed = 0x9e3779b97f4a7c15u;  // 2^64 over the golden ratio, odd

/// The hash of what `hash` stands for and one word more (the multiplier is that of splitmix64).
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t hash, std::uint64_t word) noexcept {
  hash = (hash ^ word) * 0xbf58476d1ce4e5b9u;
  return hash ^ (hash >> 29);
}

/// Hash of a few words, such as a key of a cache.
struct WordsHash {
  std::size_t operator()(const std::vector<std::uint64_t>& words) const noexcept {
    std::uint64_t hash = hash_seed;
    for (const std::uint64_t word : words) hash = mix(hash, word);
    return hash;
  }
};

}  // namespace rmpl::base
