// Verdicts, and what they rest on.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verifier/property/fault.hpp"
#include "verifier/property/property.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/search/standstill.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

enum class Verdict { holds, violated, undecided };

/// A minimal set of faults, with a run that has them and no others.
struct CutSet {
  std::vector<Fault> faults;
  Witness witness;
};

/// Why nothing could ever violate what holds.
enum class Vacuity {
  unsatisfiable,  ///< no state satisfies what is never to hold
  unimplied,      ///< none implies it, where that is what counts
  over,           ///< the program has ended by the time from which on that counts
  unasked,        ///< what asks for a response never happens
  endless         ///< the program never ends
};

/// What became of a question.
struct Answer {
  Verdict verdict = Verdict::undecided;
  std::optional<Witness> witness;      ///< of reachability that it holds, of all others that they are violated
  std::vector<Witness> others;         ///< of missing plans and endless waits: those with other causes, soonest first
  std::optional<std::size_t> same_as;  ///< the answer, found together with it, that has the same witness
  std::optional<unsigned> fewest_faults;  ///< those of the witness, where they were asked for and there is one
  std::vector<CutSet> cut_sets;           ///< where they were asked for; smallest first, each minimal in any case
  /// All of runs with up to so many faults are there; none where not even runs without a fault are known.
  std::optional<unsigned> cut_sets_complete;
  /// Why it is undecided; or, beside a witness, why a better one (fewer steps, or less time) may have been missed.
  std::optional<Limit> limit;
  std::optional<Vacuity> vacuous;  ///< where it holds as nothing could ever violate it
  /// How runs that were looked at without a witness are cut off: the verdict says nothing of what would follow. Where
  /// time stands still it is undecided.
  CutOff cut_off;
  /// No initial state is possible (semantics 3), so that nothing is reachable: the verdict says nothing of the plant.
  bool startless = false;
  /// What is most likely meant otherwise in the question, or misunderstood of the answer.
  std::vector<std::string> warnings;
  /// Of the search that decided; questions that are decided together are counted together.
  Progress progress;
};

/// Whether it holds as nothing can violate it: of itself, or as no run starts.
inline bool holds_vacuously(const Answer& answer) {
  return answer.vacuous.has_value() || (answer.startless && answer.verdict == Verdict::holds);
}

/// Of all together: violated where one is, else undecided where one is. Those that only warn are left out.
Verdict overall(const std::vector<Property>& properties, const std::vector<Answer>& answers);

/// Whether the property only warns.
bool is_warning(const Property& property);

}  // namespace rmpl::verifier
