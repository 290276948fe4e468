// What has been proved about a part of the plant, by what that part depends on.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/store/support.hpp"
#include "base/bounded_cache.hpp"

namespace rmpl::automata {

/// Answers by projected modes and controls. A reference lasts until the next `find` that asks.
template <class Answer>
class Memory {
 public:
  Memory(const Plant& plant, const Support& support) : projection_(plant, support) {}

  /// The remembered answer, or `ask()`, which is then remembered.
  template <class Ask>
  Answer& find(const Modes& modes, const ControlAction& action, const Ask& ask) {
    projection_.read(modes, action, key_);
    if (projection_.bits() > dense_bits) return answers_.find_or(key_, ask);
    if (dense_.empty()) dense_.resize(std::size_t{1} << projection_.bits());
    std::optional<Answer>& known = dense_[key_.empty() ? 0 : key_.front()];
    if (!known || !base::caches_on()) known = ask();
    return *known;
  }
  /// The same for an answer that depends on something more, which has a number.
  template <class Ask>
  Answer& find(const Modes& modes, std::uint64_t more, const Ask& ask) {
    projection_.read(modes, {}, key_);
    key_.push_back(more);
    return answers_.find_or(key_, ask);
  }

 private:
  static constexpr std::size_t limit = 1u << 12;
  static constexpr std::size_t dense_bits = 6;
  Projection projection_;
  Projection::Key key_;
  std::vector<std::optional<Answer>> dense_;  ///< by key, where keys are short
  base::BoundedCache<Projection::Key, Answer> answers_{limit};
};

}  // namespace rmpl::automata
