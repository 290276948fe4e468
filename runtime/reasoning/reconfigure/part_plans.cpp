// Part by part.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/part_plans.hpp"

#include <algorithm>
#include <variant>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

std::optional<std::pair<Impasse, std::size_t>> PartPlans::plan(const Modes& modes, Objective objective,
                                                               std::vector<Offer>& offers) {
  std::vector<bool> planned(parts_.count());
  for (const ComponentId c : planner_.order()) {
    const std::size_t part = parts_.of(c);
    if (!objective.wanted[c.index()] || modes[c.index()] == objective.target[c.index()] || planned[part]) continue;
    planned[part] = true;
    objective.part = part;
    auto found = planner_.next(modes, objective);
    if (auto* impasse = std::get_if<Impasse>(&found)) return std::pair{std::move(*impasse), part};
    auto& way = std::get<IslandPlan>(found);
    const bool brief = planner_.is_brief(way, objective);
    const bool passing = planner_.is_passing(way.first, objective);
    offers.push_back({std::move(way), part, brief, passing, planner_.has_waits(modes, objective)});
  }
  return std::nullopt;
}

Modes PartPlans::end_of(const Modes& modes, const std::vector<Offer>& offers) const {
  Modes end = modes;
  for (const Offer& offer : offers) {
    for (const ComponentId c : parts_.components(offer.part)) end[c.index()] = offer.plan.end[c.index()];
  }
  return end;
}

const PlannedStep& PartPlans::best(const std::vector<Offer>& offers) {
  const auto waiting = std::count_if(offers.begin(), offers.end(), [](const Offer& o) { return o.waits; });
  const auto rank = [&](const Offer& o) {
    if (o.plan.first.idle) return 1;
    if (o.passing) return 3;
    return o.brief && waiting > (o.waits ? 1 : 0) ? 2 : 0;
  };
  return std::min_element(offers.begin(), offers.end(),
                          [&](const Offer& a, const Offer& b) { return rank(a) < rank(b); })
      ->plan.first;
}

}  // namespace rmpl::runtime
