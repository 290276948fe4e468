// Networks in JANI (jani-model version 1; Budde, Dehnert, Hahn, Hartmanns, Junges, Turrini 2017), as a pta.
//
// An automaton a component and one for the rounds, which interleave: in a round the components have their turns, first
// to step, then to rest; `m` has the modes as it begins, `n` as it ends. No time passes in it. What is asked is the
// greatest probability to reach a target: 1 where it is reachable, else 0, since nothing is drawn.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "automata/controls.hpp"
#include "automata/json/parse.hpp"
#include "base/check.hpp"
#include "verifier/export/condition_text.hpp"
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
  Writer(const Plant& plant, const Network& network) : plant_(plant), network_(network) {}

  void run(std::ostream& out) {
    const Json reach{{"op", "Pmax"}, {"exp", {{"op", "F"}, {"exp", "reached"}}}};
    const Json property{
        {"name", "target"},
        {"expression", {{"op", "filter"}, {"fun", "max"}, {"values", reach}, {"states", {{"op", "initial"}}}}},
        {"comment", "1 where the target is reachable, or the forbidden formula can hold; else 0"}};
    Json model{{"jani-version", 1}, {"name", plant_.name}, {"type", "pta"}};
    model["metadata"] = {{"description", "1 unit of time is " + automata::format_seconds(network_.time.unit()) + " s"}};
    model["features"] = Json::array();
    model["variables"] = variables();
    model["properties"] = Json::array({property});
    Json automata = Json::array({rounds()});
    for (std::size_t c = 0; c < plant_.components.size(); ++c) automata.push_back(automaton_of(c));
    Json elements = Json::array();
    for (const Json& one : automata) elements.push_back(Json{{"automaton", one["name"]}});
    model["automata"] = std::move(automata);
    model["system"] = {{"elements", std::move(elements)}};
    out << model.dump() << '\n';
  }

 private:
  [[nodiscard]] std::size_t count() const { return plant_.components.size(); }

  Json variables() const {
    Json variables = Json::array();
    for (std::size_t c = 0; c < count(); ++c) {
      const automata::Component& component = plant_.components[c];
      const std::size_t last = component.modes.size() - 1;
      std::string modes = component.name + ":";
      for (const automata::Mode& mode : component.modes) modes += " " + mode.name;
      variables.push_back(integer(before(c), last, 0, modes));
      variables.push_back(integer(after(c), last, 0, ""));
      if (!network_.processes[c].clocked) continue;
      variables.push_back({{"name", clock(c)}, {"type", "clock"}, {"initial-value", 0}});
    }
    for (std::size_t u = 0; u < plant_.controls.size(); ++u) {
      const automata::Variable& variable = plant_.variables[plant_.controls[u].variable];
      variables.push_back(
          integer(control(u), variable.values.size() - 1, plant_.controls[u].idle.index(), variable.name));
    }
    variables.push_back(integer("turn", 2 * count() + 1, 0, ""));
    if (network_.faults > 0) variables.push_back(integer("faults", network_.faults, 0, ""));
    for (const char* name : {"commanded", "reached"}) {
      variables.push_back({{"name", name}, {"type", "bool"}, {"initial-value", false}});
    }
    return variables;
  }

  Json expression(const Formula& formula, std::string (*modes)(std::size_t)) const {
    switch (formula.kind) {
      case Formula::Kind::constant:
        return formula.truth;
      case Formula::Kind::member:
        return member(formula, modes);
      case Formula::Kind::negation:
        return {{"op", "¬"}, {"exp", expression(formula.operands.front(), modes)}};
      case Formula::Kind::conjunction:
      case Formula::Kind::disjunction: {
        const bool conjunction = formula.kind == Formula::Kind::conjunction;
        Json all;
        for (const Formula& operand : formula.operands) {
          Json part = expression(operand, modes);
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

  Json member(const Formula& formula, std::string (*modes)(std::size_t)) const {
    const auto component = plant_.component_of(formula.variable);
    const std::string name =
        component ? modes(component->index()) : control(*automata::control_of(plant_, formula.variable));
    const std::size_t all = plant_.variables[formula.variable].values.size();
    const auto& values = formula.values;
    if (values.size() > 1 && values.size() + 1 == all) {
      std::size_t missing = 0;
      while (missing < values.size() && values[missing].index() == missing) ++missing;
      return both("≠", name, missing);
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

  static std::string name_of(const automata::Component& component, std::size_t mode) {
    return identifier(component.modes[mode].name) + "_" + std::to_string(mode);
  }

  Json automaton_of(std::size_t c) const {
    const automata::Component& component = plant_.components[c];
    const ComponentProcess& process = network_.processes[c];
    Json locations = Json::array({location("start")});
    Json edges = Json::array();
    std::vector<bool> stops(component.modes.size(), false);
    for (const ProcessRest& rest : process.rests) {
      if (rest.urgent) stops[rest.mode.index()] = true;
    }
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const std::string name = name_of(component, m);
      locations.push_back(location(name));
      if (!stops[m]) continue;
      locations.push_back(location(name + "_stopped", false));
      edges.push_back(edge(name + "_stopped", name, turn_is(c), {}));
    }
    for (const ModeId mode : process.initial) {
      edges.push_back(edge("start", name_of(component, mode.index()), turn_is(c),
                           Json::array({assignment(after(c), mode.value), assignment("turn", c + 1)})));
    }
    for (const ProcessStep& step : process.steps) edges.push_back(edge_of(c, step));
    for (std::size_t r = 0; r < process.rests.size(); ++r) {
      const ProcessRest& rest = process.rests[r];
      const std::string mode = name_of(component, rest.mode.index());
      Json guard = turn_is(count() + 1 + c);
      conjoin(guard, expression(rest.where, after));
      conjoin(guard, condition(clock(c), rest.clock));
      const Json effect = Json::array({assignment(before(c), rest.mode.value), assignment("turn", count() + 2 + c)});
      if (rest.urgent) {
        edges.push_back(edge(mode, mode + "_stopped", guard, effect));
        continue;
      }
      const std::string name = mode + "_rests" + std::to_string(r);
      locations.push_back(location(name, condition(clock(c), {0, rest.clock.upper})));
      edges.push_back(edge(name, mode, turn_is(c), {}));
      edges.push_back(edge(mode, name, std::move(guard), effect));
    }
    return {{"name", "p" + std::to_string(c) + "_" + identifier(component.name)},
            {"locations", std::move(locations)},
            {"initial-locations", Json::array({"start"})},
            {"edges", std::move(edges)}};
  }

  Json edge_of(std::size_t c, const ProcessStep& step) const {
    const automata::Component& component = plant_.components[c];
    Json guard = turn_is(c);
    conjoin(guard, expression(step.where, before));
    conjoin(guard, condition(clock(c), step.clock));
    Json effect = Json::array({assignment(after(c), step.to.value), assignment("turn", c + 1)});
    if (step.fault) {
      conjoin(guard, both("<", "faults", network_.faults));
      effect.push_back(assignment("faults", both("+", "faults", 1)));
    }
    if (step.restarts) effect.push_back(assignment(clock(c), 0));
    return edge(name_of(component, step.from.index()), name_of(component, step.to.index()), std::move(guard),
                std::move(effect));
  }

  Json rounds() const {
    Json edges = Json::array();
    edges.push_back(edge("rest", "round", nullptr, Json::array({assignment("turn", 0)})));
    for (std::size_t u = 0; u < plant_.controls.size() && network_.commands != Commands::none; ++u) {
      const automata::Control& of = plant_.controls[u];
      Json guard = turn_is(0);
      conjoin(guard, both("=", control(u), of.idle.index()));
      if (network_.commands == Commands::one) conjoin(guard, Json{{"op", "¬"}, {"exp", "commanded"}});
      for (std::size_t v = 0; v < plant_.variables[of.variable].values.size(); ++v) {
        if (v == of.idle.index()) continue;
        edges.push_back(
            edge("round", "round", guard, Json::array({assignment(control(u), v), assignment("commanded", true)})));
      }
    }
    Json possible = turn_is(count());
    for (const Formula& one : network_.possible) conjoin(possible, expression(one, after));
    edges.push_back(edge("round", "round", std::move(possible), Json::array({assignment("turn", count() + 1)})));
    Json effect =
        Json::array({assignment("reached", expression(network_.target, after)), assignment("commanded", false)});
    for (std::size_t u = 0; u < plant_.controls.size(); ++u) {
      effect.push_back(assignment(control(u), plant_.controls[u].idle.index()));
    }
    edges.push_back(edge("round", "rest", turn_is(2 * count() + 1), std::move(effect)));
    return {{"name", "Rounds"},
            {"locations", Json::array({location("rest"), location("round", false)})},
            {"initial-locations", Json::array({"round"})},
            {"edges", std::move(edges)}};
  }

  const Plant& plant_;
  const Network& network_;
};

}  // namespace

void write_jani(std::ostream& out, const Plant& plant, const Network& network) { Writer(plant, network).run(out); }

}  // namespace rmpl::verifier
