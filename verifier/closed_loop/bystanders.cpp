// Bystanders.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/bystanders.hpp"

#include <algorithm>
#include <utility>

#include "verifier/check/apart.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::Formula;

namespace {

std::vector<Formula> read_by(const automata::Program& program, const std::vector<Property>& properties) {
  std::vector<Formula> result;
  for (const automata::Location& location : program.locations) {
    result.push_back(automata::goal_of(location));
    result.push_back(location.maintenance.constraint);
    for (const automata::Arc& arc : location.arcs) result.push_back(arc.guard.constraint);
  }
  for (const Property& property : properties) {
    for (Formula& formula : formulas_of(property)) result.push_back(std::move(formula));
  }
  return result;
}

bool is_rewarded(const Component& component) {
  return std::any_of(component.modes.begin(), component.modes.end(), [](const auto& mode) { return mode.reward != 0; });
}

}  // namespace

std::optional<Stage> without_bystanders(Slices& slices, const automata::Program& program,
                                        const std::vector<Property>& properties, const CheckOptions& options,
                                        Meter& meter) {
  const automata::Plant& plant = slices.plant();
  std::vector<Formula> read = read_by(program, properties);
  const Cone seen = slices.cone(read);
  const SearchScope::Terms terms{TimeModel::of(options.period, plant, {}), options, options.faults.value(), meter};
  bool some = false;
  for (const ConnectedPart& part : connected_parts(slices)) {
    const bool is_seen = std::any_of(part.cone.begin(), part.cone.end(), [&](automata::ComponentId c) {
      return std::binary_search(seen.begin(), seen.end(), c) || is_rewarded(plant[c]);
    });
    const bool stays = is_seen || !slices.part(part.cone, part.formulas).plant().controls.empty() ||
                       !goes_on_by_itself(slices, part, terms);
    some = some || !stays;
    if (stays) read.insert(read.end(), part.formulas.begin(), part.formulas.end());
  }
  if (!some) return std::nullopt;
  Part part = slices.part(slices.cone(read), read);
  automata::Binding binding = automata::bind(program, part.plant());
  if (!binding.lacking.empty()) return std::nullopt;
  return Stage{std::move(part), std::move(binding.program)};
}

Property into(const Part& part, Property property) {
  if (auto* asked = std::get_if<ProgramProperty>(&property)) {
    asked->formula = part.into(asked->formula);
    asked->then = part.into(asked->then);
  }
  return property;
}

}  // namespace rmpl::verifier
