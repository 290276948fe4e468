// Steps and rests gathered by what they do.
// SPDX-License-Identifier: MIT
#include "verifier/export/round_process.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace rmpl::verifier {

using automata::Formula;
using automata::ModeId;
using automata::ValueId;

namespace {

/// In which modes a condition is asked for.
class Places {
 public:
  void add(ModeId mode, const Formula& where) {
    const auto same = std::find_if(parts_.begin(), parts_.end(), [&](const auto& part) { return part.first == where; });
    (same == parts_.end() ? parts_.emplace_back(where, std::vector<ValueId>()) : *same)
        .second.emplace_back(mode.index());
  }

  /// The condition of the mode and the rest together. `all` modes there are.
  [[nodiscard]] Formula formula(automata::VariableId mode, std::size_t all) const {
    std::vector<Formula> cases;
    for (const auto& [where, modes] : parts_) {
      std::vector<Formula> both;
      if (modes.size() < all) both.push_back(automata::member(mode, modes));
      if (!where.is_true()) both.push_back(where);
      cases.push_back(automata::conjunction(std::move(both)));
    }
    return automata::disjunction(std::move(cases));
  }

 private:
  std::vector<std::pair<Formula, std::vector<ValueId>>> parts_;
};

}  // namespace

RoundProcess in_rounds(const automata::Plant& plant, automata::ComponentId component, const ComponentProcess& process) {
  const automata::VariableId mode = plant[component].mode;
  const std::size_t all = plant[component].modes.size();
  RoundProcess result;
  std::map<std::tuple<std::optional<ModeId>, Interval, bool, bool>, Places> steps;
  for (const ProcessStep& step : process.steps) {
    const auto to = step.to == step.from ? std::nullopt : std::optional(step.to);
    steps[{to, step.clock, step.fault, step.restarts}].add(step.from, step.where);
  }
  for (const auto& [what, places] : steps) {
    const auto& [to, clock, fault, restarts] = what;
    result.steps.push_back({places.formula(mode, all), clock, to, fault, restarts});
  }
  std::map<std::tuple<Interval, bool, bool>, Places> rests;
  for (const ProcessRest& rest : process.rests)
    rests[{rest.clock, rest.urgent, rest.restarts}].add(rest.mode, rest.where);
  std::set<Units> bounds;
  for (const auto& [what, places] : rests) {
    const auto& [clock, urgent, restarts] = what;
    result.rests.push_back({places.formula(mode, all), clock, urgent, restarts});
    result.stops = result.stops || urgent;
    result.renews = result.renews || restarts;
    if (!urgent && !restarts && clock.upper != unbounded) bounds.insert(clock.upper);
  }
  result.bounds.assign(bounds.begin(), bounds.end());
  const auto is_free = [](const RoundRest& rest) {
    return !rest.urgent && !rest.restarts && rest.clock.is_trivial() && rest.where.is_true();
  };
  if (std::all_of(result.rests.begin(), result.rests.end(), is_free)) result.rests.clear();
  return result;
}

}  // namespace rmpl::verifier
