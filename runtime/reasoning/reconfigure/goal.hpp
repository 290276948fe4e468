// A configuration goal, taken apart once: what it asks of modes, and what is left to entailment.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::runtime {

/// A goal is most often a conjunction of mode assignments; those restrict the modes to choose from. The rest, over
/// attributes or with other connectives, is asked of the store.
class Goal {
 public:
  Goal(const automata::Formula& formula, const automata::Plant& plant, automata::Theory& theory);

  [[nodiscard]] const automata::Formula& formula() const { return formula_; }
  [[nodiscard]] const NamedModes& named() const { return named_; }
  /// Whether the conjuncts over a component's mode alone permit this mode.
  [[nodiscard]] bool permits(automata::ComponentId component, automata::ModeId mode) const {
    return permitted_[component.index()][mode.index()];
  }
  /// What modes alone do not decide, and its negation; nothing where they decide all.
  struct Rest {
    automata::Theory::Handle holds, fails;
    automata::Formula formula;
  };
  [[nodiscard]] const std::optional<Rest>& rest() const { return rest_; }

 private:
  automata::Formula formula_;
  NamedModes named_;
  std::vector<std::vector<bool>> permitted_;
  std::optional<Rest> rest_;
};

}  // namespace rmpl::runtime
