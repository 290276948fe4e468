// Checking a property of a plant: in rounds of ever more faults where fewest are asked for.
// SPDX-License-Identifier: MIT
#include "verifier/check/check.hpp"

#include <limits>

#include "verifier/check/check_once.hpp"
#include "verifier/cut_set/cut_set_rounds.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/slice/empty_claims.hpp"

namespace rmpl::verifier {

namespace {

/// Why nothing can ever violate what holds; nothing where something could.
std::optional<Vacuity> vacuity_of(Slices& slices, const Property& property, const CheckOptions& options, Meter& meter) {
  if (const auto* safety = std::get_if<Safety>(&property)) {
    return vacuity_of_never(slices, safety->never, options.entailed);
  }
  const auto* response = std::get_if<Response>(&property);
  if (response == nullptr) return std::nullopt;
  CheckOptions plain = options;
  plain.cut_sets = plain.fewest_faults = false;
  const unsigned faults = options.faults.value_or(std::numeric_limits<unsigned>::max());
  const Property asks = Reachability{response->after, {}, false};
  const bool asked = check_for_any_witness(slices, asks, plain, faults, meter).verdict != Verdict::violated;
  return asked ? std::nullopt : std::optional(Vacuity::unasked);
}

Answer decide_cut_sets(Slices& slices, const Property& property, const CheckOptions& options, Meter& meter) {
  CutSetRounds rounds(slices.plant(), options.faults.value());
  for (;;) {
    Answer result = check_once(slices, property, options, rounds.faults(), meter);
    if (!result.limit && rounds.next(result.cut_sets, result.progress.faults)) continue;
    result.cut_sets_complete = options.faults;
    if (result.limit) rounds.settle(result);
    return result;
  }
}

Answer decide(Slices& slices, const Property& property, const CheckOptions& options, Meter& meter) {
  if (options.cut_sets) return decide_cut_sets(slices, property, options, meter);
  if (!options.fewest_faults) return check_once(slices, property, options, options.faults.value(), meter);
  // Round by round one fault more. Where no state needs as many as there may be, more of them may still come together
  // and lead somewhere: whether any number does is found out once, and then that is the answer, or the rounds will end.
  const unsigned most = options.faults.value_or(std::numeric_limits<unsigned>::max());
  bool reachable = false;
  for (unsigned faults = 0;; ++faults) {
    Answer result = check_once(slices, property, options, faults, meter);
    if (result.witness) result.fewest_faults = faults;
    if (result.witness || result.limit || faults == most) return result;
    if (reachable || result.progress.faults == faults) continue;
    Answer any = check_for_any_witness(slices, property, options, most, meter);
    if (!any.witness) return any;
    reachable = true;
  }
}

}  // namespace

Answer check(Slices& slices, const Property& property, const CheckOptions& options, const Limits& limits) {
  demand_modes(slices.plant(), options.from);
  Meter meter(limits);
  Answer answer = decide(slices, property, options, meter);
  if (answer.verdict == Verdict::holds) answer.vacuous = vacuity_of(slices, property, options, meter);
  answer.progress = meter.progress();
  return answer;
}

}  // namespace rmpl::verifier
