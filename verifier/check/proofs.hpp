// Proofs: searches that tell whether there is a witness, and none.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "verifier/check/search_scope.hpp"
#include "verifier/plant/observer.hpp"
#include "verifier/plant/plant_system.hpp"
#include "verifier/plant/time_left.hpp"

namespace rmpl::verifier {

/// In dense time, for as long as it lives, the steps that nothing else makes up for.
std::unique_ptr<const Situations::FewerSteps> fewer_steps(SearchScope& scope, Situations& situations,
                                                          const TimeModel& time);

/// Where a target is to be reached by some time: how long it takes at least.
std::optional<TimeLeft> time_left_in(SearchScope& scope, const Observer& observer, const SearchScope::Terms& terms);

/// The answer of a response that the scope is about, missed.
Observer missed(SearchScope& scope, const SearchScope::Terms& terms);

/// Whether there is no witness, as a search in which timers are folded tells: then how runs were cut off in it. Nothing
/// where there is one, or nothing to fold. Throws LimitReached.
std::optional<CutOff> refuted_folded(SearchScope& scope, const Observer& observer, const SearchScope::Terms& terms);
/// The same with folds, or without where there is nothing to fold.
std::optional<CutOff> refuted(SearchScope& scope, const Observer& observer, const SearchScope::Terms& terms,
                              GoesOn goes_on = GoesOn::somehow);

}  // namespace rmpl::verifier
