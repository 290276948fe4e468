// Variables, formulas, assignments, times and origins as JSON.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "automata/json/document.hpp"

namespace rmpl::automata {
namespace {

constexpr std::array<std::pair<Comparison, const char*>, 4> comparisons{
    {{Comparison::less, "<"}, {Comparison::at_most, "<="}, {Comparison::greater, ">"}, {Comparison::at_least, ">="}}};

constexpr std::array<std::pair<Knowing, const char*>, 4> knowings{{{Knowing::surprise, "surprise"},
                                                                   {Knowing::no_plan, "no-plan"},
                                                                   {Knowing::possible, "possible"},
                                                                   {Knowing::likely, "likely"}}};

/// Deeper formulas than any source can give are refused, so that reading never runs out of stack.
constexpr std::size_t formula_depth_limit = 2000;

VariableId variable_named(const Node& node, const Variables& variables) {
  const auto id = variables.find(node.text());
  if (!id) node.fail("the name of a variable, not '" + node.text() + "'");
  return *id;
}

ValueId value_from_json(const Node& node, VariableId id, const Variables& variables) {
  const auto value = variables[id].find(node.text());
  if (!value) node.fail("a value of '" + variables.name(id) + "', not '" + node.text() + "'");
  return *value;
}

Formula read(const Node& node, const Variables& variables, std::span<const std::string> clocks, std::size_t depth);

Formula read_knowledge(const Node& node, const Variables& variables, std::size_t depth) {
  const std::string name = node.at("knows").text();
  const auto* const known =
      std::find_if(knowings.begin(), knowings.end(), [&](const auto& entry) { return name == entry.second; });
  if (known == knowings.end()) node.at("knows").fail("surprise, no-plan, possible or likely");
  if (known->first == Knowing::surprise || known->first == Knowing::no_plan) {
    node.only({"knows", "component"});
    if (!node.has("component")) return knowledge(known->first);
    return knowledge(known->first, variable_named(node.at("component"), variables));
  }
  node.only({"knows", "formula", "probability"});
  Formula operand = read(node.at("formula"), variables, {}, depth + 1);
  if (has_knowledge(operand)) node.at("formula").fail("a formula about the plant");
  return knowledge(known->first, std::move(operand), node.at("probability").probability());
}

Formula read(const Node& node, const Variables& variables, std::span<const std::string> clocks, std::size_t depth) {
  if (depth > formula_depth_limit) node.fail("a formula of at most " + std::to_string(formula_depth_limit) + " levels");
  if (node.json().is_boolean()) return constant(node.truth());
  const auto operands = [&](const char* key, std::size_t count) {
    node.only({key});
    std::vector<Formula> all;
    for (const Node& item : node.at(key).items()) all.push_back(read(item, variables, clocks, depth + 1));
    if (count != 0 && all.size() != count) node.at(key).fail("two operands");
    return all;
  };
  if (node.has("in")) {
    node.only({"variable", "in"});
    const VariableId id = variable_named(node.at("variable"), variables);
    std::vector<ValueId> values;
    for (const Node& value : node.at("in").items()) values.push_back(value_from_json(value, id, variables));
    return member(id, std::move(values));
  }
  if (node.has("equals")) {
    node.only({"variable", "equals"});
    const VariableId left = variable_named(node.at("variable"), variables);
    const VariableId right = variable_named(node.at("equals"), variables);
    if (variables[left].values != variables[right].values) node.fail("two variables of one domain");
    return equality(left, right);
  }
  if (node.has("clock")) {
    node.only({"clock", "is", "bound"});
    const std::string clock = node.at("clock").text();
    const std::string comparison = node.at("is").text();
    for (std::size_t c = 0; c < clocks.size(); ++c) {
      if (clocks[c] != clock) continue;
      for (const auto& [kind, spelling] : comparisons) {
        if (comparison == spelling) return clock_bound(ClockId(c), kind, node.at("bound").ticks());
      }
      node.at("is").fail("<, <=, > or >=");
    }
    node.at("clock").fail("the name of a clock, not '" + clock + "'");
  }
  if (node.has("knows")) return read_knowledge(node, variables, depth);
  if (node.has("not")) {
    node.only({"not"});
    return negation(read(node.at("not"), variables, clocks, depth + 1));
  }
  for (const auto& [key, kind] : {std::pair{"and", Formula::Kind::conjunction}, {"or", Formula::Kind::disjunction}}) {
    if (!node.has(key)) continue;
    Formula formula;
    formula.kind = kind;
    formula.operands = operands(key, 0);
    if (formula.operands.size() < 2) node.at(key).fail("two operands or more");
    return formula;
  }
  if (node.has("implies")) {
    auto pair = operands("implies", 2);
    return implication(std::move(pair[0]), std::move(pair[1]));
  }
  if (node.has("iff")) {
    auto pair = operands("iff", 2);
    return equivalence(std::move(pair[0]), std::move(pair[1]));
  }
  node.fail("a formula");
}

}  // namespace

Json to_json(const Formula& formula, const Variables& variables, std::span<const std::string> clocks) {
  const auto operands = [&] {
    Json all = Json::array();
    for (const Formula& operand : formula.operands) all.push_back(to_json(operand, variables, clocks));
    return all;
  };
  switch (formula.kind) {
    case Formula::Kind::constant:
      return formula.truth;
    case Formula::Kind::member: {
      Json values = Json::array();
      for (const ValueId value : formula.values) values.push_back(variables.value({formula.variable, value}));
      return {{"variable", variables.name(formula.variable)}, {"in", std::move(values)}};
    }
    case Formula::Kind::equality:
      return {{"variable", variables.name(formula.variable)}, {"equals", variables.name(formula.other)}};
    case Formula::Kind::clock:
      for (const auto& [kind, spelling] : comparisons) {
        if (kind == formula.comparison) {
          return {{"clock", clocks[formula.clock.index()]}, {"is", spelling}, {"bound", to_json(formula.bound)}};
        }
      }
      break;
    case Formula::Kind::knowledge: {
      Json json;
      for (const auto& [knowing, name] : knowings) {
        if (knowing == formula.knowing) json["knows"] = name;
      }
      if (formula.about_one) json["component"] = variables.name(formula.variable);
      if (formula.operands.empty()) return json;
      json["formula"] = to_json(formula.operands[0], variables);
      json["probability"] = formula.probability;
      return json;
    }
    case Formula::Kind::negation:
      return {{"not", to_json(formula.operands[0], variables, clocks)}};
    case Formula::Kind::conjunction:
      return {{"and", operands()}};
    case Formula::Kind::disjunction:
      return {{"or", operands()}};
    case Formula::Kind::implication:
      return {{"implies", operands()}};
    case Formula::Kind::equivalence:
      return {{"iff", operands()}};
  }
  return nullptr;
}

Formula formula_from_json(const Node& node, const Variables& variables, std::span<const std::string> clocks) {
  return read(node, variables, clocks, 0);
}

Json to_json(const Variable& variable) { return {{"name", variable.name}, {"values", variable.values}}; }

Variable variable_from_json(const Node& node) {
  node.only({"name", "values"});
  Variable variable{node.at("name").text(), {}};
  for (const Node& value : node.at("values").items()) {
    if (variable.find(value.text())) value.fail("a value that is new");
    variable.values.push_back(value.text());
  }
  return variable;
}

Json to_json(const Variables& variables) {
  Json all = Json::array();
  for (const Variable& variable : variables) all.push_back(to_json(variable));
  return all;
}

Variables variables_from_json(const Node& node) {
  Variables variables;
  for (const Node& item : node.items()) {
    Variable variable = variable_from_json(item);
    if (variables.find(variable.name)) item.at("name").fail("a name that is new");
    variables.add(std::move(variable));
  }
  return variables;
}

Json to_json(const Assignment& assignment, const Variables& variables) {
  return Json::array({variables.name(assignment.variable), variables.value(assignment)});
}

Assignment assignment_from_json(const Node& node, const Variables& variables) {
  const auto pair = node.items();
  if (pair.size() != 2) node.fail("a pair of variable and value");
  const VariableId id = variable_named(pair[0], variables);
  return {id, value_from_json(pair[1], id, variables)};
}

Json to_json(Ticks time) { return time.is_infinite() ? Json("inf") : Json(time.count); }

Json to_json(const Origin& origin) { return to_text(origin); }

Origin origin_from_json(const Node& node) {
  const std::string& text = node.text();
  Origin origin;
  const auto number_behind = [&](std::size_t colon, std::size_t end, std::uint32_t& number) {
    const auto parsed = std::from_chars(text.data() + colon + 1, text.data() + end, number);
    if (parsed.ec != std::errc() || parsed.ptr != text.data() + end) node.fail("a place, file:line:column");
  };
  const std::size_t last = text.rfind(':');
  const std::size_t first = last == std::string::npos || last == 0 ? std::string::npos : text.rfind(':', last - 1);
  if (first == std::string::npos) node.fail("a place, file:line:column");
  number_behind(first, last, origin.line);
  number_behind(last, text.size(), origin.column);
  origin.file = text.substr(0, first);
  return origin;
}

}  // namespace rmpl::automata
