// Networks in JANI (jani-model version 1; Budde, Dehnert, Hahn, Hartmanns, Junges, Turrini 2017), as a pta.
//
// An automaton a component and one for the rounds, which interleave: in a round the components have their turns, first
// all of them to step, then those that may stop time to rest; `m` has the modes as it begins, `n` as it ends. No time
// passes in it. A component is in no location of its own for its mode, which is a variable, so that what it does in
// several modes is one edge. A long condition that occurs again, of other components, is a function. What is asked is
// the greatest probability to reach a target: 1 where it is reachable, else 0, since nothing is drawn.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "automata/controls.hpp"
#include "automata/json/parse.hpp"
#include "base/check.hpp"
#include "verifier/export/condition_text.hpp"
#include "verifier/export/round_process.hpp"
#include "verifier/export/write.hpp"

namespace rmpl::verifier {
namespace {

using automata::Formula;
using automata::Json;
using automata::ModeId;
using automata::Plant;
using automata::VariableId;

std::string clock(std::size_t component) { return "x" + std::to_string(component); }
std::string before(std::size_t component) { return "m" + std::to_string(component); }
std::string after(std::size_t component) { return "n" + std::to_string(component); }
std::string control(std::size_t number) { return "u" + std::to_string(number); }

Json both(const char* operation, Json left, Json right) {
  return {{"op", operation}, {"left", std::move(left)}, {"right", std::move(right)}};
}

/// A conjunction that grows; null where it has no part.
void conjoin(Json& all, Json part) {
  if (part == true) return;
  all = all.is_null() ? std::move(part) : both("∧", std::move(all), std::move(part));
}

Json condition(const std::string& clock, const Interval& range) {
  Json all;
  if (range.lower > 0) conjoin(all, both("≥", clock, range.lower));
  if (range.upper != unbounded) conjoin(all, both("≤", clock, range.upper));
  return all.is_null() ? Json(true) : all;
}

Json assignment(const std::string& variable, Json value) { return {{"ref", variable}, {"value", std::move(value)}}; }

Json integer(const std::string& name, std::size_t greatest, std::size_t initial, const std::string& comment) {
  Json json{{"name", name},
            {"type", {{"kind", "bounded"}, {"base", "int"}, {"lower-bound", 0}, {"upper-bound", greatest}}},
            {"initial-value", initial}};
  if (!comment.empty()) json["comment"] = comment;
  return json;
}

class Writer {
 public:
  Writer(const Plant& plant, const Network& network) : plant_(plant), network_(network) {
    for (std::size_t c = 0; c < count(); ++c) {
      processes_.push_back(in_rounds(plant, automata::ComponentId(c), network.processes[c]));
      if (!processes_.back().rests.empty()) ++resting_;
      for (const RoundStep& step : processes_.back().steps) ++times_[text_of(step.where)];
      for (const RoundRest& rest : processes_.back().rests) ++times_[text_of(rest.where)];
    }
  }

  void run(std::ostream& out) {
    const Json reach{{"op", "Pmax"}, {"exp", {{"op", "F"}, {"exp", "reached"}}}};
    const Json property{
        {"name", "target"},
        {"expression", {{"op", "filter"}, {"fun", "max"}, {"values", reach}, {"states", {{"op", "initial"}}}}},
        {"comment", "1 where the target is reachable, or the forbidden formula can hold; else 0"}};
    Json automata = Json::array({rounds()});
    std::size_t rest = count() + 1;  // the turn of the next component that rests
    for (std::size_t c = 0; c < count(); ++c) {
      automata.push_back(automaton_of(c, rest));
      if (!processes_[c].rests.empty()) ++rest;
    }
    Json elements = Json::array();
    for (const Json& one : automata) elements.push_back(Json{{"automaton", one["name"]}});
    Json model{{"jani-version", 1}, {"name", plant_.name}, {"type", "pta"}};
    model["metadata"] = {{"description", "1 unit of time is " + automata::format_seconds(network_.time.unit()) + " s"}};
    model["features"] = functions_.empty() ? Json::array() : Json::array({"functions"});
    model["variables"] = variables();
    model["properties"] = Json::array({property});
    if (!functions_.empty()) model["functions"] = functions_;
    model["automata"] = std::move(automata);
    model["system"] = {{"elements", std::move(elements)}};
    out << model.dump() << '\n';
  }

