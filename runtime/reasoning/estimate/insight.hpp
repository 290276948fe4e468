// What an executive knows of the plant beyond the estimate: answers to `surprise`, `possible` and `likely`
// (semantics 2).
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// The component that `surprise(c)` or `noplan(c)` is about; nothing without one.
std::optional<automata::ComponentId> about(const automata::Plant& plant, const automata::Formula& atom);

/// Answers atoms of knowledge by a belief. It costs nothing where nothing is asked. Keeps a reference to the plant.
class Insight {
 public:
  /// `atoms`: all that will be asked.
  Insight(const automata::Plant& plant, const std::vector<automata::Formula>& atoms);

  /// Whether it is so as of the estimator's last update; `readings` are those of that update that count. Not for
  /// `noplan`, which is the planner's to tell.
  bool answer(const automata::Formula& atom, const Estimator& estimator,
              std::span<const automata::Assignment> readings);

 private:
  /// A formula about the plant, and the components whose belief decides it: all of the independent groups that it
  /// speaks of.
  struct Question {
    automata::Formula formula;
    automata::Theory::Handle handle;
    std::vector<automata::ComponentId> components;
  };
  [[nodiscard]] const Question& question(const automata::Formula& formula) const;

  const automata::Plant& plant_;
  std::optional<automata::Theory> theory_;  ///< of the model; none where no formula is asked
  std::vector<Question> questions_;
  std::vector<automata::Assignment> known_;
};

}  // namespace rmpl::runtime
