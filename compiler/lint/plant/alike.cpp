// Two modes of a component, compared island by island.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/alike.hpp"

#include <algorithm>
#include <set>

namespace rmpl::compiler {

using automata::ComponentId;
using automata::Formula;
using automata::Island;
using automata::ModeId;
using automata::VariableId;

namespace {

/// Attributes up to which an island is copied.
constexpr std::size_t island_limit = 48;

}  // namespace

AlikeQuestions::AlikeQuestions(PlantAnalysis& analysis, ComponentId component)
    : analysis_(analysis), component_(component), islands_(analysis.islands_of(component)) {
  const auto& islands = analysis.locality().islands();
  std::stable_sort(islands_.begin(), islands_.end(), [&](std::size_t a, std::size_t b) {
    return islands[a].attributes.size() < islands[b].attributes.size();
  });
  copies_.resize(islands_.size());
  for (std::size_t i = 0; i < islands_.size(); ++i) written_.push_back(written(i));
}

AlikeQuestions::Written AlikeQuestions::written(std::size_t number) const {
  const automata::Component& component = analysis_.plant()[component_];
  Written result;
  result.under.resize(component.modes.size());
  for (const automata::Constraint& constraint : island(number).constraints) {
    const std::vector<VariableId> variables = variables_of(constraint.formula);
    if (std::binary_search(variables.begin(), variables.end(), component.mode)) result.reads_mode = true;
    if (constraint.under && constraint.under->variable == component.mode) {
      result.under[constraint.under->value.index()].push_back(&constraint.formula);
    }
  }
  return result;
}

const Island& AlikeQuestions::island(std::size_t number) const {
  return analysis_.locality().islands()[islands_[number]];
}

bool AlikeQuestions::is_large(std::size_t number) const { return island(number).attributes.size() > island_limit; }

/// Whether the island has the same constraints of both modes, as they are written, and no other reads the mode.
bool AlikeQuestions::reads_alike(std::size_t number, ModeId a, ModeId b) const {
  const auto& [under, reads_mode] = written_[number];
  const auto same = [](const Formula* x, const Formula* y) { return *x == *y; };
  return !reads_mode && std::equal(under[a.index()].begin(), under[a.index()].end(), under[b.index()].begin(),
                                   under[b.index()].end(), same);
}

PlantCopies& AlikeQuestions::copies(std::size_t number) {
  auto& copies = copies_[number];
  if (!copies) {
    copies = std::make_unique<PlantCopies>(analysis_, component_, std::vector{islands_[number]},
                                           std::vector<const Formula*>{});
  }
  return *copies;
}

std::optional<bool> AlikeQuestions::look_alike(ModeId a, ModeId b) {
  bool open = false;
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    const std::vector<VariableId>& attributes = island(i).attributes;
    const bool seen = std::any_of(attributes.begin(), attributes.end(), [&](VariableId v) {
      return analysis_.observed(v) && !analysis_.index().control_of(v);
    });
    if (!seen || reads_alike(i, a, b)) continue;
    if (is_large(i)) {
      open = true;
      continue;
    }
    const std::optional<bool> alike = copies(i).look_alike(a, b);
    if (alike == false) return false;
    open = open || !alike;
  }
  if (open) return std::nullopt;
  return true;
}

std::optional<bool> AlikeQuestions::go_with_the_same(ModeId a, ModeId b) {
  bool large = false;
  bool alike = true;
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    large = large || is_large(i);
    alike = alike && reads_alike(i, a, b);
  }
  if (alike) return true;  // both are reached, and what holds of the others is the same
  if (large) return std::nullopt;
  return whole().go_with_the_same(a, b);
}

bool AlikeQuestions::mean_alike(ModeId a, ModeId b) {
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    if (is_large(i)) return false;
  }
  return whole().mean_alike(a, b);
}

PlantCopies& AlikeQuestions::whole() {
  if (!whole_) {
    std::set<PlantTransition> readers;
    const auto add = [&](VariableId v) {
      for (const PlantTransition& reader : analysis_.readers_of(v)) {
        if (reader.component != component_) readers.insert(reader);
      }
    };
    for (const std::size_t i : islands_) {
      for (const VariableId v : analysis_.locality().islands()[i].attributes) add(v);
    }
    add(analysis_.plant()[component_].mode);
    std::vector<const Formula*> guards;
    for (const PlantTransition& reader : readers) {
      guards.push_back(&analysis_.plant()[reader.component].transitions[reader.transition.index()].guard);
    }
    whole_ = std::make_unique<PlantCopies>(analysis_, component_, islands_, std::move(guards));
  }
  return *whole_;
}

std::vector<VariableId> AlikeQuestions::would_tell(ModeId a, ModeId b) {
  const automata::Component& component = analysis_.plant()[component_];
  std::set<VariableId> read;
  for (const ModeId mode : {a, b}) {
    for (const VariableId v : variables_of(component.modes[mode.index()].constraint)) read.insert(v);
  }
  const std::vector<VariableId> candidates(read.begin(), read.end());
  std::set<VariableId> found;
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    if (is_large(i)) continue;
    for (const VariableId v : copies(i).would_tell(a, b, candidates)) found.insert(v);
  }
  return {found.begin(), found.end()};
}

}  // namespace rmpl::compiler
