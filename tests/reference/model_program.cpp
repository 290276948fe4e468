// Enumeration, set by set.
// SPDX-License-Identifier: MIT
#include "tests/reference/model_program.hpp"

#include <algorithm>

#include "tests/reference/set_aside.hpp"

namespace rmpl::reference {

using automata::LocationId;
using automata::ModelLocation;
using automata::TransitionFunction;

namespace {

bool satisfies(const World& world, const automata::Observation& facts) {
  return std::all_of(facts.begin(), facts.end(),
                     [&](const automata::Assignment& fact) { return world[fact.variable.index()] == fact.value; });
}

bool holds_of(const automata::Condition& condition, const std::vector<const World*>& store) {
  const bool entailed =
      std::all_of(store.begin(), store.end(), [&](const World* world) { return holds(condition.constraint, *world); });
  return entailed == condition.entailed;
}

bool all_hold(const std::vector<automata::Condition>& guard, const std::vector<const World*>& store) {
  return std::all_of(guard.begin(), guard.end(), [&](const automata::Condition& c) { return holds_of(c, store); });
}

template <class Branch>
bool another_is_likelier(const Branch& branch, const std::vector<Branch>& all) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Branch& other) { return other.probability > branch.probability * (1 + 1e-9); });
}

double sum(const MarkingBelief& belief) {
  double result = 0;
  for (const auto& [marking, probability] : belief) result += probability;
  return result;
}

MarkingBelief normalised(MarkingBelief belief) {
  const double all = sum(belief);
  for (auto& [marking, probability] : belief) probability /= all;
  return belief;
}

MarkingBelief weighed(const ModelProgramStep& step, const MarkingBelief& belief,
                      const automata::Observation& observation) {
  MarkingBelief result;
  for (const auto& [marking, probability] : belief) {
    const double weight = probability * step.factor(marking, observation);
    if (weight > 0) result[marking] = weight;
  }
  return result;
}

MarkingBelief predicted(const ModelProgramStep& step, const MarkingBelief& belief, const Commands& commands) {
  MarkingBelief result;
  for (const auto& [marking, weight] : belief) {
    const MarkingBelief following = step.next(marking, commands);
    double possible = 0;
    for (const auto& [next, probability] : following) possible += probability;
    for (const auto& [next, probability] : following) result[next] += weight * probability / possible;
  }
  return result;
}

}  // namespace

ModelProgramStep::ModelProgramStep(const automata::ModelProgram& program) : program_(program) {
  std::vector<std::size_t> sizes;
  for (const automata::Variable& variable : program.variables) sizes.push_back(variable.values.size());
  for (const auto& tuple : tuples(sizes)) {
    World world;
    for (const std::size_t value : tuple) world.emplace_back(value);
    const bool permitted = std::all_of(program.constraints.begin(), program.constraints.end(),
                                       [&](const auto& told) { return holds(told.constraint, world); });
    if (permitted) all_.push_back(std::move(world));
  }
}

ModelProgramStep::Worlds ModelProgramStep::worlds(const MarkedSet& marking, const Commands& commands) const {
  Worlds result;
  for (const World& world : all_) {
    bool fits = satisfies(world, commands);
    for (const LocationId l : marking) fits = fits && holds(program_.locations[l.index()].told, world);
    if (fits) result.push_back(&world);
  }
  return result;
}

bool ModelProgramStep::inside(LocationId location, LocationId composite) const {
  for (auto parent = program_.locations[location.index()].parent; parent;
       parent = program_.locations[parent->index()].parent) {
    if (*parent == composite) return true;
  }
  return false;
}

void ModelProgramStep::mark(LocationId target, MarkedSet& marked) const {
  marked.insert(target);
  for (std::size_t l = 0; l < program_.locations.size(); ++l) {
    if (program_.locations[l].parent == target && program_.locations[l].start) mark(LocationId(l), marked);
  }
  for (std::size_t l = 0; l < program_.locations.size(); ++l) {
    if (inside(target, LocationId(l))) marked.insert(LocationId(l));
  }
}

MarkingBelief ModelProgramStep::initial() const {
  MarkingBelief result;
  for_each_start([&](const MarkedSet& marked, double probability, unsigned) { result[marked] += probability; });
  return result;
}

