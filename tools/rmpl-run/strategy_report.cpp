// A strategy as text, as JSON and in DOT.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/strategy_report.hpp"

#include <algorithm>
#include <vector>

#include "automata/assignment_text.hpp"
#include "automata/state.hpp"
#include "compiler/diagram/dot.hpp"

namespace rmpl::tools {

using automata::Modes;
using automata::Plant;
using compiler::dot_value;
using runtime::GameDecision;
using runtime::JsonLine;
using runtime::Rank;
using runtime::Strategy;

namespace {

std::string command_of(const Plant& plant, const Strategy::Node& node) {
  return to_text(plant.variables, automata::commanded(plant, node.action));
}

/// What is sent, in words.
std::string doing(const Plant& plant, const Strategy::Node& node) {
  std::string command = command_of(plant, node);
  if (node.purpose == GameDecision::Purpose::none) return "no plan" + (command.empty() ? "" : ": " + command);
  if (!command.empty()) return command;
  return node.goal ? "rest" : "wait";
}

std::string_view outcome_of(const Strategy::Node& node, const Plant& plant) {
  if (node.purpose == GameDecision::Purpose::none) return "no-plan";
  return node.goal && automata::commanded(plant, node.action).empty() ? "nothing-to-do" : "plan";
}

/// The components whose modes differ somewhere in the strategy.
std::vector<bool> moving(const Strategy& strategy) {
  std::vector<bool> result(strategy.nodes.front().modes.size());
  for (const Strategy::Node& node : strategy.nodes) {
    for (std::size_t c = 0; c < result.size(); ++c)
      result[c] = result[c] || node.modes[c] != strategy.nodes.front().modes[c];
  }
  return result;
}

std::string modes_text(const Plant& plant, const Modes& modes, const std::vector<bool>& shown) {
  std::string text;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (!shown[c]) continue;
    const automata::Component& component = plant.components[c];
    text += (text.empty() ? "" : ", ") + component.name + " = " + component.modes[modes[c].index()].name;
  }
  return text;
}

/// `engine for 0 to 60 s`: how old modes are with timed exits, where that is known.
std::string ages_text(const Plant& plant, const Strategy::Node& node) {
  std::string text;
  for (const Strategy::KnownAge& age : node.ages) {
    text += (text.empty() ? "" : ", ") + plant[age.component].name + " for " + automata::format_seconds(age.least);
    if (age.most > age.least) text += " to " + automata::format_seconds(age.most);
    text += " s";
  }
  return text;
}

/// What differs between two nodes: `engine: heating -> standby`.
std::string change_text(const Plant& plant, const Modes& from, const Modes& to) {
  std::string text;
  for (std::size_t c = 0; c < from.size(); ++c) {
    if (from[c] == to[c]) continue;
    const automata::Component& component = plant.components[c];
    text += (text.empty() ? "" : ", ") + component.name + ": " + component.modes[from[c].index()].name + " -> " +
            component.modes[to[c].index()].name;
  }
  return text.empty() ? "nothing changed" : text;
}

void write_cost(JsonLine& json, const runtime::Cost& cost) {
  constexpr double millionth = 1e-6;
  json.key("cost").open('{');
  json.key("irreversible").number(cost.irreversible).key("lost").number(cost.lost);
  json.key("worth").number(static_cast<double>(cost.worth) * millionth);
  json.key("unbounded_waits").number(cost.unbounded).key("time").seconds(automata::Ticks{cost.time});
  json.key("moves").number(cost.moves).key("disturbed").number(cost.disturbed);
  json.key("commands").number(cost.commands).key("waits").number(cost.waits);
  json.key("reward").number(static_cast<double>(cost.reward) * millionth);
  json.close('}');
}

}  // namespace

std::string_view word_for(Rank rank) {
  switch (rank) {
    case Rank::sure:
      return "sure";
    case Rank::fair:
      return "fair";
    case Rank::hoped:
      return "hoped";
    case Rank::none:
      return "none";
  }
  return {};
}

std::string strategy_text(const Plant& plant, const Strategy& strategy) {
  std::string text = "rank: " + std::string(word_for(strategy.rank));
  if (strategy.rank != Rank::none) text += strategy.lasts ? "; the goal lasts" : "; the goal does not last";
  if (!strategy.best) text += "; not proved optimal";
  text += "\n";
  const std::vector<bool> shown = moving(strategy);
  for (std::size_t n = 0; n < strategy.nodes.size(); ++n) {
    const Strategy::Node& node = strategy.nodes[n];
    const std::string modes = modes_text(plant, node.modes, n == 0 ? std::vector<bool>(shown.size(), true) : shown);
    const std::string ages = ages_text(plant, node);
    text += std::to_string(n) + (node.goal ? " (goal): " : ": ") + modes + (modes.empty() || ages.empty() ? "" : "; ") +
            ages + "\n    " + doing(plant, node) + "\n";
    for (const Strategy::Edge& edge : node.next)
      text += "    " + change_text(plant, node.modes, edge.modes) + ": to " + std::to_string(edge.node) + "\n";
  }
  return text;
}

void write_strategy(JsonLine& json, const Plant& plant, const Strategy& strategy) {
  json.open('{').key("rank").string(word_for(strategy.rank));
  json.key("lasts").boolean(strategy.lasts).key("solved").boolean(strategy.best);
  if (strategy.cost) write_cost(json, *strategy.cost);
  json.key("nodes").open('[');
  for (const Strategy::Node& node : strategy.nodes) {
    json.open('{').key("modes").modes(node.modes, plant).key("ages").open('{');
    for (const Strategy::KnownAge& age : node.ages)
      json.key(plant[age.component].name).open('[').seconds(age.least).seconds(age.most).close(']');
    json.close('}');
    json.key("command").assignments(automata::commanded(plant, node.action), plant.variables);
    json.key("outcome").string(outcome_of(node, plant)).key("goal").boolean(node.goal).key("next").open('[');
    for (const Strategy::Edge& edge : node.next)
      json.open('{').key("modes").modes(edge.modes, plant).key("node").number(edge.node).close('}');
    json.close(']').close('}');
  }
  json.close(']').close('}');
}

std::string strategy_dot(const Plant& plant, const Strategy& strategy) {
  const std::vector<bool> shown = moving(strategy);
  compiler::DotText dot("strategy");
  dot.defaults("node", {{"shape", "box"}, {"fontname", dot_value("sans-serif")}});
  dot.defaults("edge", {{"fontname", dot_value("sans-serif")}, {"fontsize", "10"}});
  for (std::size_t n = 0; n < strategy.nodes.size(); ++n) {
    const Strategy::Node& node = strategy.nodes[n];
    const std::string id = "n" + std::to_string(n);
    compiler::DotAttributes attributes{
        {"label", dot_value(modes_text(plant, node.modes, shown) + "\n" + doing(plant, node))}};
    if (node.goal) attributes.push_back({"peripheries", "2"});
    dot.node(id, attributes);
    for (const Strategy::Edge& edge : node.next) {
      dot.edge(id, "n" + std::to_string(edge.node), {{"label", dot_value(change_text(plant, node.modes, edge.modes))}});
    }
  }
  return dot.finish();
}

}  // namespace rmpl::tools
