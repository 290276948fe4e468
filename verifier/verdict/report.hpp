// Answers as text, as JSON (grammar/schema/verdict.schema.json, program_verdict.schema.json) and as JUnit XML.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verifier/verdict/answer.hpp"
#include "verifier/verdict/subject.hpp"

namespace rmpl::verifier {

/// What is said of the last event of a run that an answer has; may be empty.
std::string end_of(const Subject& subject, const Property& property, const Witness& witness);

/// One answer for people, lines ended, in colour if asked for.
std::string to_text(const Subject& subject, const Question& question, const Answer& answer, bool color);
/// One answer about a plant for programs. Times are seconds.
nlohmann::ordered_json to_json(const Subject& subject, const Question& question, const Answer& answer);

/// Answers about a program, one a property, that were found together.
nlohmann::ordered_json to_json(const Subject& subject, const ProgramQuestion& question,
                               const std::vector<Answer>& answers);
/// A test case a property: a failure where it is violated, an error where it is undecided. All were decided together,
/// and the first case has the time.
std::string to_junit(const Subject& subject, const ProgramQuestion& question, const std::vector<Answer>& answers);

/// What a search has cost.
nlohmann::ordered_json statistics_of(const Progress& progress);

}  // namespace rmpl::verifier
