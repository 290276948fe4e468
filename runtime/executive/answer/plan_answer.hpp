// A plan from given modes to a goal, with what may come between.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/reconfigure/plan.hpp"
#include "runtime/reasoning/reconfigure/plan_risks.hpp"

namespace rmpl::runtime {

struct PlanAnswer {
  Plan plan;
  std::vector<PlanRisk> risks;     ///< what may come while the plan waits
  std::vector<TransitionOf> lost;  ///< by which the goal does not last
};

/// The most likely initial modes, ties to the first, with those that are given. Throws base::InputError where one that
/// is given is of no component.
automata::Modes modes_from(const automata::Plant& plant, const std::vector<automata::Assignment>& given);

/// Throws base::InputError where the plant cannot be in `modes`.
void expect_possible(automata::PlantStep& step, const automata::Modes& modes);

/// From modes that are possible. `one_step`: a single control action is to be enough. `cycle` is that of the executive,
/// 0 in dense time.
PlanAnswer answer_plan(automata::PlantStep& step, const automata::Modes& modes, const automata::Formula& goal,
                       bool one_step, automata::Ticks cycle);

/// One object.
void write(JsonLine& json, const automata::Plant& plant, const PlanAnswer& answer);

}  // namespace rmpl::runtime