void ModelProgramStep::for_each_start(const Visit& visit) const {
  std::vector<std::size_t> sizes;
  for (const automata::InitialDraw& draw : program_.initial) sizes.push_back(draw.branches.size());
  for (const auto& tuple : tuples(sizes)) {
    MarkedSet marked;
    mark(LocationId(0), marked);
    double probability = 1;
    unsigned improbable = 0;
    for (std::size_t d = 0; d < tuple.size(); ++d) {
      const automata::InitialBranch& branch = program_.initial[d].branches[tuple[d]];
      probability *= branch.probability;
      if (another_is_likelier(branch, program_.initial[d].branches)) ++improbable;
      for (const LocationId l : branch.started) mark(l, marked);
    }
    if (probability > 0 && !worlds(marked, {}).empty()) visit(marked, probability, improbable);
  }
}

MarkedSet ModelProgramStep::taken(const MarkedSet& marking,
                                  const std::map<LocationId, const TransitionFunction*>& drawn,
                                  const Worlds& store) const {
  const auto& locations = program_.locations;
  const auto left = [&](LocationId location) {
    for (std::size_t l = 0; l < locations.size(); ++l) {
      if (inside(location, LocationId(l)) && !holds_of(locations[l].maintenance, store)) return true;
    }
    return false;
  };
  std::map<LocationId, const TransitionFunction*> functions;
  MarkedSet active = marking;
  for (const auto& [location, function] : drawn) {
    if (left(location)) continue;
    functions.emplace(location, function);
    for (const LocationId started : function->started) {
      for (std::size_t l = 0; l < locations.size(); ++l) {
        if (inside(started, LocationId(l))) active.insert(LocationId(l));
      }
      if (!left(started)) functions.emplace(started, &locations[started.index()].functions.front());
    }
  }
  std::vector<std::pair<LocationId, LocationId>> arcs;  // from, to
  const auto take = [&](LocationId from, const std::vector<automata::GuardedArc>& some) {
    for (const automata::GuardedArc& arc : some) {
      if (all_hold(arc.guard, store)) arcs.emplace_back(from, arc.target);
    }
  };
  for (const auto& [location, function] : functions) take(location, function->arcs);
  for (auto l = active.rbegin(); l != active.rend(); ++l) {
    if (!locations[l->index()].composite || left(*l)) continue;
    const bool goes_on = std::any_of(arcs.begin(), arcs.end(), [&](const auto& arc) {
      return inside(arc.first, *l) && (arc.second == *l || inside(arc.second, *l));
    });
    if (!goes_on) take(*l, locations[l->index()].arcs);
  }
  MarkedSet next;
  for (const auto& [from, to] : arcs) mark(to, next);
  return next;
}

MarkingBelief ModelProgramStep::next(const MarkedSet& marking, const Commands& commands) const {
  MarkingBelief result;
  for_each_next(marking, commands,
                [&](const MarkedSet& target, double probability, unsigned) { result[target] += probability; });
  return result;
}

void ModelProgramStep::for_each_next(const MarkedSet& marking, const Commands& commands, const Visit& visit) const {
  const Worlds store = worlds(marking, commands);
  if (store.empty()) return;
  std::vector<LocationId> primitive;
  std::vector<std::size_t> sizes;
  for (const LocationId l : marking) {
    if (program_.locations[l.index()].composite) continue;
    primitive.push_back(l);
    sizes.push_back(program_.locations[l.index()].functions.size());
  }
  for (const auto& tuple : tuples(sizes)) {
    std::map<LocationId, const TransitionFunction*> drawn;
    double probability = 1;
    unsigned improbable = 0;
    for (std::size_t i = 0; i < tuple.size(); ++i) {
      const TransitionFunction& function = program_.locations[primitive[i].index()].functions[tuple[i]];
      drawn[primitive[i]] = &function;
      probability *= function.probability;
      if (another_is_likelier(function, program_.locations[primitive[i].index()].functions)) ++improbable;
    }
    if (!(probability > 0)) continue;
    const MarkedSet target = taken(marking, drawn, store);
    if (!worlds(target, {}).empty()) visit(target, probability, improbable);
  }
}

bool ModelProgramStep::entails(const MarkedSet& marking, const automata::Formula& formula) const {
  const Worlds store = worlds(marking, {});
  return std::all_of(store.begin(), store.end(), [&](const World* world) { return holds(formula, *world); });
}

bool ModelProgramStep::allows(const MarkedSet& marking, const automata::Formula& formula) const {
  const Worlds store = worlds(marking, {});
  return std::any_of(store.begin(), store.end(), [&](const World* world) { return holds(formula, *world); });
}

