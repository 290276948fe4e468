// What has been proved about a part of the plant, by what that part depends on.
// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_map>
#include <utility>

#include "automata/step/support.hpp"

namespace automata {

/// Hash of a few words, such as a projection's key.
struct WordsHash {
  std::size_t operator()(const std::vector<std::uint64_t>& words) const noexcept {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const std::uint64_t word : words) {
      hash = (hash ^ word) * 0xbf58476d1ce4e5b9u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

/// Answers by projected modes and controls. Bounded: past the limit it is emptied, so that long runs through ever new
/// states stay flat. A reference lasts until the next `find` that asks.
template <class Answer>
class Memory {
 public:
  Memory(const Plant& plant, const Support& support) : projection_(plant, support) {}

  /// The remembered answer, or `ask()`, which is then remembered.
  template <class Ask>
  const Answer& find(const Modes& modes, const ControlAction& action, const Ask& ask) {
    projection_.read(modes, action, key_);
    return find(ask);
  }
  /// The same for an answer that depends on more: one word for each further thing.
  template <class Ask>
  const Answer& find(const Modes& modes, const std::vector<std::uint64_t>& more, const Ask& ask) {
    projection_.read(modes, {}, key_);
    key_.insert(key_.end(), more.begin(), more.end());
    return find(ask);
  }

 private:
  template <class Ask>
  const Answer& find(const Ask& ask) {
    if (const auto known = answers_.find(key_); known != answers_.end()) return known->second;
    if (answers_.size() >= limit) answers_.clear();
    return answers_.emplace(key_, ask()).first->second;
  }

  static constexpr std::size_t limit = 1u << 16;
  Projection projection_;
  Projection::Key key_;
  std::unordered_map<Projection::Key, Answer, WordsHash> answers_;  ///< looked up, never iterated
};

}  // namespace automata