 private:
  [[nodiscard]] std::size_t count() const { return plant_.components.size(); }
  [[nodiscard]] std::size_t last_turn() const { return count() + 1 + resting_; }

  Json variables() const {
    Json variables = Json::array();
    for (std::size_t c = 0; c < count(); ++c) {
      const automata::Component& component = plant_.components[c];
      const std::size_t last = component.modes.size() - 1;
      std::string modes = component.name + ":";
      for (const automata::Mode& mode : component.modes) modes += " " + mode.name;
      variables.push_back(integer(before(c), last, 0, modes));
      variables.push_back(integer(after(c), last, network_.processes[c].initial.front().index(), ""));
      if (!network_.processes[c].clocked) continue;
      variables.push_back({{"name", clock(c)}, {"type", "clock"}, {"initial-value", 0}});
    }
    for (std::size_t u = 0; u < plant_.controls.size(); ++u) {
      const automata::Variable& variable = plant_.variables[plant_.controls[u].variable];
      variables.push_back(
          integer(control(u), variable.values.size() - 1, plant_.controls[u].idle.index(), variable.name));
    }
    variables.push_back(integer("turn", last_turn(), count(), ""));
    if (network_.faults > 0) variables.push_back(integer("faults", network_.faults, 0, ""));
    variables.push_back({{"name", "reached"}, {"type", "bool"}, {"initial-value", false}});
    return variables;
  }

  /// What a variable is called in a condition.
  using NameOf = std::function<std::string(VariableId)>;

  [[nodiscard]] NameOf names(std::string (*modes)(std::size_t)) const {
    return [this, modes](VariableId variable) {
      const auto component = plant_.component_of(variable);
      return component ? modes(component->index()) : control(*automata::control_of(plant_, variable));
    };
  }

  /// The condition with its variables numbered as they occur, which are told.
  Json general(const Formula& formula, std::vector<VariableId>& variables) const {
    return expression(formula, [&variables](VariableId variable) {
      const auto known = std::find(variables.begin(), variables.end(), variable);
      const auto number = known - variables.begin();
      if (known == variables.end()) variables.push_back(variable);
      return parameter(static_cast<std::size_t>(number));
    });
  }
  [[nodiscard]] std::string text_of(const Formula& formula) const {
    std::vector<VariableId> variables;
    return general(formula, variables).dump();
  }
  static std::string parameter(std::size_t number) { return "p" + std::to_string(number); }

  /// A condition of a step or rest: a call where it is long and is told elsewhere, too.
  Json condition_of(const Formula& formula, std::string (*modes)(std::size_t)) {
    constexpr std::size_t long_text = 300;
    std::vector<VariableId> variables;
    Json body = general(formula, variables);
    const std::string text = body.dump();
    if (text.size() < long_text || times_.at(text) == 1) return expression(formula, names(modes));
    const auto [known, fresh] = names_.emplace(text, "f" + std::to_string(functions_.size()));
    if (fresh) {
      Json parameters = Json::array();
      for (std::size_t p = 0; p < variables.size(); ++p) {
        parameters.push_back(Json{{"name", parameter(p)}, {"type", "int"}});
      }
      functions_.push_back(Json{
          {"name", known->second}, {"type", "bool"}, {"parameters", std::move(parameters)}, {"body", std::move(body)}});
    }
    Json arguments = Json::array();
    for (const VariableId variable : variables) arguments.push_back(names(modes)(variable));
    return {{"op", "call"}, {"function", known->second}, {"args", std::move(arguments)}};
  }

