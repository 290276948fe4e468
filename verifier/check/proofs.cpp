// Proofs.
// SPDX-License-Identifier: MIT
#include "verifier/check/proofs.hpp"

#include <utility>

#include "verifier/behaviour/folds.hpp"
#include "verifier/check/target_tests.hpp"
#include "verifier/search/search.hpp"

namespace rmpl::verifier {
namespace {

std::optional<CutOff> refuted_in(PlantSystem& system, SearchScope& scope, const SearchScope::Terms& terms) {
  const auto time_left = time_left_in(scope, system.observer(), terms);
  if (time_left) system.leave_out_late(*time_left);
  const auto fewer = fewer_steps(scope, system.situations(), terms.time);
  const bool found = terms.options.merge ? find_corridor(system, terms.meter).has_value()
                                         : find_path(system, SearchOrder::covering, terms.meter).has_value();
  return found ? std::nullopt : std::optional(system.cut_off());
}

/// Null where there is nothing to fold.
std::unique_ptr<Folds> folds_in(SearchScope& scope, const SearchScope::Terms& terms) {
  if (!terms.options.fold || !scope.symmetry().trivial()) return nullptr;
  automata::Support visible;
  for (const automata::Formula& formula : formulas_of(scope.wanted())) {
    visible.join(support_of(scope.step(), formula));
  }
  auto folds = std::make_unique<Folds>(scope.step(), terms.time, terms.options.commands, visible.components);
  return folds->any() ? std::move(folds) : nullptr;
}

std::optional<CutOff> refuted_with(Folds& folds, SearchScope& scope, const Observer& observer,
                                   const SearchScope::Terms& terms, GoesOn goes_on) {
  Situations situations(scope.step(), terms.time, terms.options.commands, terms.faults, terms.meter);
  situations.fold(folds);
  PlantSystem system(situations, observer, scope.symmetry(), scope.start());
  system.fold(folds);
  system.goes_on(goes_on);
  return refuted_in(system, scope, terms);
}

}  // namespace

Observer missed(SearchScope& scope, const SearchScope::Terms& terms) {
  const auto& asked = std::get<Response>(scope.wanted());
  const bool entailed = terms.options.entailed;
  const auto deadline = asked.within.is_infinite() ? std::nullopt : std::optional(terms.time.more_than(asked.within));
  return Observer::miss(holds(scope.step(), asked.after, entailed), holds(scope.step(), asked.then, !entailed),
                        deadline);
}

std::unique_ptr<const Situations::FewerSteps> fewer_steps(SearchScope& scope, Situations& situations,
                                                          const TimeModel& time) {
  if (!time.is_dense()) return nullptr;
  automata::Support visible;  // what the observer reads on the way
  if (const auto* response = std::get_if<Response>(&scope.wanted())) {
    visible.join(support_of(scope.step(), response->after));
    visible.join(support_of(scope.step(), response->then));
  }
  return std::make_unique<const Situations::FewerSteps>(situations, visible.components);
}

std::optional<TimeLeft> time_left_in(SearchScope& scope, const Observer& observer, const SearchScope::Terms& terms) {
  const auto* target = std::get_if<Target>(&scope.wanted());
  if (target == nullptr || !observer.accepted() || observer.accepted()->upper == unbounded) return std::nullopt;
  return TimeLeft(scope.step(), terms.time, target->formula, terms.faults > 0, observer.accepted()->upper);
}

std::optional<CutOff> refuted_folded(SearchScope& scope, const Observer& observer, const SearchScope::Terms& terms) {
  auto folds = folds_in(scope, terms);
  return folds ? refuted_with(*folds, scope, observer, terms, GoesOn::somehow) : std::nullopt;
}

std::optional<CutOff> refuted(SearchScope& scope, const Observer& observer, const SearchScope::Terms& terms,
                              GoesOn goes_on) {
  if (auto folds = folds_in(scope, terms)) return refuted_with(*folds, scope, observer, terms, goes_on);
  PlantSystem system(scope.situations(), observer, scope.symmetry(), scope.start());
  system.goes_on(goes_on);
  return refuted_in(system, scope, terms);
}

}  // namespace rmpl::verifier
