// Every diagnostic has a code, stable for ever; this is the registry of them, which `rmplc explain` prints.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rmpl::grammar {

/// The number of a code: `RMPL0001` is 1. A number is never given to another meaning (105, 216 and 304 are used up).
/// Hundreds group by subject: 0 text, 1 names and values, 2 plants, 3 programs, 4 scenarios, 5 lint, 6 compiled
/// documents, 7 properties, 8 netlists.
enum class Code : std::uint16_t {
  // Text.
  syntax = 1,
  invalid_encoding = 2,
  nesting_too_deep = 3,
  number_out_of_range = 4,
  duration_out_of_range = 5,
  import_not_found = 6,
  import_cycle = 7,
  too_many_errors = 8,
  text_too_long = 9,
  too_large = 10,
  // Names and values.
  unknown_name = 100,
  duplicate_name = 101,
  value_outside_domain = 102,
  different_domains = 103,
  ambiguous_name = 104,
  wrong_kind_of_name = 106,
  requirement_without_name = 107,
  requirement_twice = 108,
  // Plants.
  probability_out_of_range = 200,
  probabilities_exceed_one = 201,
  reversed_bounds = 202,
  density_required = 203,
  fault_without_probability = 204,
  foreign_guard = 205,
  clock_in_plant = 206,
  no_plant = 207,
  several_plants = 208,
  no_instances = 209,
  instance_cycle = 210,
  no_modes = 211,
  weight_not_allowed = 212,
  density_out_of_range = 213,
  initial_distribution = 214,
  no_default = 215,
  negative_rate = 217,
  branch_distribution = 218,
  restart_not_allowed = 219,
  // Control programs.
  clock_never_started = 300,
  clock_not_allowed = 301,
  unguarded_recursion = 302,
  non_tail_recursion = 303,
  wrong_argument_count = 305,
  ambiguous_entry = 306,
  no_entry = 307,
  not_in_plant = 308,
  wrong_argument = 309,
  model_program = 310,
  contradictory_goal = 311,
  no_program = 312,
  several_programs = 313,
  knowledge_not_allowed = 322,
  goal_out_of_reach = 323,
  control_only = 324,
  // Model programs.
  mixed_program = 314,
  told_at_once = 315,
  choice_distribution = 316,
  clock_in_model = 317,
  too_much_software = 318,
  // Scenarios.
  scenario_missing_part = 400,
  scenario_repeated_part = 401,
  scenario_not_a_mode = 402,
  scenario_not_observable = 403,
  scenario_not_a_command = 404,
  scenario_after_end = 405,
  scenario_finer_than_cycle = 406,
  scenario_without_truth = 407,
  // Lint.
  duplicate_transition = 500,
  condition_never_holds = 501,
  condition_always_holds = 502,
  condition_out_of_reach = 503,
  contradicting_goals = 504,
  step_never_reached = 505,
  goal_on_fault_mode = 506,
  irreversible_goal = 507,
  clock_started_twice = 508,
  unused_definition = 509,
  unused_parameter = 510,
  unused_clock = 511,
  unused_domain = 512,
  unused_type = 513,
  mixed_separators = 514,
  finer_than_cycle = 515,
  vacuous_property = 516,
  rule_never_fires = 517,
  unused_allowance = 518,
  allowance_without_reason = 519,
  vacuous_expectation = 520,
  restarted_wait = 521,
  knowledge_out_of_reach = 560,
  unanswered_surprise = 561,
  // Lint of plants.
  unreachable_mode = 530,
  impossible_guard = 531,
  impossible_mode = 532,
  overlapping_guards = 533,
  shadowed_transition = 534,
  no_initial_state = 535,
  impossible_initial_mode = 536,
  stuck_plant = 537,
  contradictory_interconnections = 538,
  impossible_command = 539,
  uncommanded_component = 540,
  undetectable_fault = 541,
  indistinguishable_faults = 542,
  indistinguishable_modes = 543,
  unconnected_input = 544,
  unread_command = 545,
  unused_attribute = 546,
  timed_fault = 547,
  idle_transition = 548,
  unobserved_plant = 549,
  unused_weight = 550,
  late_guard = 551,
  timer_goes_on = 552,
  unexplained_reading = 553,
  fault_blocks_goal = 554,
  // Compiled documents.
  document_schema = 600,
  // Properties.
  property_without_claim = 700,
  property_repeated_part = 701,
  property_not_a_mode = 702,
  property_period = 703,
  no_property = 704,
  property_without_program = 705,
  property_commands_of_program = 706,
  // Netlists.
  netlist_syntax = 800,
  netlist_gate = 801,
  netlist_driver = 802,
  netlist_loop = 803,
};

/// What a code means. Examples are inputs that can be tried, in the notation that docs/development.md gives.
struct CodeInfo {
  Code code;
  std::string_view title;        ///< a few words, lower case
  std::string_view explanation;  ///< what it means and why it is wrong, in sentences
  std::string_view wrong;        ///< a shortest whole input that gives it, and nothing else
  std::string_view right;        ///< the same, put right: it gives nothing
};

/// `RMPL0001`.
std::string to_string(Code code);

/// The code that a text names: `RMPL0001`, `rmpl0001` or `1`. Nothing where there is no such code.
std::optional<Code> find_code(std::string_view text);

/// The entry of a code. Every enumerator has one.
const CodeInfo& info(Code code);

/// All entries, by number.
std::vector<CodeInfo> all_codes();

}  // namespace rmpl::grammar
