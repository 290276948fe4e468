// Answers about model programs as text, as JSON (grammar/schema/verdict.schema.json) and as JUnit XML.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "verifier/marking/question.hpp"

namespace rmpl::verifier {

/// For people, lines ended, in colour if asked for: of the start what is entailed, of each step the command, what
/// changes of that, and the improbable draws.
std::string to_text(const automata::ModelProgram& program, const MarkingQuestion& question, const MarkingAnswer& answer,
                    bool color);
/// For programs. Times are seconds.
nlohmann::ordered_json to_json(const automata::ModelProgram& program, const MarkingQuestion& question,
                               const MarkingAnswer& answer);
/// One suite with one case, which is called `title`.
std::string to_junit(const automata::ModelProgram& program, const MarkingQuestion& question,
                     const MarkingAnswer& answer, const std::string& title);

}  // namespace rmpl::verifier
