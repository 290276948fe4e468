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
  std::optional<Witness> lost = std::nullopt;     ///< a property among never, eventually and finally is violated
  std::optional<Witness> waits = std::nullopt;    ///< the program waits for ever
  std::optional<Witness> goes_on = std::nullopt;  ///< it goes on for ever without ending
  std::optional<Witness> no_plan = std::nullopt;  ///< a goal is without a plan
  std::optional<Witness> stops = std::nullopt;    ///< nothing can follow, or time stands still
  bool decided = false;
  /// Which of them come without the fault too, so that they are not the fault's.
  struct Anyway {
    bool lost = false, waits = false, goes_on = false, stops = false;
  };
  Anyway anyway = {};

  /// Whether it can lose the mission, or keep the program from ending.
  [[nodiscard]] bool fails() const {
    return (lost && !anyway.lost) || (waits && !anyway.waits) || (goes_on && !anyway.goes_on) ||
           (stops && !anyway.stops);
  }
};

struct FaultTable {
  std::vector<FaultOutcome> rows;  ///< no fault, then every fault transition, in declaration order
  std::optional<Limit> limit = std::nullopt;
  Progress progress = {};
};

/// One row a fault: what may come of it. The properties of the question are the mission.
nlohmann::ordered_json to_json(const Subject& subject, const ProgramQuestion& question, const FaultTable& table);
std::string to_text(const Subject& subject, const FaultTable& table);
/// A test case a fault, and one for none: a failure where it can lose the mission, or keep the program from ending.
std::string to_junit(const Subject& subject, const FaultTable& table);

}  // namespace rmpl::verifier
