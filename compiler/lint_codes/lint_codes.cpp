// What lint finds, by code.
// SPDX-License-Identifier: MIT
#include "compiler/lint_codes/lint_codes.hpp"

#include <algorithm>
#include <array>

#include "grammar/source/monitor_codes.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Severity;

namespace {

constexpr std::array codes = {
    // in plants
    LintCode{Code::duplicate_transition, LintGroup::suspicious, Severity::warning},  // found by the compiler
    LintCode{Code::unreachable_mode, LintGroup::impossible, Severity::warning},
    LintCode{Code::impossible_guard, LintGroup::impossible, Severity::warning},
    LintCode{Code::impossible_mode, LintGroup::impossible, Severity::warning},
    LintCode{Code::overlapping_guards, LintGroup::suspicious, Severity::warning},
    LintCode{Code::shadowed_transition, LintGroup::impossible, Severity::warning},
    LintCode{Code::no_initial_state, LintGroup::impossible, Severity::warning},
    LintCode{Code::impossible_initial_mode, LintGroup::impossible, Severity::warning},
    LintCode{Code::stuck_plant, LintGroup::impossible, Severity::warning},
    LintCode{Code::contradictory_interconnections, LintGroup::impossible, Severity::warning},
    LintCode{Code::impossible_command, LintGroup::impossible, Severity::warning},
    LintCode{Code::uncommanded_component, LintGroup::suspicious, Severity::note},
    LintCode{Code::undetectable_fault, LintGroup::observability, Severity::note},
    LintCode{Code::indistinguishable_faults, LintGroup::observability, Severity::note},
    LintCode{Code::indistinguishable_modes, LintGroup::observability, Severity::note},
    LintCode{Code::unconnected_input, LintGroup::suspicious, Severity::warning},
    LintCode{Code::unread_command, LintGroup::unused, Severity::warning},
    LintCode{Code::unused_attribute, LintGroup::unused, Severity::warning},
    LintCode{Code::timed_fault, LintGroup::timing, Severity::warning},
    LintCode{Code::late_guard, LintGroup::timing, Severity::warning},
    LintCode{Code::timer_goes_on, LintGroup::timing, Severity::note},
    LintCode{Code::unexplained_reading, LintGroup::observability, Severity::note},
    LintCode{Code::fault_blocks_goal, LintGroup::suspicious, Severity::note},
    LintCode{Code::idle_transition, LintGroup::suspicious, Severity::warning},
    LintCode{Code::unused_weight, LintGroup::suspicious, Severity::warning},
    LintCode{Code::unobserved_plant, LintGroup::observability, Severity::note},
    // in programs, scenarios, properties and monitors
    LintCode{Code::requirement_twice, LintGroup::suspicious, Severity::warning},   // found by the compiler
    LintCode{Code::scenario_after_end, LintGroup::impossible, Severity::warning},  // found by the compiler
    LintCode{Code::condition_never_holds, LintGroup::impossible, Severity::warning},
    LintCode{Code::condition_always_holds, LintGroup::impossible, Severity::warning},
    LintCode{Code::condition_out_of_reach, LintGroup::impossible, Severity::warning},
    LintCode{Code::contradicting_goals, LintGroup::suspicious, Severity::warning},
    LintCode{Code::step_never_reached, LintGroup::impossible, Severity::warning},
    LintCode{Code::goal_on_fault_mode, LintGroup::suspicious, Severity::warning},
    LintCode{Code::irreversible_goal, LintGroup::suspicious, Severity::note},
    LintCode{Code::clock_started_twice, LintGroup::suspicious, Severity::warning},
    LintCode{Code::restarted_wait, LintGroup::suspicious, Severity::warning},
    LintCode{Code::knowledge_out_of_reach, LintGroup::impossible, Severity::warning},
    LintCode{Code::unanswered_surprise, LintGroup::suspicious, Severity::note},
    LintCode{Code::unused_definition, LintGroup::unused, Severity::warning},
    LintCode{Code::unused_parameter, LintGroup::unused, Severity::warning},
    LintCode{Code::unused_clock, LintGroup::unused, Severity::warning},
    LintCode{Code::unused_domain, LintGroup::unused, Severity::warning},
    LintCode{Code::unused_type, LintGroup::unused, Severity::warning},
    LintCode{Code::finer_than_cycle, LintGroup::timing, Severity::warning},
    LintCode{Code::vacuous_property, LintGroup::impossible, Severity::warning},
    LintCode{Code::rule_never_fires, LintGroup::impossible, Severity::warning},
    LintCode{Code::unused_allowance, LintGroup::allowance, Severity::warning},
    LintCode{Code::allowance_without_reason, LintGroup::allowance, Severity::warning},
    LintCode{Code::vacuous_expectation, LintGroup::impossible, Severity::warning},
    LintCode{grammar::monitor_gap, LintGroup::suspicious, Severity::warning},  // these by the compiler, too
    LintCode{grammar::monitor_hysteresis, LintGroup::suspicious, Severity::warning},
    LintCode{grammar::sample_without_reading, LintGroup::suspicious, Severity::warning},
    LintCode{grammar::monitor_value_missing, LintGroup::suspicious, Severity::note},
    LintCode{Code::mixed_separators, LintGroup::style, Severity::warning},
};

}  // namespace

const char* to_string(LintGroup group) {
  switch (group) {
    case LintGroup::impossible:
      return "impossible";
    case LintGroup::suspicious:
      return "suspicious";
    case LintGroup::unused:
      return "unused";
    case LintGroup::observability:
      return "observability";
    case LintGroup::timing:
      return "timing";
    case LintGroup::style:
      return "style";
    case LintGroup::allowance:
      return "allowance";
  }
  return "";
}

std::vector<LintCode> lint_codes() {
  std::vector<LintCode> all(codes.begin(), codes.end());
  std::sort(all.begin(), all.end(), [](const LintCode& a, const LintCode& b) { return a.code < b.code; });
  return all;
}

const LintCode* find_lint_code(Code code) {
  const auto found = std::find_if(codes.begin(), codes.end(), [&](const LintCode& one) { return one.code == code; });
  return found == codes.end() ? nullptr : &*found;
}

}  // namespace rmpl::compiler
