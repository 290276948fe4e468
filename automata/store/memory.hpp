// What has been proved about a part of the plant, by what that part depends on.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <unordered_map>
#include <utility>

#include "automata/store/support.hpp"

namespace rmpl::automata {

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

/// A hash map that forgets: past its limit it begins anew, so that long runs through ever new states stay flat, and
/// lets go of the old entries two at a time, so that no single step pays for it.
template <class Key, class Value, class Hash>
class Forgetful {
 public:
  explicit Forgetful(std::size_t limit) : limit_(limit) {}

  /// The value of a key, or null. Lasts until the next `add` at least.
  [[nodiscard]] Value* find(const Key& key) {
    const auto known = map_.find(key);
    return known == map_.end() ? nullptr : &known->second;
  }
  /// The key is new. The reference lasts until the next `add`.
  Value& add(const Key& key, Value value) {
    if (map_.size() >= limit_) std::swap(map_, retired_);
    for (int i = 0; i < 2 && !retired_.empty(); ++i) retired_.erase(retired_.begin());
    return map_.emplace(key, std::move(value)).first->second;
  }

 private:
  std::size_t limit_;
  std::unordered_map<Key, Value, Hash> map_;      ///< looked up, never iterated
  std::unordered_map<Key, Value, Hash> retired_;  ///< empty before `map_` is full again
};

/// Answers by projected modes and controls. A reference lasts until the next `find` that asks.
template <class Answer>
class Memory {
 public:
  Memory(const Plant& plant, const Support& support) : projection_(plant, support) {
    if (projection_.bits() <= dense_bits) dense_.resize(std::size_t{1} << projection_.bits());
  }

  /// The remembered answer, or `ask()`, which is then remembered.
  template <class Ask>
  Answer& find(const Modes& modes, const ControlAction& action, const Ask& ask) {
    projection_.read(modes, action, key_);
    if (dense_.empty()) return find(ask);
    std::optional<Answer>& known = dense_[key_.empty() ? 0 : key_.front()];
    if (!known) known = ask();
    return *known;
  }
  /// The same for an answer that depends on more: one word for each further thing.
  template <class Ask>
  Answer& find(const Modes& modes, const std::vector<std::uint64_t>& more, const Ask& ask) {
    projection_.read(modes, {}, key_);
    key_.insert(key_.end(), more.begin(), more.end());
    return find(ask);
  }

 private:
  template <class Ask>
  Answer& find(const Ask& ask) {
    if (Answer* known = answers_.find(key_)) return *known;
    return answers_.add(key_, ask());
  }

  static constexpr std::size_t limit = 1u << 12;
  static constexpr std::size_t dense_bits = 6;
  Projection projection_;
  Projection::Key key_;
  std::vector<std::optional<Answer>> dense_;  ///< by key, where keys are short
  Forgetful<Projection::Key, Answer, WordsHash> answers_{limit};
};

}  // namespace rmpl::automata
