// Diagnoses of moments of model programs against every world.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "automata/step/marking_rules.hpp"
#include "base/product.hpp"
#include "runtime/reasoning/diagnose/model_diagnosis.hpp"
#include "runtime/reasoning/diagnose/threads.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate_model_program.hpp"
#include "tests/reference/model_program.hpp"

namespace rmpl::property {
namespace {

using automata::LocationId;
using automata::Marking;
using automata::ModelProgram;
using reference::World;

/// The worlds of the constraints for the whole model.
std::vector<World> worlds_of(const ModelProgram& program) {
  std::vector<std::size_t> sizes;
  for (std::size_t v = 0; v < program.variables.size(); ++v) {
    sizes.push_back(program.variables[automata::VariableId(v)].values.size());
  }
  std::vector<World> worlds;
  for (const auto& tuple : reference::tuples(sizes)) {
    World world;
    for (const std::size_t value : tuple) world.emplace_back(value);
    const bool permitted = std::all_of(program.constraints.begin(), program.constraints.end(),
                                       [&](const auto& told) { return reference::holds(told.constraint, world); });
    if (permitted) worlds.push_back(world);
  }
  return worlds;
}

bool tells(const ModelProgram& program, const Marking& marking, const World& world) {
  return std::all_of(marking.begin(), marking.end(),
                     [&](LocationId l) { return reference::holds(program.locations[l.index()].told, world); });
}

/// For every set of worlds in which what the marking tells holds: which conditions hold of it.
std::set<std::vector<bool>> valuations(const automata::MarkingRules& rules, const Marking& marking,
                                       const std::vector<World>& worlds) {
  std::set<std::vector<bool>> rows;  // of single worlds
  for (const World& world : worlds) {
    if (!tells(rules.program(), marking, world)) continue;
    std::vector<bool> row;
    for (const automata::Condition& c : rules.conditions()) row.push_back(reference::holds(c.constraint, world));
    rows.insert(row);
  }
  RC_PRE(rows.size() <= 10);
  const std::vector<std::vector<bool>> all(rows.begin(), rows.end());
  std::set<std::vector<bool>> result;
  for (std::size_t some = 1; some < std::size_t{1} << all.size(); ++some) {
    std::vector<bool> holds;
    for (std::size_t c = 0; c < rules.conditions().size(); ++c) {
      bool entailed = true;
      for (std::size_t r = 0; r < all.size(); ++r) entailed = entailed && ((some >> r & 1) == 0 || all[r][c]);
      holds.push_back(entailed == rules.conditions()[c].entailed);
    }
    result.insert(holds);
  }
  return result;
}

/// The best way to every marking from some, improved until nothing changes.
std::map<Marking, double> reached(const automata::MarkingRules& rules, const std::vector<World>& worlds,
                                  std::map<Marking, double> best) {
  std::map<Marking, std::set<std::vector<bool>>> known;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [marking, way] : std::map<Marking, double>(best)) {
      if (!known.contains(marking)) known[marking] = valuations(rules, marking, worlds);
      for (const std::vector<bool>& holds : known[marking]) {
        const auto moves = rules.moves(marking, [&](std::size_t c) { return holds[c]; });
        base::for_each_combination(moves.parts, [&, way = way](const std::vector<automata::MarkingOutcome>& outcomes) {
          Marking target = moves.certain;
          double there = way;
          for (const auto& outcome : outcomes) {
            target.insert(target.end(), outcome.marked.begin(), outcome.marked.end());
            if (outcome.improbable > 0) there *= outcome.probability;
          }
          std::sort(target.begin(), target.end());
          const bool possible = std::any_of(worlds.begin(), worlds.end(),
                                            [&](const World& world) { return tells(rules.program(), target, world); });
          if (!possible || best[target] >= there * (1 - 1e-12)) return;
          best[target] = there;
          changed = true;
        });
      }
    }
  }
  std::erase_if(best, [](const auto& one) { return one.second == 0; });
  return best;
}

