// Probabilities as text, as JSON (grammar/schema/probability.schema.json) and as curves.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "verifier/markov/probability.hpp"

namespace rmpl::verifier {

/// For people, lines ended. `asked` names the formula as written.
std::string to_text(const ProbabilityQuestion& question, const ProbabilityAnswer& answer, const std::string& asked);
nlohmann::ordered_json to_json(const ProbabilityQuestion& question, const ProbabilityAnswer& answer,
                               const std::string& asked);

/// The curve as a table: `time,lower,upper`, or `time,min_lower,min_upper,max_lower,max_upper`, times in seconds.
std::string curve_csv(const ProbabilityAnswer& answer);
/// The same drawn, as SVG.
std::string curve_svg(const ProbabilityAnswer& answer, const std::string& asked);

/// Enclosure as doubles, rounded outward: what is above 0 stays so above.
struct DoubleBounds {
  double lower, upper;
};
DoubleBounds as_doubles(const Enclosure& bounds);
/// One number where both bounds read the same, else `between … and …`.
std::string number_text(const Enclosure& bounds);

}  // namespace rmpl::verifier
