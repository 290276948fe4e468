// Rounds: what may be marked tells what may hold, and that says what may be marked.
// SPDX-License-Identifier: MIT
#include "compiler/lint/model_program/reachable_markings.hpp"

#include <cstddef>
#include <optional>
#include <utility>

#include "compiler/lint/program/reachable_locations.hpp"

namespace rmpl::compiler {

using automata::GuardedArc;
using automata::LocationId;
using automata::ModelLocation;
using automata::ModelProgram;

namespace {

class FlowOf {
 public:
  FlowOf(const ModelProgram& program, ToldStores& stores, const std::vector<bool>& marked)
      : program_(program), stores_(stores), marked_(marked) {}

  Flow operator()() {
    Flow flow;
    for (const ModelLocation& location : program_.locations) {
      FlowLocation& made = flow.emplace_back();
      made.composite = location.composite;
      made.start = location.start;
      made.parent = location.parent;
      made.may_be_left = stores_.freedom(location.maintenance, marked_).may_fail;
      if (location.composite) add(location.arcs, made.draws.emplace_back());
      for (const automata::TransitionFunction& function : location.functions) draw(function, made);
    }
    for (std::size_t l = 0; l < flow.size(); ++l) leave(flow, l);
    return flow;
  }

 private:
  /// What counts as started takes its arcs in the same step, and what holds it may end.
  void draw(const automata::TransitionFunction& function, FlowLocation& from) {
    std::vector<FlowArc>& arcs = from.draws.emplace_back();
    add(function.arcs, arcs);
    for (const LocationId started : function.started) {
      from.passed.push_back(started);
      for (const automata::TransitionFunction& own : program_.locations[started.index()].functions) add(own.arcs, arcs);
    }
  }

  /// A composite ends where an arc leads out of it, too, whatever else goes on in what it leads to.
  void leave(Flow& flow, std::size_t source) {
    for (const auto& arcs : flow[source].draws) {
      for (const FlowArc& arc : arcs) {
        if (!arc.guard.may_hold) continue;
        leave(flow, source, arc.target);
        for (const LocationId passed : flow[source].passed) leave(flow, passed.index(), arc.target);
      }
    }
  }
  void leave(Flow& flow, std::size_t source, LocationId target) {
    for (auto out = program_.locations[source].parent; out; out = program_.locations[out->index()].parent) {
      if (is_within(target, *out)) return;
      flow[out->index()].may_be_left = true;
    }
  }
  /// Whether it is the composite, or something in it.
  [[nodiscard]] bool is_within(LocationId location, LocationId composite) const {
    for (std::optional<LocationId> at = location; at; at = program_.locations[at->index()].parent) {
      if (*at == composite) return true;
    }
    return false;
  }

  void add(const std::vector<GuardedArc>& from, std::vector<FlowArc>& arcs) {
    for (const GuardedArc& arc : from) {
      FlowArc& made = arcs.emplace_back(FlowArc{arc.target, {true, false}, nullptr});
      for (const automata::Condition& condition : arc.guard) {
        const Freedom free = stores_.freedom(condition, marked_);
        made.guard.may_hold = made.guard.may_hold && free.may_hold;
        made.guard.may_fail = made.guard.may_fail || free.may_fail;
      }
      if (arc.guard.size() == 1) made.condition = &arc.guard.front();
    }
  }

  const ModelProgram& program_;
  ToldStores& stores_;
  const std::vector<bool>& marked_;
};

}  // namespace

std::vector<bool> reachable_locations(const ModelProgram& program, ToldStores& stores) {
  std::vector<LocationId> starts;
  for (const automata::InitialDraw& draw : program.initial) {
    for (const automata::InitialBranch& branch : draw.branches) {
      starts.insert(starts.end(), branch.started.begin(), branch.started.end());
    }
  }
  std::vector<bool> marked(program.locations.size(), false);
  while (true) {
    std::vector<bool> more = ReachableLocations(FlowOf(program, stores, marked)(), starts).reached();
    if (more == marked) return marked;
    marked = std::move(more);
  }
}

std::vector<std::vector<LocationId>> started_together(const ModelProgram& program) {
  std::vector<std::vector<LocationId>> together(program.locations.size());
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    const ModelLocation* location = &program.locations[l];
    if (location->composite) continue;
    together[l].emplace_back(l);
    while (location->parent && location->start) {
      together[location->parent->index()].emplace_back(l);
      location = &program.locations[location->parent->index()];
    }
  }
  return together;
}

}  // namespace rmpl::compiler