  Json expression(const Formula& formula, const NameOf& name_of) const {
    switch (formula.kind) {
      case Formula::Kind::constant:
        return formula.truth;
      case Formula::Kind::member:
        return member(formula, name_of);
      case Formula::Kind::negation:
        return {{"op", "¬"}, {"exp", expression(formula.operands.front(), name_of)}};
      case Formula::Kind::conjunction:
      case Formula::Kind::disjunction: {
        const bool conjunction = formula.kind == Formula::Kind::conjunction;
        Json all;
        for (const Formula& operand : formula.operands) {
          Json part = expression(operand, name_of);
          all = all.is_null() ? std::move(part) : both(conjunction ? "∧" : "∨", std::move(all), std::move(part));
        }
        return all;
      }
      default:
        break;
    }
    CHECK(false && "a condition is made of members");
    return {};
  }

  Json member(const Formula& formula, const NameOf& name_of) const {
    const std::string name = name_of(formula.variable);
    const std::size_t all = plant_.variables[formula.variable].values.size();
    const auto& values = formula.values;
    if (values.size() > 1 && values.size() + 1 == all) {
      std::size_t missing = 0;
      while (missing < values.size() && values[missing].index() == missing) ++missing;
      return both("≠", name, missing);
    }
    const std::size_t first = values.front().index();
    const std::size_t last = values.back().index();
    if (values.size() > 2 && last - first + 1 == values.size()) {
      Json range;
      if (first > 0) conjoin(range, both("≥", name, first));
      if (last + 1 < all) conjoin(range, both("≤", name, last));
      return range.is_null() ? Json(true) : range;
    }
    Json some;
    for (const automata::ValueId value : values) {
      Json one = both("=", name, value.index());
      some = some.is_null() ? std::move(one) : both("∨", std::move(some), std::move(one));
    }
    return some;
  }

  static Json location(const std::string& name, Json progress = true) {
    Json json{{"name", name}};
    if (progress != true) json["time-progress"] = {{"exp", std::move(progress)}};
    return json;
  }

  static Json edge(const std::string& from, const std::string& to, Json guard, Json assignments) {
    Json edge{{"location", from}};
    if (!guard.is_null()) edge["guard"] = {{"exp", std::move(guard)}};
    Json destination{{"location", to}};
    if (!assignments.empty()) destination["assignments"] = std::move(assignments);
    edge["destinations"] = Json::array({std::move(destination)});
    return edge;
  }

  static Json turn_is(std::size_t turn) { return both("=", "turn", turn); }

  /// `rest`: its turn to rest, if it has one.
  Json automaton_of(std::size_t c, std::size_t rest) {
    const automata::Component& component = plant_.components[c];
    const RoundProcess& process = processes_[c];
    Json locations = Json::array({location("acts")});
    Json edges = Json::array();
    for (const Units bound : process.bounds) {
      locations.push_back(location(waits(bound), condition(clock(c), {0, bound})));
      edges.push_back(edge(waits(bound), "acts", turn_is(c), {}));
    }
    if (process.stops) {
      locations.push_back(location("stops", false));
      edges.push_back(edge("stops", "acts", turn_is(c), {}));
    }
    if (process.renews) {
      locations.push_back(location("renews"));
      Json wakes = turn_is(c);
      conjoin(wakes, condition(clock(c), {1, unbounded}));
      edges.push_back(edge("renews", "acts", std::move(wakes), Json::array({assignment(clock(c), 0)})));
    }
    for (const RoundStep& step : process.steps) edges.push_back(edge_of(c, step));
    for (const RoundRest& one : process.rests) {
      Json guard = turn_is(rest);
      conjoin(guard, condition_of(one.where, after));
      conjoin(guard, condition(clock(c), one.clock));
      Json effect = Json::array({assignment("turn", rest + 1)});
      if (one.restarts) effect.push_back(assignment(clock(c), 0));
      edges.push_back(edge("acts", place_of(one), std::move(guard), std::move(effect)));
    }
    return {{"name", "p" + std::to_string(c) + "_" + identifier(component.name)},
            {"locations", std::move(locations)},
            {"initial-locations", Json::array({"acts"})},
            {"edges", std::move(edges)}};
  }

  static std::string place_of(const RoundRest& rest) {
    if (rest.urgent) return "stops";
    if (rest.restarts) return "renews";
    return rest.clock.upper == unbounded ? "acts" : waits(rest.clock.upper);
  }
  /// The location where time passes up to a bound.
  static std::string waits(Units bound) { return "waits_" + std::to_string(bound); }

