// Proofs.
// SPDX-License-Identifier: MIT
#include "verifier/plant/proofs.hpp"

#include <utility>

#include "verifier/plant/folds.hpp"
#include "verifier/plant/sight.hpp"
#include "verifier/search/search.hpp"

namespace rmpl::verifier {
namespace {

std::optional<CutOff> refuted_in(PlantSystem& system, Arena& arena, const Arena::Terms& terms) {
  const auto time_left = time_left_in(arena, system.observer(), terms);
  if (time_left) system.leave_out_late(*time_left);
  const auto fewer = fewer_steps(arena, system.situations(), terms.time);
  const bool found = terms.options.merge ? find_corridor(system, terms.meter).has_value()
                                         : find_path(system, SearchOrder::covering, terms.meter).has_value();
  return found ? std::nullopt : std::optional(system.cut_off());
}

/// Null where there is nothing to fold.
std::unique_ptr<Folds> folds_in(Arena& arena, const Arena::Terms& terms) {
  if (!terms.options.fold || !arena.symmetry().trivial()) return nullptr;
  automata::Support visible;
  for (const automata::Formula& formula : formulas_of(arena.wanted())) {
    visible.join(support_of(arena.step(), formula));
  }
  auto folds = std::make_unique<Folds>(arena.step(), terms.time, terms.options.commands, visible.components);
  return folds->any() ? std::move(folds) : nullptr;
}

std::optional<CutOff> refuted_with(Folds& folds, Arena& arena, const Observer& observer, const Arena::Terms& terms,
                                   GoesOn goes_on) {
  Situations situations(arena.step(), terms.time, terms.options.commands, terms.faults, terms.meter);
  situations.fold(folds);
  PlantSystem system(situations, observer, arena.symmetry(), arena.start());
  system.fold(folds);
  system.goes_on(goes_on);
  return refuted_in(system, arena, terms);
}

}  // namespace

Observer missed(Arena& arena, const Arena::Terms& terms) {
  const auto& asked = std::get<Response>(arena.wanted());
  const bool entailed = terms.options.entailed;
  const auto deadline = asked.within.is_infinite() ? std::nullopt : std::optional(terms.time.more_than(asked.within));
  return Observer::miss(holds(arena.step(), asked.after, entailed), holds(arena.step(), asked.then, !entailed),
                        deadline);
}

std::unique_ptr<const Situations::FewerSteps> fewer_steps(Arena& arena, Situations& situations, const TimeModel& time) {
  if (!time.is_dense()) return nullptr;
  automata::Support visible;  // what the observer reads on the way
  if (const auto* response = std::get_if<Response>(&arena.wanted())) {
    visible.join(support_of(arena.step(), response->after));
    visible.join(support_of(arena.step(), response->then));
  }
  return std::make_unique<const Situations::FewerSteps>(situations, visible.components);
}

std::optional<TimeLeft> time_left_in(Arena& arena, const Observer& observer, const Arena::Terms& terms) {
  const auto* target = std::get_if<Target>(&arena.wanted());
  if (target == nullptr || !observer.accepted() || observer.accepted()->upper == unbounded) return std::nullopt;
  return TimeLeft(arena.step(), terms.time, target->formula, terms.faults > 0, observer.accepted()->upper);
}

std::optional<CutOff> refuted_folded(Arena& arena, const Observer& observer, const Arena::Terms& terms) {
  auto folds = folds_in(arena, terms);
  return folds ? refuted_with(*folds, arena, observer, terms, GoesOn::somehow) : std::nullopt;
}

std::optional<CutOff> refuted(Arena& arena, const Observer& observer, const Arena::Terms& terms, GoesOn goes_on) {
  if (auto folds = folds_in(arena, terms)) return refuted_with(*folds, arena, observer, terms, goes_on);
  PlantSystem system(arena.situations(), observer, arena.symmetry(), arena.start());
  system.goes_on(goes_on);
  return refuted_in(system, arena, terms);
}

}  // namespace rmpl::verifier
