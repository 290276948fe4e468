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

/// The hash of what `hash` stands for and a vector of identifiers of 32 bits, two to a word. What the length tells is
/// left out: such keys have one length.
template <class Ids>
[[nodiscard]] constexpr std::uint64_t mix_ids(std::uint64_t hash, const Ids& ids) noexcept {
  std::size_t i = 0;
  for (; i + 1 < ids.size(); i += 2) hash = mix(hash, std::uint64_t{ids[i].value} << 32 | ids[i + 1].value);
  return i < ids.size() ? mix(hash, ids[i].value) : hash;
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
