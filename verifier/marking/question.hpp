// What can be asked of a model program, and what is answered (semantics 8).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "automata/phca.hpp"
#include "automata/step/marking_store.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/property/property.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// Whether some run comes to a marking in which a formula holds, or none does. A run takes a step a period, from time
/// 0.
struct MarkingQuestion {
  enum class Kind { reachability, safety };
  Kind kind = Kind::reachability;
  automata::Formula formula;
  Window window;  ///< the times at which the formula counts
  automata::Ticks period;
  Commands commands = Commands::one;
  /// The most improbable draws on a run, those before time 0 included; none: any number.
  std::optional<unsigned> improbable;
  bool fewest_improbable = false;  ///< a run with the fewest of them that there is
  bool entailed = false;           ///< the formula holds where the store implies it, not where it allows it
  Bounds bounds = {};
};

/// A draw of a branch that another one is likelier than.
struct ImprobableDraw {
  automata::LocationId location;
  double probability;
};

/// The marking that a step leads to; the first event is the start, which no command led to.
struct MarkingEvent {
  automata::Marking marking;                      ///< primitive locations
  automata::Command command;                      ///< in force for the step
  std::vector<automata::Assignment> values = {};  ///< what the store entails, by variable
  std::vector<ImprobableDraw> draws = {};         ///< as few as lead here
};

/// From the start to a marking in which the formula holds; event n is at n periods.
struct MarkingWitness {
  std::vector<MarkingEvent> events;
};

struct MarkingAnswer {
  Verdict verdict = Verdict::undecided;
  std::optional<MarkingWitness> witness;  ///< of reachability that it holds, of safety that it is violated
  std::optional<Limit> limit;             ///< why it is undecided
  bool vacuous = false;                   ///< of safety: the constraints for the whole model refute the formula
  bool stuck = false;      ///< no witness, and on some run no step was possible: nothing is said of what would follow
  bool startless = false;  ///< no start marking is consistent
  Progress progress;
};

}  // namespace rmpl::verifier
