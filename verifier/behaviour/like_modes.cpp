// Like modes.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/like_modes.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::Component;
using automata::Formula;
using automata::ModeId;
using automata::ValueId;

namespace {

/// Of each variable the sets of values that formulas name.
using Named = std::vector<std::vector<const std::vector<ValueId>*>>;

/// `apart`: variables whose values are compared one by one.
void collect(const Formula& formula, Named& named, std::vector<bool>& apart) {
  if (formula.kind == Formula::Kind::member) named[formula.variable.index()].push_back(&formula.values);
  if (formula.kind == Formula::Kind::equality) {
    apart[formula.variable.index()] = true;
    apart[formula.other.index()] = true;
  }
  for (const Formula& operand : formula.operands) collect(operand, named, apart);
}

bool contains(const std::vector<ValueId>& values, std::size_t value) {
  return std::binary_search(values.begin(), values.end(), ValueId(value));
}

}  // namespace

LikeModes::LikeModes(const automata::Plant& plant) {
  Named named(plant.variables.size());
  std::vector<bool> apart(plant.variables.size(), false);
  for (const automata::Interconnection& q : plant.interconnections) collect(q.constraint, named, apart);
  for (const Component& component : plant.components) {
    for (const automata::Mode& mode : component.modes) collect(mode.constraint, named, apart);
    for (const automata::Transition& t : component.transitions) collect(t.guard, named, apart);
  }
  for (const Component& component : plant.components) {
    const std::size_t variable = component.mode.index();
    const auto alike = [&](std::size_t a, std::size_t b) {
      return a == b || (!apart[variable] && component.modes[a].constraint == component.modes[b].constraint &&
                        std::all_of(named[variable].begin(), named[variable].end(),
                                    [&](const auto* values) { return contains(*values, a) == contains(*values, b); }));
    };
    auto& first = first_.emplace_back();
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      std::size_t like = 0;
      while (!alike(like, m)) ++like;
      first.emplace_back(like);
    }
  }
}

void LikeModes::read(const automata::Modes& modes, automata::Modes& result) const {
  result.resize(modes.size());
  for (std::size_t c = 0; c < modes.size(); ++c) result[c] = first_[c][modes[c].index()];
}

}  // namespace rmpl::verifier
