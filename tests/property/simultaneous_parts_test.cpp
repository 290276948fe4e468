// What is tried beside a search as one, against it: parts that have nothing to do with each other, and plans.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/step.hpp"
#include "verifier/check/check.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;

Ticks some_time() { return Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 9))); }

/// Two like halves that are wanted in unlike modes, at one time, mostly.
verifier::Reachability draw_target(const automata::Plant& plant) {
  std::vector<automata::Formula> parts;
  for (const automata::Assignment& mode : reference::assumptions_of(plant, *modes_of(plant))) {
    if (chance(80)) parts.push_back(automata::is(mode.variable, mode.value));
  }
  if (parts.empty() || chance(20)) parts.push_back(*formulas(plant.variables, all_variables(plant), 1));
  verifier::Reachability target{automata::conjunction(parts), {}, chance(30)};
  if (chance(30)) target.window.not_before = some_time();
  if (chance(30)) target.window.by = some_time();
  return target;
}

RC_GTEST_PROP(Parts, MeetAsIfSearchedAsOne, ()) {
  Shape half{.max_components = 2, .max_modes = 4, .max_attributes = 3};
  half.tangled = chance(30);
  const Model model = *mirrored(half);
  const verifier::Reachability target = draw_target(model.plant);
  verifier::CheckOptions options;
  options.faults = static_cast<unsigned>(up_to(0, 2));
  options.entailed = chance(20);
  options.merge = chance(80);
  if (chance(30)) options.commands = pick<verifier::Commands>({verifier::Commands::none, verifier::Commands::any});
  verifier::Slices slices(model.plant);
  options.states_as_one = std::numeric_limits<std::size_t>::max() / 2;
  const verifier::Answer as_one = verifier::check(slices, target, options, {});
  options.states_as_one = 0;
  const verifier::Answer apart = verifier::check(slices, target, options, {});
  RC_CLASSIFY(as_one.witness.has_value());
  RC_LOG() << to_text(target.target, model.plant.variables) << "\nfastest " << target.fastest << ", faults "
           << *options.faults << ", as one: " << static_cast<int>(as_one.verdict) << ", cut off "
           << as_one.cut_off.stuck << as_one.cut_off.still << ", apart: " << static_cast<int>(apart.verdict)
           << ", cut off " << apart.cut_off.stuck << apart.cut_off.still << '\n';
  RC_ASSERT(apart.witness.has_value() == as_one.witness.has_value());
  // Where the one part can never be as wanted, it does not matter where the other gets stuck, or time stands still in
  // it.
  RC_ASSERT(as_one.cut_off.stuck || !apart.cut_off.stuck);
  RC_ASSERT(apart.verdict == as_one.verdict || as_one.cut_off.still);
  if (target.fastest && as_one.witness) {
    RC_ASSERT(apart.witness->events.back().time == as_one.witness->events.back().time);
  }
}

/// Whether there is a run does not depend on when a plan is tried, and one that a plan leads along is no shorter.
RC_GTEST_PROP(Plans, StandInForASearch, ()) {
  Shape shape{.max_components = 3, .max_modes = 3, .max_attributes = 3};
  shape.commanded = chance(70);
  const Model model = *models(shape);
  verifier::Reachability target = draw_target(model.plant);
  if (chance(80)) target = {target.target, {}, false};
  verifier::CheckOptions options;
  options.faults = static_cast<unsigned>(up_to(0, 1));
  options.fewest_faults = chance(20);
  if (chance(30)) options.period = Ticks::of_seconds(1);
  verifier::Slices slices(model.plant);
  const verifier::Answer searched = verifier::check(slices, target, options, {});
  options.states_before_plan = options.components_for_plan = 0;
  const verifier::Answer planned = verifier::check(slices, target, options, {});
  RC_CLASSIFY(planned.limit == verifier::Limit::plan);
  RC_LOG() << to_text(target.target, model.plant.variables) << ": " << static_cast<int>(searched.verdict) << ", "
           << static_cast<int>(planned.verdict) << '\n';
  RC_ASSERT(planned.verdict == searched.verdict);
  RC_ASSERT(planned.fewest_faults == searched.fewest_faults);
  // What waits, or restarts a clock, is no step.
  const auto changes = [](const verifier::Witness& witness) {
    std::size_t count = 0;
    for (std::size_t e = 1; e < witness.events.size(); ++e) {
      count += witness.events[e].modes != witness.events[e - 1].modes ? 1 : 0;
    }
    return count;
  };
  if (searched.witness) RC_ASSERT(changes(*planned.witness) >= changes(*searched.witness));
}

}  // namespace
}  // namespace rmpl::property