double ModelProgramStep::factor(const MarkedSet& marking, const automata::Observation& observation) const {
  const Worlds store = worlds(marking, {});
  if (std::none_of(store.begin(), store.end(), [&](const World* world) { return satisfies(*world, observation); })) {
    return 0;
  }
  double result = 1;
  for (const automata::Assignment& reading : observation) {
    const bool entailed =
        std::all_of(store.begin(), store.end(), [&](const World* world) { return satisfies(*world, {reading}); });
    if (!entailed) result /= static_cast<double>(program_.variables[reading.variable].values.size());
  }
  return result;
}

std::map<automata::VariableId, automata::ValueId> ModelProgramStep::values(const MarkedSet& marking) const {
  const Worlds store = worlds(marking, {});
  std::map<automata::VariableId, automata::ValueId> result;
  for (std::size_t v = 0; v < program_.variables.size() && !store.empty(); ++v) {
    const automata::ValueId value = (*store.front())[v];
    if (std::all_of(store.begin(), store.end(), [&](const World* world) { return (*world)[v] == value; })) {
      result[automata::VariableId(v)] = value;
    }
  }
  return result;
}

namespace {

/// What is predicted, given what is read; `before`: what stays where nothing is predicted.
MarkingUpdate conditioned(const ModelProgramStep& step, const MarkingBelief& prior, const MarkingBelief& before,
                          const automata::Observation& observation) {
  const auto counted =
      set_aside(observation, [&](const automata::Observation& rest) { return !weighed(step, prior, rest).empty(); });
  if (!counted) return {before, observation, false};
  return {normalised(weighed(step, prior, counted->rest)), counted->aside, true};
}

}  // namespace

MarkingUpdate start(const ModelProgramStep& step, const automata::Observation& observation) {
  return conditioned(step, step.initial(), {}, observation);
}

MarkingUpdate update(const ModelProgramStep& step, const MarkingBelief& belief, const Commands& commands,
                     const automata::Observation& observation) {
  return conditioned(step, predicted(step, belief, commands), belief, observation);
}

MarkingUpdate beam(const ModelProgramStep& step, const MarkingBelief& belief, const Commands& commands,
                   const automata::Observation& observation, std::size_t k, bool& clear) {
  MarkingBelief prior = predicted(step, belief, commands);
  const auto counted =
      set_aside(observation, [&](const automata::Observation& rest) { return !weighed(step, prior, rest).empty(); });
  if (!counted) return {belief, observation, false};
  std::vector<std::pair<double, MarkedSet>> best;
  for (const auto& [marking, probability] : prior) {
    if (step.factor(marking, counted->rest) > 0) best.emplace_back(probability, marking);
  }
  std::stable_sort(best.begin(), best.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  clear = best.size() <= k || best[k - 1].first > best[k].first * (1 + 1e-9);
  if (best.size() > k) best.resize(k);
  MarkingBelief kept;
  for (const auto& [probability, marking] : best) kept[marking] = probability;
  return {normalised(weighed(step, kept, counted->rest)), counted->aside, true};
}

std::map<MarkingTrajectory, double> trajectories(const ModelProgramStep& step, const MarkingBelief& from,
                                                 const std::vector<Told>& updates) {
  std::map<MarkingTrajectory, double> result;
  for (const auto& [marking, probability] : from) result[{marking}] = probability;
  for (const auto& [commands, observation] : updates) {
    std::map<MarkingTrajectory, double> predictions;
    for (const auto& [trajectory, weight] : result) {
      for (const auto& [next, probability] : predicted(step, {{trajectory.back(), 1.0}}, commands)) {
        MarkingTrajectory longer = trajectory;
        longer.push_back(next);
        predictions[longer] = weight * probability;
      }
    }
    const auto weighed_by = [&, &predictions = predictions](const automata::Observation& readings) {
      std::map<MarkingTrajectory, double> posterior;
      for (const auto& [trajectory, probability] : predictions) {
        const double factor = step.factor(trajectory.back(), readings);
        if (factor > 0) posterior[trajectory] = probability * factor;
      }
      return posterior;
    };
    const auto counted =
        set_aside(observation, [&](const automata::Observation& rest) { return !weighed_by(rest).empty(); });
    if (counted) {
      result = weighed_by(counted->rest);
    } else {  // the belief stays
      std::map<MarkingTrajectory, double> standing;
      for (const auto& [trajectory, weight] : result) {
        MarkingTrajectory longer = trajectory;
        longer.push_back(trajectory.back());
        standing[longer] = weight;
      }
      result = std::move(standing);
    }
  }
  double all = 0;
  for (const auto& [trajectory, weight] : result) all += weight;
  for (auto& [trajectory, weight] : result) weight /= all;
  return result;
}

}  // namespace rmpl::reference
