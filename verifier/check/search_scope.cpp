// Search scopes.
// SPDX-License-Identifier: MIT
#include "verifier/check/search_scope.hpp"

#include <utility>

namespace rmpl::verifier {

using automata::Modes;
using automata::PlantStep;

SearchScope::SearchScope(PlantStep& whole, const Wanted& wanted, const Terms& terms)
    : SearchScope(nullptr, {}, &whole, wanted, terms) {}

SearchScope::SearchScope(Part part, Modes rest, const Wanted& wanted, const Terms& terms)
    : SearchScope(std::make_unique<const Part>(std::move(part)), std::move(rest), nullptr, wanted, terms) {}

SearchScope::SearchScope(std::unique_ptr<const Part> part, Modes rest, PlantStep* whole, const Wanted& wanted,
                         const Terms& terms)
    : part_(std::move(part)),
      rest_(std::move(rest)),
      step_(whole != nullptr ? *whole : own_.emplace(part_->plant())),
      wanted_(part_ ? into(*part_, wanted) : wanted),
      from_(part_ ? part_->into(terms.options.from) : terms.options.from),
      situations_(step_, terms.time, terms.options.commands, terms.faults, terms.meter),
      start_(situations_.initial(from_)) {
  // Runs without end are told in the plant's own names.
  const auto* response = std::get_if<Response>(&wanted_);
  const bool some_day = response != nullptr && response->within.is_infinite();
  if (some_day) situations_.tell_exits();
  if (!terms.options.symmetry || terms.options.cut_sets || some_day) return;
  symmetry_ = Symmetry(automorphisms(step_.plant(), formulas_of(wanted_), from_));
  situations_.up_to(symmetry_);
}

Witness SearchScope::out(Witness witness) const {
  if (!part_) return witness;
  for (Event& event : witness.events) {
    event.modes = part_->out(event.modes, rest_);
    for (automata::ComponentId& component : event.restarted) component = part_->out(component);
    event.action = part_->out(event.action);
  }
  return witness;
}

std::vector<Fault> SearchScope::out(std::vector<Fault> faults) const {
  if (!part_) return faults;
  for (Fault& fault : faults) fault.component = part_->out(fault.component);
  return faults;
}

}  // namespace rmpl::verifier
