// What came of a scenario, as text and as JSON (grammar/schema/scenario_result.schema.json).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/scenario.hpp"
#include "base/painter.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::runtime {

/// The heading before a story: what runs on what.
std::string heading(const automata::Document& document, const automata::Scenario& scenario, std::uint64_t seed,
                    base::Painter painter);

/// `met`, `FAILED` or `undecided`, of one width.
std::string verdict_word(Judgement::Verdict verdict, base::Painter painter);

/// What came of an expectation, when and why, with the evidence of that cycle; ends with a line feed.
std::string summary_line(const automata::Expectation& expectation, const Judgement& judgement, base::Painter painter);

/// How it ended, then a line for each expectation; ends with a line feed.
std::string summary(const automata::Scenario& scenario, const ScenarioResult& result, base::Painter painter);

/// One object, with no part that differs between two runs of one seed.
void write_result(JsonLine& json, const automata::Scenario& scenario, const ScenarioResult& result);

}  // namespace rmpl::runtime