/// The primitive locations of a thread.
std::set<LocationId> members_of(const runtime::JudgedThread& thread) {
  std::set<LocationId> members;
  for (const Marking& marking : thread.likely) members.insert(marking.begin(), marking.end());
  for (const auto& fault : thread.faults) members.insert(fault.marked.begin(), fault.marked.end());
  return members;
}

/// What the thread may mark at first, with the best way.
std::map<Marking, double> starts_of(const automata::MarkingRules& rules, const std::set<LocationId>& members,
                                    const std::vector<World>& worlds) {
  const auto touches = [&](const Marking& marking) {
    return std::any_of(marking.begin(), marking.end(), [&](LocationId l) { return members.contains(l); });
  };
  const automata::MarkingMoves initial = rules.initial();
  std::map<Marking, double> starts;
  std::vector<bool> own;
  for (const auto& outcomes : initial.parts) {
    own.push_back(std::any_of(outcomes.begin(), outcomes.end(), [&](const auto& o) { return touches(o.marked); }));
  }
  const auto possible = [&](const Marking& marking) {
    return std::any_of(worlds.begin(), worlds.end(),
                       [&](const World& world) { return tells(rules.program(), marking, world); });
  };
  base::for_each_combination(initial.parts, [&](const std::vector<automata::MarkingOutcome>& outcomes) {
    Marking marking = initial.certain;
    std::erase_if(marking, [&](LocationId l) { return !members.contains(l); });
    double way = 1;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      // What can never be marked is no member: drawn, it must not seem to mark nothing.
      if (!own[i]) continue;
      marking.insert(marking.end(), outcomes[i].marked.begin(), outcomes[i].marked.end());
      if (outcomes[i].improbable > 0) way *= outcomes[i].probability;
    }
    std::sort(marking.begin(), marking.end());
    if (possible(marking)) starts[marking] = std::max(starts[marking], way);
  });
  return starts;
}

RC_GTEST_PROP(DiagnoseModel, ThreadsComeToAllTheirMarkings, ()) {
  const ModelProgram program = (*model_programs(4)).program;
  const automata::MarkingRules rules(program);
  const std::vector<World> worlds = worlds_of(program);
  const auto threads = runtime::judged_threads(program);
  // By what a thread can mark the test knows it: a draw before time 0 that marks nothing possible could be anybody's.
  for (const auto& outcomes : rules.initial().parts) {
    RC_PRE(std::any_of(threads.begin(), threads.end(), [&](const runtime::JudgedThread& thread) {
      const std::set<LocationId> members = members_of(thread);
      return std::any_of(outcomes.begin(), outcomes.end(), [&](const auto& outcome) {
        return std::any_of(outcome.marked.begin(), outcome.marked.end(),
                           [&](LocationId l) { return members.contains(l); });
      });
    }));
  }
  for (const runtime::JudgedThread& thread : threads) {
    std::map<Marking, double> found;
    for (const Marking& marking : thread.likely) found[marking] = 1;
    for (const auto& fault : thread.faults) found[fault.marked] = fault.probability;
    if (found.empty()) continue;  // no start is possible, and nothing tells what is its own
    const std::map<Marking, double> all = reached(rules, worlds, starts_of(rules, members_of(thread), worlds));
    RC_ASSERT(all.size() == found.size());
    for (const auto& [marking, way] : found) {
      RC_ASSERT(all.contains(marking));
      RC_ASSERT(std::abs(all.at(marking) - way) < 1e-12);
    }
  }
}

