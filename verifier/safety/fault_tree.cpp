// Fault trees, from diagrams or from searches.
// SPDX-License-Identifier: MIT
#include "verifier/safety/fault_tree.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "verifier/check/check.hpp"
#include "verifier/safety/static_tree.hpp"

namespace rmpl::verifier {

namespace {

/// More sets than this are listed only where they are asked for: they are counted anyhow.
constexpr std::size_t all_listed = 100'000;

/// By variable of the diagrams what is given by event.
template <class Value>
std::vector<Value> by_variable(const StaticTree& tree, const std::vector<Value>& by_event) {
  std::vector<Value> result(by_event.size());
  for (std::size_t e = 0; e < by_event.size(); ++e) result[tree.variables[e]] = by_event[e];
  return result;
}

/// How likely each event is by then.
std::vector<Enclosure> chances_of(const StaticTree& tree, std::optional<automata::Ticks> within,
                                  std::optional<automata::Ticks> period) {
  std::vector<Enclosure> result;
  result.reserve(tree.events.size());
  for (const BasicEvent& event : tree.events) result.push_back(chance_of(event, within, period));
  return result;
}

double middle(const Enclosure& value) { return static_cast<double>((value.lower + value.upper) / 2); }

void weigh(FaultTree& tree, const StaticTree& plant, Diagrams& diagrams, const FaultTreeQuestion& question) {
  const std::vector<Enclosure> chances = chances_of(plant, question.within, question.period);
  std::vector<double> doubles;
  for (const Enclosure& chance : chances) doubles.push_back(middle(chance));
  tree.top = diagrams.probability(plant.top, by_variable(plant, chances));
  const double top = middle(*tree.top);
  const std::vector<double> importance = diagrams.birnbaum(plant.top, by_variable(plant, doubles));
  for (std::size_t e = 0; e < tree.events.size(); ++e) {
    const double birnbaum = importance[plant.variables[e]];
    tree.events[e].probability = chances[e];
    if (top == 0) continue;
    const double without = std::max(0.0, top - doubles[e] * birnbaum);
    const double with = top + (1 - doubles[e]) * birnbaum;
    TreeEvent::Importance own{birnbaum, (top - without) / top, with / top, std::nullopt};
    if (without > 0) own.reduction = top / without;
    tree.events[e].importance = own;
  }
}

FaultTree of_diagrams(const StaticTree& plant, Diagrams& diagrams, const FaultTreeQuestion& question) {
  FaultTree tree;
  tree.exact = true;
  tree.monotone = plant.monotone;
  for (const BasicEvent& event : plant.events) {
    tree.events.push_back({event.fault, event.weight, event.once, std::nullopt, std::nullopt});
  }
  const bool repeated = std::any_of(plant.events.begin(), plant.events.end(), [](const BasicEvent& event) {
    return !event.once && event.weight.kind == automata::Weight::Kind::probability;
  });
  if (question.within && !question.period && repeated) {
    throw base::InputError(
        "dense time: a fault has a probability per step where time passes; expected a period in --time, or no "
        "--within");
  }
  const NodeId sets = diagrams.minimal_sets(plant.top);
  tree.by_order = diagrams.sizes(sets);
  if (question.within) weigh(tree, plant, diagrams, question);
  std::vector<double> weights;
  for (const TreeEvent& event : tree.events) weights.push_back(event.probability ? middle(*event.probability) : 0.5);
  std::vector<std::size_t> events(plant.events.size());
  for (std::size_t e = 0; e < events.size(); ++e) events[plant.variables[e]] = e;
  auto likeliest = diagrams.likeliest(sets, by_variable(plant, weights), question.listed.value_or(all_listed));
  for (auto& [variables, probability] : likeliest) {
    TreeSet& set = tree.sets.emplace_back();
    for (const std::uint32_t variable : variables) set.events.push_back(events[variable]);
    std::sort(set.events.begin(), set.events.end());
    if (!question.within) continue;
    Enclosure all = certain();
    for (const std::size_t e : set.events) all = all * *tree.events[e].probability;
    set.probability = all;
  }
  return tree;
}

/// The one way in which a component goes into a fault mode, if it hangs on nothing and every nominal mode has it alike.
std::optional<automata::Weight> own_weight(const automata::Component& component, automata::ModeId mode) {
  std::optional<automata::Weight> weight;
  std::vector<bool> leaves(component.modes.size(), false);
  for (const automata::Transition& t : component.transitions) {
    if (t.to != mode || component.modes[t.from.index()].fault) continue;
    if (t.timing || !t.guard.is_true() || t.weight.kind != automata::Weight::Kind::rate) return std::nullopt;
    if (weight && *weight != t.weight) return std::nullopt;
    weight = t.weight;
    leaves[t.from.index()] = true;
  }
  for (std::size_t m = 0; m < leaves.size(); ++m) {
    if (!component.modes[m].fault && !leaves[m]) return std::nullopt;
  }
  return weight;
}

FaultTree of_search(automata::PlantStep& step, const FaultTreeQuestion& question, const Limits& limits) {
  Slices slices(step.plant());
  CheckOptions options;
  options.period = question.period;
  options.faults = question.order;
  options.commands = question.commands;
  options.cut_sets = true;
  options.from = question.from;
  const Answer answer = check(slices, Reachability{question.top, {}, false}, options, limits);
  FaultTree tree;
  tree.limit = answer.limit;
  tree.progress = answer.progress;
  std::map<Fault, std::size_t> positions;
  for (const CutSet& cut : answer.cut_sets) {
    TreeSet& set = tree.sets.emplace_back();
    for (const Fault& fault : cut.faults) {
      const auto [at, fresh] = positions.try_emplace(fault, tree.events.size());
      if (fresh) {
        const auto weight = own_weight(step.plant()[fault.component], fault.mode);
        TreeEvent& event = tree.events.emplace_back(TreeEvent{fault, {}, false, std::nullopt, std::nullopt});
        if (weight) event.weight = *weight;
        if (weight && question.within) {
          event.probability = chance_of({fault, {}, *weight}, question.within, question.period);
        }
      }
      set.events.push_back(at->second);
    }
    std::sort(set.events.begin(), set.events.end());
    if (tree.by_order.size() <= set.events.size()) tree.by_order.resize(set.events.size() + 1, 0);
    tree.by_order[set.events.size()] += 1;
    const bool weighed = question.within && std::all_of(set.events.begin(), set.events.end(), [&](std::size_t e) {
                           return tree.events[e].probability.has_value();
                         });
    if (!weighed) continue;
    Enclosure all = certain();
    for (const std::size_t e : set.events) all = all * *tree.events[e].probability;
    set.probability = all;
  }
  if (question.listed) {
    std::stable_sort(tree.sets.begin(), tree.sets.end(), [](const TreeSet& a, const TreeSet& b) {
      return (a.probability ? a.probability->upper : 0) > (b.probability ? b.probability->upper : 0);
    });
    if (tree.sets.size() > *question.listed) tree.sets.resize(*question.listed);
  }
  return tree;
}

}  // namespace

std::optional<ProbabilityAnswer> static_probability(automata::PlantStep& step, const ProbabilityQuestion& question,
                                                    const Limits& limits) {
  if (question.faults || question.mean_time || question.points > 0 || !question.from.empty()) return std::nullopt;
  Meter meter(limits);
  ProbabilityAnswer answer;
  try {
    Diagrams diagrams(meter);
    const auto tree = static_tree(step.plant(), question.target, diagrams);
    if (!tree) return std::nullopt;
    // What has come about stays where more failures never undo it, or nothing ever changes.
    const bool fixed =
        std::all_of(tree->events.begin(), tree->events.end(), [](const BasicEvent& event) { return event.from_start; });
    const bool repeated = std::any_of(tree->events.begin(), tree->events.end(), [](const BasicEvent& event) {
      return !event.once && event.weight.kind == automata::Weight::Kind::probability;
    });
    if ((!tree->monotone && !fixed) || (repeated && !question.period)) return std::nullopt;
    Likelihood one;
    one.probability =
        diagrams.probability(tree->top, by_variable(*tree, chances_of(*tree, question.within, question.period)));
    answer.precise = is_within(one.probability, static_cast<Real>(question.precision));
    std::size_t actions = 0;
    for_each_action(step.plant(), question.commands, [&](const automata::ControlAction&) { ++actions; });
    if (actions == 1) {
      answer.only = one;
    } else {
      if (question.least) answer.least = one;
      if (question.greatest) answer.greatest = one;
    }
  } catch (const LimitReached& reached) {
    answer = {};
    answer.limit = reached.limit;
  }
  answer.progress = meter.progress();
  return answer;
}

FaultTree fault_tree(automata::PlantStep& step, const FaultTreeQuestion& question, const Limits& limits) {
  Meter meter(limits);
  try {
    Diagrams diagrams(meter);
    if (question.from.empty()) {
      if (const auto plant = static_tree(step.plant(), question.top, diagrams)) {
        FaultTree tree = of_diagrams(*plant, diagrams, question);
        tree.progress = meter.progress();
        return tree;
      }
    }
  } catch (const LimitReached& reached) {
    FaultTree tree;
    tree.limit = reached.limit;
    tree.progress = meter.progress();
    return tree;
  }
  return of_search(step, question, remaining(limits, meter.progress()));
}

}  // namespace rmpl::verifier
