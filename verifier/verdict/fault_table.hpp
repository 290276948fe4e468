// Every fault by itself: what may come of it under a program.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "verifier/property/fault.hpp"
#include "verifier/property/property.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/verdict/subject.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// What may come of a single fault, whenever it happens; or of none. Each with the soonest run on which it comes so.
struct FaultOutcome {
  std::optional<FaultStep> fault;
  std::optional<Witness> happens = std::nullopt;  ///< the way to the fault; nothing where it cannot happen
  std::optional<Witness> success = std::nullopt;  ///< the program ends, and every `finally` holds
  std::optional<Witness> lost = std::nullopt;     ///< a property of the mission is violated
  std::optional<Witness> waits = std::nullopt;    ///< the program waits for ever
  std::optional<Witness> goes_on = std::nullopt;  ///< it goes on for ever without ending
  std::optional<Witness> no_plan = std::nullopt;  ///< a goal is without a plan
  std::optional<Witness> stops = std::nullopt;    ///< nothing can follow, or time stands still
  std::optional<Witness> another = std::nullopt;  ///< another fault is certain: what would follow is not told
  bool decided = false;
  /// Which of them come without the fault too, so that they are not the fault's: the same property is violated; the
  /// program waits at the same locations, and is not short of a plan there only now.
  struct Anyway {
    bool lost = false, waits = false, goes_on = false, stops = false, another = false;
  };
  Anyway anyway = {};
  /// No run without a fault ends, so the end is not what the program is for: that it goes on or waits is no failure by
  /// itself.
  bool unending = false;
  bool waits_without_plan = false;  ///< the wait is for a goal without a plan
  bool costs_success = false;       ///< without the fault there is success, and with it there is none
  /// Of a program without end: nominal transitions lead from the fault to modes that are no fault, and no run takes
  /// them.
  bool unrepaired = false;

  /// Whether one of them is the fault's own, and a failure.
  [[nodiscard]] bool adds() const {
    const bool hangs = !unending || waits_without_plan || unrepaired;
    return (lost && !anyway.lost) || (waits && !anyway.waits && hangs) || (goes_on && !anyway.goes_on && !unending) ||
           (stops && !anyway.stops) || (another && !anyway.another);
  }
  /// Whether all that comes of it comes anyway, but success does not come any more.
  [[nodiscard]] bool spoils() const {
    return costs_success && !adds() && (lost || waits || goes_on || stops || another);
  }
  /// Whether it can lose the mission, or keep a program that ends at all from ending.
  [[nodiscard]] bool fails() const { return adds() || spoils(); }
};

struct FaultTable {
  std::vector<FaultOutcome> rows;  ///< no fault, then every fault transition, in declaration order
  std::optional<Limit> limit = std::nullopt;
  Progress progress = {};
  std::vector<std::string> warnings = {};  ///< of the mission: what is most likely meant otherwise
};

/// What can come of a fault, in words, best first; where a limit was hit, what was found until then and `undecided`.
std::vector<std::string> outcomes_of(const FaultOutcome& row);

/// One row a fault: what may come of it. The properties of the question are the mission.
nlohmann::ordered_json to_json(const Subject& subject, const ProgramQuestion& question, const FaultTable& table);
std::string to_text(const Subject& subject, const FaultTable& table);
/// A test case a fault, and one for none: a failure where it can lose the mission, or keep the program from ending.
std::string to_junit(const Subject& subject, const FaultTable& table);

}  // namespace rmpl::verifier