  Json edge_of(std::size_t c, const RoundStep& step) {
    Json guard = turn_is(c);
    conjoin(guard, condition_of(step.where, before));
    conjoin(guard, condition(clock(c), step.clock));
    Json effect = Json::array(
        {assignment(after(c), step.to ? Json(step.to->value) : Json(before(c))), assignment("turn", c + 1)});
    if (step.fault) {
      conjoin(guard, both("<", "faults", network_.faults));
      effect.push_back(assignment("faults", both("+", "faults", 1)));
    }
    if (step.restarts) effect.push_back(assignment(clock(c), 0));
    return edge("acts", "acts", std::move(guard), std::move(effect));
  }

  /// Who has the turn, what is commanded, and what came of a round. It begins at the end of one, with the initial
  /// modes.
  Json rounds() const {
    Json locations = Json::array();
    Json edges = Json::array();
    std::vector<std::size_t> open;  // components with several initial modes
    for (std::size_t c = 0; c < count(); ++c) {
      if (network_.processes[c].initial.size() > 1) open.push_back(c);
    }
    for (std::size_t i = 0; i < open.size(); ++i) {
      locations.push_back(location(start(i), false));
      const std::string next = i + 1 < open.size() ? start(i + 1) : "round";
      for (const ModeId mode : network_.processes[open[i]].initial) {
        edges.push_back(edge(start(i), next, nullptr, Json::array({assignment(after(open[i]), mode.value)})));
      }
    }
    const std::string first = open.empty() ? "round" : start(0);
    const bool several = network_.commands == Commands::any;
    const Json begin = Json::array({assignment("turn", 0)});
    locations.push_back(location("rest"));
    locations.push_back(location("round", false));
    edges.push_back(edge("rest", several ? "choice" : "round", nullptr, begin));
    if (several) {
      locations.push_back(location("choice", false));
      edges.push_back(edge("choice", "round", nullptr, begin));
    }
    for (std::size_t u = 0; u < plant_.controls.size() && network_.commands != Commands::none; ++u) {
      const automata::Control& of = plant_.controls[u];
      for (std::size_t v = 0; v < plant_.variables[of.variable].values.size(); ++v) {
        if (v == of.idle.index()) continue;
        const Json command = assignment(control(u), v);
        edges.push_back(several
                            ? edge("choice", "choice", both("=", control(u), of.idle.index()), Json::array({command}))
                            : edge("rest", "round", nullptr, Json::array({command, begin.front()})));
      }
    }
    Json possible = turn_is(count());
    for (const Formula& one : network_.possible) conjoin(possible, expression(one, names(after)));
    edges.push_back(edge("round", "round", std::move(possible), Json::array({assignment("turn", count() + 1)})));
    Json effect = Json::array({assignment("reached", expression(network_.target, names(after)))});
    for (std::size_t c = 0; c < count(); ++c) effect.push_back(assignment(before(c), after(c)));
    for (std::size_t u = 0; u < plant_.controls.size(); ++u) {
      effect.push_back(assignment(control(u), plant_.controls[u].idle.index()));
    }
    edges.push_back(edge("round", "rest", turn_is(last_turn()), std::move(effect)));
    return {{"name", "Rounds"},
            {"locations", std::move(locations)},
            {"initial-locations", Json::array({first})},
            {"edges", std::move(edges)}};
  }

  static std::string start(std::size_t number) { return "start_" + std::to_string(number); }

  const Plant& plant_;
  const Network& network_;
  std::vector<RoundProcess> processes_;       ///< by component
  std::map<std::string, std::size_t> times_;  ///< how often a condition is told, by its text with numbered variables
  std::map<std::string, std::string> names_;  ///< of the functions, by the same
  Json functions_ = Json::array();
  std::size_t resting_ = 0;  ///< components that have a turn to rest
};

}  // namespace

void write_jani(std::ostream& out, const Plant& plant, const Network& network) { Writer(plant, network).run(out); }

}  // namespace rmpl::verifier
