// Findings: modes that no observation tells apart.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <tuple>

#include "compiler/lint/plant/alike.hpp"
#include "compiler/lint/plant/findings.hpp"

namespace rmpl::compiler {

using automata::Component;
using automata::ComponentId;
using automata::ModeId;
using automata::Transition;

namespace {

/// The modes of a component that are reached: faults, or nominal ones.
std::vector<ModeId> reached_modes(const PlantAnalysis& analysis, ComponentId id, bool fault) {
  std::vector<ModeId> result;
  const Component& component = analysis.plant()[id];
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    if (component.modes[m].fault == fault && analysis.reach().reached[id.index()][m]) result.emplace_back(m);
  }
  return result;
}

/// Whether the same nominal transitions lead out of both.
bool left_alike(const Component& component, ModeId a, ModeId b) {
  const auto exits = [&](ModeId mode) {
    std::vector<const Transition*> result;
    for (const Transition& t : component.transitions) {
      if (t.from == mode && !component.is_fault(t)) result.push_back(&t);
    }
    return result;
  };
  const auto same = [](const Transition* x, const Transition* y) {
    return std::tie(x->to, x->guard, x->timing, x->weight, x->restart) ==
           std::tie(y->to, y->guard, y->timing, y->weight, y->restart);
  };
  const auto left = exits(a);
  const auto right = exits(b);
  return std::is_permutation(left.begin(), left.end(), right.begin(), right.end(), same);
}

/// `alike(a, b)` for each pair of modes; in which they are.
template <class Alike>
void add_pairs(AlikeQuestions& questions, ComponentId id, const std::vector<ModeId>& modes, const Alike& alike,
               std::vector<AlikeModes>& found) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    for (std::size_t j = i + 1; j < modes.size(); ++j) {
      if (alike(modes[i], modes[j]))
        found.push_back({id, modes[i], modes[j], questions.would_tell(modes[i], modes[j])});
    }
  }
}

}  // namespace

Indistinguishable find_indistinguishable(PlantAnalysis& analysis) {
  Indistinguishable found;
  if (analysis.plant().observables.empty()) return found;
  for (std::size_t c = 0; c < analysis.plant().components.size(); ++c) {
    const ComponentId id(c);
    const std::vector<ModeId> nominal = reached_modes(analysis, id, false);
    const std::vector<ModeId> faults = reached_modes(analysis, id, true);
    if (nominal.size() + faults.size() < 2) continue;
    AlikeQuestions questions(analysis, id);
    const auto looks = [&](ModeId a, ModeId b) {
      return questions.look_alike(a, b) == true && questions.go_with_the_same(a, b) == true;
    };
    const auto is = [&](ModeId a, ModeId b) { return looks(a, b) && questions.mean_alike(a, b); };
    add_pairs(questions, id, nominal, looks, found.modes);
    const auto same_fault = [&](ModeId a, ModeId b) { return left_alike(analysis.plant()[id], a, b) && is(a, b); };
    add_pairs(questions, id, faults, same_fault, found.faults);
    for (const ModeId fault : faults) {
      const bool hidden = std::all_of(nominal.begin(), nominal.end(), [&](ModeId mode) { return is(fault, mode); });
      if (hidden && !nominal.empty()) found.undetectable.push_back({id, fault});
    }
  }
  return found;
}

}  // namespace rmpl::compiler
