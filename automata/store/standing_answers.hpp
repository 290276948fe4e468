// Answers about one state after another that is much like the one before.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "automata/state.hpp"
#include "automata/store/support.hpp"
#include "base/bounded_cache.hpp"

namespace rmpl::automata {

/// Answers that are asked together, each of what a support reads. An answer stands until something that it reads
/// differs from the question before, so that going on to a state costs what differs in it.
template <class Answer>
class StandingAnswers {
 public:
  StandingAnswers(std::size_t components, std::size_t controls)
      : by_component_(components), by_control_(controls), modes_(components), action_(controls) {}

  /// One more answer, which is not known yet; they are numbered in this order, from 0.
  void add(const Support& support) {
    for (const ComponentId c : support.components) by_component_[c.index()].push_back(answers_.size());
    for (const std::size_t i : support.controls) by_control_[i].push_back(answers_.size());
    answers_.emplace_back();
  }
  void clear() {
    for (auto& readers : by_component_) readers.clear();
    for (auto& readers : by_control_) readers.clear();
    answers_.clear();
  }
  /// No answer is known any more.
  void forget() { std::fill(answers_.begin(), answers_.end(), std::nullopt); }
  /// From here on the answers are about these; an action without controls is one that no answer reads.
  void ask(const Modes& modes, const ControlAction& action) {
    if (!base::caches_on()) forget();
    move(modes_, modes, by_component_);
    if (!action.empty()) move(action_, action, by_control_);
  }
  /// Nothing where it has to be found out.
  std::optional<Answer>& operator[](std::size_t number) { return answers_[number]; }

 private:
  template <class Values>
  void move(Values& from, const Values& to, const std::vector<std::vector<std::size_t>>& readers) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from[i] == to[i]) continue;
      from[i] = to[i];
      for (const std::size_t answer : readers[i]) answers_[answer].reset();
    }
  }

  std::vector<std::vector<std::size_t>> by_component_, by_control_;  ///< the answers that read them
  std::vector<std::optional<Answer>> answers_;
  Modes modes_;  ///< of the last question
  ControlAction action_;
};

}  // namespace rmpl::automata
