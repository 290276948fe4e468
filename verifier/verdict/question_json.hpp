// What was asked, as JSON: an answer says to which question.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "automata/plant.hpp"
#include "verifier/property/property.hpp"

namespace rmpl::verifier {

/// The formulas and times of a property: `formula`, `after`, `within`, `not_before`, `by`, `fastest`; what it has.
nlohmann::ordered_json claim_of(const automata::Plant& plant, const Property& property);

/// The claim, what is free, and the bounds of the search. Options on which no answer depends (symmetry) are
/// left out.
nlohmann::ordered_json question_json(const automata::Plant& plant, const Question& question);
/// What is free, and the bounds; each check has its own claim.
nlohmann::ordered_json question_json(const automata::Plant& plant, const ProgramQuestion& question);

}  // namespace rmpl::verifier
