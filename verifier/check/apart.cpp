// Parts by themselves.
// SPDX-License-Identifier: MIT
#include "verifier/check/apart.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/partition.hpp"
#include "verifier/check/proofs.hpp"
#include "verifier/check/target_tests.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::ComponentId;
using automata::Formula;

namespace {

/// Something that reads the mode of the component.
Formula about(const Component& component) { return automata::is(component.mode, automata::ValueId(0)); }

/// Whether the faults of some mode leave no nominal share.
bool can_be_certain(const Component& component) {
  std::vector<double> faults(component.modes.size(), 0);
  for (const automata::Transition& t : component.transitions) {
    const bool drawn = component.is_fault(t) && t.weight.kind != automata::Weight::Kind::rate;
    if (drawn) faults[t.from.index()] += t.weight.value;
  }
  return std::any_of(faults.begin(), faults.end(), [](double sum) { return sum >= 1; });
}

}  // namespace

bool meet(const Cone& a, const Cone& b) {
  Cone both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return !both.empty();
}

std::vector<ConnectedPart> connected_parts(Slices& slices) {
  const auto& components = slices.plant().components;
  base::Partition partition(components.size());
  for (std::size_t c = 0; c < components.size(); ++c) {
    if (partition.root(c) != c) continue;  // in the cone of an earlier one, and its own cone is, too
    const Formula own = about(components[c]);
    for (const ComponentId other : slices.cone({&own, 1})) partition.join(c, other.index());
  }
  std::vector<ConnectedPart> parts(components.size());  // by root
  for (std::size_t c = 0; c < components.size(); ++c) {
    ConnectedPart& part = parts[partition.root(c)];
    part.formulas.push_back(about(components[c]));
    part.cone.emplace_back(c);
  }
  std::erase_if(parts, [](const ConnectedPart& part) { return part.cone.empty(); });
  return parts;
}

bool goes_on_by_itself(Slices& slices, const ConnectedPart& part, const SearchScope::Terms& terms) {
  const auto& components = slices.plant().components;
  if (std::any_of(part.cone.begin(), part.cone.end(),
                  [&](ComponentId c) { return can_be_certain(components[c.index()]); })) {
    return false;
  }
  SearchScope scope(slices.part(part.cone, part.formulas), slices.start(terms.options.from).value(), Stuck{}, terms);
  const auto cut_off = refuted(scope, Observer::end(), terms, GoesOn::idle);
  return cut_off && !cut_off->ends();
}

bool each_goes_on(Slices& slices, const SearchScope::Terms& terms) {
  const automata::Modes start = slices.start(terms.options.from).value();
  if (!slices.whole().consistent(start, automata::idle_action(slices.plant()))) return false;
  const std::vector<ConnectedPart> parts = connected_parts(slices);
  return parts.size() > 1 && std::all_of(parts.begin(), parts.end(), [&](const ConnectedPart& part) {
           return goes_on_by_itself(slices, part, terms);
         });
}

bool comes_in_its_part(Slices& slices, const Response& response, const SearchScope::Terms& terms) {
  std::vector<Formula> others = automata::conjuncts_of(response.after);
  if (response.within.is_infinite() || others.size() < 2) return false;
  std::vector<Formula> own;
  Cone cone = slices.cone({&response.then, 1});
  for (bool grows = true; grows;) {
    const auto connected = std::partition(others.begin(), others.end(), [&](const Formula& one) {
      return !meet(slices.cone({&one, 1}), cone);
    });
    grows = connected != others.end();
    own.insert(own.end(), connected, others.end());
    others.erase(connected, others.end());
    std::vector<Formula> all = own;
    all.push_back(response.then);
    cone = slices.cone(all);
  }
  const std::vector<Formula> both = {response.after, response.then};
  if (2 * cone.size() > slices.cone(both).size()) return false;
  const Response weaker{automata::conjunction(own), response.then, response.within};
  SearchScope scope(slices.part(cone, std::vector<Formula>{weaker.after, weaker.then}),
                    slices.start(terms.options.from).value(), weaker, terms);
  const auto cut_off = refuted(scope, missed(scope, terms), terms);
  return cut_off && !cut_off->ends() && !cut_off->spent;
}

}  // namespace rmpl::verifier
