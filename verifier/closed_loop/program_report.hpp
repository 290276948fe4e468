// Results about programs as text and as JSON (grammar/schema/program_verdict.schema.json).
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verifier/closed_loop/program_check.hpp"

namespace rmpl::verifier {

/// What the words of a report need.
struct ProgramSubject {
  const automata::Program& program;
  const automata::Plant& plant;
};

/// `EntrySequence on MarsLander`.
std::string title(const ProgramSubject& subject);

/// What a trace of a violation has come to, in words: the goals, the reason, the locations that wait.
std::string finding(const ProgramSubject& subject, const ProgramProperty& property, const LoopTrace& trace);

nlohmann::ordered_json to_json(const ProgramSubject& subject, const std::vector<ProgramProperty>& properties,
                               const ProgramResult& result);
std::string to_text(const ProgramSubject& subject, const std::vector<ProgramProperty>& properties,
                    const ProgramResult& result, bool statistics, bool color);

/// One row a fault: what may come of it.
nlohmann::ordered_json to_json(const ProgramSubject& subject, const FaultTable& table);
std::string to_text(const ProgramSubject& subject, const FaultTable& table, bool statistics);

/// `valve: open -> stuck`, or `none`.
std::string name_of(const ProgramSubject& subject, const FaultOutcome& row);
/// The run on which the mission is lost, or else the program does not end; empty where there is none.
std::string failure_text(const ProgramSubject& subject, const FaultOutcome& row);
/// What can come of a fault, in words, best first; `undecided` where a limit was hit.
std::vector<std::string> outcomes_of(const FaultOutcome& row);

}  // namespace rmpl::verifier
