// Codes of the registry: scenarios.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{Code::scenario_missing_part, "scenario lacks a part", "A scenario names a program and a plant.",
             R"(scenario "s" { program "p.rmpl"; })", R"(scenario "s" { program "p.rmpl"; plant "p.tcca"; })"},
    CodeInfo{
        Code::scenario_repeated_part, "scenario says a thing twice",
        "Program, plant, cycle, duration and seed stand once in a scenario; a mode or an initial truth is given once.",
        "seed 1;\nseed 2;", "seed 1;"},
    CodeInfo{Code::scenario_not_a_mode, "not a mode",
             "`truth` and `fault` speak of components and their modes: the real ones of the simulated plant.",
             "truth engine.thrust = full;", "truth engine = firing;"},
    CodeInfo{Code::scenario_not_observable, "not an observable variable",
             "`observe` in a scenario overrides a sensor: a variable that the plant declares with `observe`.",
             "at 10 s observe engine = off;", "at 10 s observe engine.temp = low;"},
    CodeInfo{Code::scenario_not_a_command, "not a control variable",
             "`when command` waits for a command: a constraint over the plant's control variables.",
             "when command engine = firing observe engine.temp = nominal;",
             "when command engine.cmd = fire observe engine.temp = nominal;"},
    CodeInfo{Code::scenario_after_end, "after the end of the scenario",
             "The event or expectation lies behind the scenario's duration: it would never come about.",
             "duration 1 min;\nat 100 s fault engine = failed;", "duration 2 min;\nat 100 s fault engine = failed;"},
    CodeInfo{Code::scenario_finer_than_cycle, "cycle out of range", "The executive's cycle is longer than 0.",
             "cycle 0 s;", "cycle 0.5 s;"},
    CodeInfo{Code::scenario_without_truth, "no truth to speak of",
             "A plant that follows the rules only has readings, and no modes behind them: nothing can fail in it, and "
             "`truth` and `expect truth` have nothing to speak of.",
             "plant \"p.tcca\" rules only;\nat 10 s fault engine = failed;",
             "plant \"p.tcca\" rules only;\nat 10 s observe engine.thrust = zero;"},
};

}  // namespace

std::span<const CodeInfo> scenario_codes() { return table; }

}  // namespace rmpl::grammar
