// Claims that a model decides: by its modes and constraints alone.
// SPDX-License-Identifier: MIT
#include "verifier/slice/empty_claims.hpp"

#include <optional>
#include <utility>

#include "base/overloaded.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::ModeId;
using Kind = ProgramProperty::Kind;

namespace {

/// The modes that transitions lead to, by mode, with faults or without; the guards may say what they like.
std::vector<bool> reached(const Component& component, const std::vector<ModeId>& start, bool faults) {
  std::vector<bool> reached(component.modes.size());
  for (const ModeId m : start) reached[m.index()] = true;
  for (bool more = true; more;) {
    more = false;
    for (const automata::Transition& t : component.transitions) {
      if (!reached[t.from.index()] || reached[t.to.index()] || (!faults && component.is_fault(t))) continue;
      reached[t.to.index()] = more = true;
    }
  }
  return reached;
}

/// The formula in the modes that components come to from those given by `from` or the initial ones.
Formula among_reached(Slices& slices, const Formula& formula, const std::vector<automata::Assignment>& from,
                      bool faults) {
  const automata::Plant& plant = slices.plant();
  const auto starts = initial_modes(plant, from);
  std::vector<Formula> parts{formula};
  for (const ComponentId c : slices.cone({&formula, 1})) {
    const std::vector<bool> there = reached(plant[c], starts[c.index()], faults);
    std::vector<automata::ValueId> modes;
    for (std::size_t m = 0; m < there.size(); ++m) {
      if (there[m]) modes.emplace_back(m);
    }
    if (modes.size() < there.size()) parts.push_back(automata::member(plant[c].mode, std::move(modes)));
  }
  return automata::conjunction(std::move(parts));
}

/// What a property asks whether it happens.
std::optional<Formula> event_of(const Property& property) {
  return std::visit(base::Overloaded{[](const Reachability& p) { return std::optional(p.target); },
                                     [](const Safety& p) { return std::optional(p.never); },
                                     [](const Response&) { return std::optional<Formula>(); },
                                     [](const Stuck&) { return std::optional<Formula>(); },
                                     [](const ProgramProperty& p) {
                                       return p.kind == Kind::never ? std::optional(p.formula) : std::nullopt;
                                     }},
                    property);
}

/// What a property asks to come.
std::optional<Formula> promise_of(const Property& property) {
  return std::visit(base::Overloaded{[](const Reachability& p) { return std::optional(p.target); },
                                     [](const Safety&) { return std::optional<Formula>(); },
                                     [](const Response& p) { return std::optional(p.then); },
                                     [](const Stuck&) { return std::optional<Formula>(); },
                                     [](const ProgramProperty& p) {
                                       if (p.kind == Kind::response) return std::optional(p.then);
                                       const bool comes = p.kind == Kind::eventually || p.kind == Kind::finally;
                                       return comes ? std::optional(p.formula) : std::nullopt;
                                     }},
                    property);
}

}  // namespace

bool takes_a_fault(Slices& slices, const Formula& formula, const std::vector<automata::Assignment>& from) {
  return !slices.can_hold(among_reached(slices, formula, from, false)) &&
         slices.can_hold(among_reached(slices, formula, from, true));
}

std::optional<Formula> out_of_reach(Slices& slices, const Property& property, const CheckOptions& options) {
  const bool none_permitted = options.faults == 0u && !options.fewest_faults && !options.cut_sets;
  auto event = event_of(property);
  if (!none_permitted || !event || !takes_a_fault(slices, *event, options.from)) return std::nullopt;
  return event;
}

std::optional<Vacuity> vacuity_of_never(Slices& slices, const Formula& never, bool entailed) {
  if (!slices.can_hold(never)) return Vacuity::unsatisfiable;
  return entailed && !slices.can_follow(never) ? std::optional(Vacuity::unimplied) : std::nullopt;
}

bool answers_itself(Slices& slices, const Property& property) {
  const auto itself = [&](const Formula& after, const Formula& then) {
    for (const Formula* formula : {&after, &then}) {
      for (const automata::VariableId v : automata::variables_of(*formula)) {
        if (!slices.plant().component_of(v)) return false;
      }
    }
    return slices.can_hold(after) && !slices.can_hold(automata::conjunction({after, automata::negation(then)}));
  };
  if (const auto* response = std::get_if<Response>(&property)) return itself(response->after, response->then);
  const auto* asked = std::get_if<ProgramProperty>(&property);
  return asked != nullptr && asked->kind == Kind::response && itself(asked->formula, asked->then);
}

std::optional<Formula> there_anyway(Slices& slices, const Property& property) {
  auto promise = promise_of(property);
  if (!promise || slices.can_hold(automata::negation(*promise))) return std::nullopt;
  return promise;
}

}  // namespace rmpl::verifier