/// What really happens, step by step, is among what the threads may mark; without improbable draws, what they likely
/// do.
RC_GTEST_PROP(DiagnoseModel, RunsStayWithinTheThreads, ()) {
  const ModelProgram program = (*model_programs(4)).program;
  const reference::ModelProgramStep step(program);
  const auto threads = runtime::judged_threads(program);
  const auto check = [&](const reference::MarkedSet& marked, bool likely) {
    Marking left;
    for (const LocationId l : marked) {
      if (!program.locations[l.index()].composite) left.push_back(l);
    }
    for (const runtime::JudgedThread& thread : threads) {
      const std::set<LocationId> members = members_of(thread);
      Marking mine;
      for (const LocationId l : left) {
        if (members.contains(l)) mine.push_back(l);
      }
      const bool is_likely = std::find(thread.likely.begin(), thread.likely.end(), mine) != thread.likely.end();
      const bool is_fault = std::any_of(thread.faults.begin(), thread.faults.end(),
                                        [&](const auto& fault) { return fault.marked == mine; });
      RC_ASSERT(is_likely || (is_fault && !likely));
      std::erase_if(left, [&](LocationId l) { return members.contains(l); });
    }
    RC_ASSERT(left.empty());
  };
  std::map<reference::MarkedSet, bool> now;
  step.for_each_start([&](const reference::MarkedSet& marked, double probability, unsigned improbable) {
    if (probability > 0 && step.allows(marked, automata::constant(true))) now[marked] |= improbable == 0;
  });
  for (const ModelInput& input : *model_inputs(program, 3)) {
    reference::Commands commands;
    for (std::size_t c = 0; c < input.command.size(); ++c) {
      if (input.command[c]) commands.push_back({program.controls[c].variable, *input.command[c]});
    }
    std::map<reference::MarkedSet, bool> next;
    for (const auto& [marked, likely] : now) {
      check(marked, likely);
      step.for_each_next(marked, commands,
                         [&, likely = likely](const reference::MarkedSet& to, double probability, unsigned improbable) {
                           if (probability > 0 && step.allows(to, automata::constant(true)))
                             next[to] |= likely && improbable == 0;
                         });
    }
    now = std::move(next);
  }
}

RC_GTEST_PROP(DiagnoseModel, LeadingOnesAreTheMostProbable, ()) {
  const ModelProgram program = (*model_programs(4)).program;
  const auto threads = runtime::judged_threads(program);
  automata::Observation seen;
  for (const ModelInput& input : *model_inputs(program, 1)) seen = input.observation;
  const std::vector<World> worlds = worlds_of(program);
  // Every choice of one fault or none for each thread, in every world.
  std::vector<std::vector<std::size_t>> statuses;
  for (const auto& thread : threads) {
    auto& all = statuses.emplace_back();
    for (std::size_t s = 0; s <= thread.faults.size(); ++s) all.push_back(s);
  }
  std::map<std::vector<Marking>, double> expected;
  base::for_each_combination(statuses, [&](const std::vector<std::size_t>& taken) {
    const bool consistent = std::any_of(worlds.begin(), worlds.end(), [&](const World& world) {
      for (const automata::Assignment& reading : seen) {
        if (world[reading.variable.index()] != reading.value) return false;
      }
      for (std::size_t t = 0; t < threads.size(); ++t) {
        const auto told = [&](const Marking& marking) { return tells(program, marking, world); };
        const bool holds = taken[t] == 0 ? std::any_of(threads[t].likely.begin(), threads[t].likely.end(), told)
                                         : told(threads[t].faults[taken[t] - 1].marked);
        if (!holds) return false;
      }
      return true;
    });
    if (!consistent) return;
    double probability = 1;
    std::vector<Marking> faults;
    for (std::size_t t = 0; t < threads.size(); ++t) {
      if (taken[t] == 0) continue;
      faults.push_back(threads[t].faults[taken[t] - 1].marked);
      probability *= threads[t].faults[taken[t] - 1].probability;
    }
    expected.emplace(faults, probability);
  });
  std::vector<double> best;
  for (const auto& [faults, probability] : expected) best.push_back(probability);
  std::sort(best.rbegin(), best.rend());
  const std::size_t k = up_to(1, 6);
  const auto found = runtime::diagnose(program, seen, k).diagnoses;
  RC_ASSERT(found.size() == std::min(k, best.size()));
  for (std::size_t i = 0; i < found.size(); ++i) {
    RC_ASSERT(expected.contains(found[i].faults));
    RC_ASSERT(std::abs(expected.at(found[i].faults) - found[i].probability) < 1e-12);
    RC_ASSERT(std::abs(best[i] - found[i].probability) < 1e-9 * best[i]);
  }
}

}  // namespace
}  // namespace rmpl::property
