// Parameters are looked up where they are read: definitions may come in any order.
// SPDX-License-Identifier: MIT
#include "compiler/import/open_psa_expressions.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using grammar::Code;

std::string open_psa_name(pugi::xml_node element) { return element.attribute("name").value(); }

namespace {

/// An element that is no label and no attributes.
bool says_something(pugi::xml_node node) {
  const std::string_view kind = node.name();
  return node.type() == pugi::node_element && kind != "label" && kind != "attributes";
}

}  // namespace

std::vector<pugi::xml_node> open_psa_children(pugi::xml_node element) {
  std::vector<pugi::xml_node> result;
  for (const pugi::xml_node child : element.children()) {
    if (says_something(child)) result.push_back(child);
  }
  return result;
}

pugi::xml_node open_psa_child(pugi::xml_node element) { return element.find_child(says_something); }

std::string open_psa_number(double number) {
  char buffer[40];
  const auto [end, failure] = std::to_chars(buffer, buffer + sizeof buffer, number);
  return failure == std::errc() ? std::string(buffer, end) : "?";
}

grammar::Span OpenPsaExpressions::span(pugi::xml_node element) const {
  const auto begin = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(element.offset_debug(), 0));
  return {file_, begin, begin + static_cast<std::uint32_t>(std::string_view(element.name()).size())};
}

void OpenPsaExpressions::define(pugi::xml_node parameter) {
  if (parameters_.emplace(open_psa_name(parameter), parameter).second) return;
  errors_.report(Code::netlist_driver, span(parameter), backquoted(open_psa_name(parameter)) + " is defined twice");
}

OpenPsaExpressions::Chance OpenPsaExpressions::chance_of(pugi::xml_node expression) {
  const pugi::xml_node given = resolved(expression);
  if (std::string_view(given.name()) == "exponential") {
    const std::vector<pugi::xml_node> parts = open_psa_children(given);
    if (parts.size() != 2) {
      errors_.report(Code::netlist_syntax, span(given), "expected a rate and a time in exponential");
      return {0.0};
    }
    const double rate = value(parts[0], 0);
    if (rate < 0)
      errors_.report(Code::negative_rate, span(parts[0]), "a rate is at least 0, and this is " + open_psa_number(rate));
    const double unit = unit_of_time(given);
    if (std::string_view(resolved(parts[1]).name()) == "system-mission-time") return {std::nullopt, rate / unit};
    const double time = value(parts[1], 0);
    if (time < 0)
      errors_.report(Code::netlist_gate, span(parts[1]), "a time is at least 0, and this is " + open_psa_number(time));
    return {-std::expm1(-rate * time)};
  }
  const double probability = value(expression, 0);
  if (!(probability >= 0 && probability <= 1)) {
    errors_.report(Code::probability_out_of_range, span(expression),
                   "a probability is from 0 to 1, and this is " + open_psa_number(probability));
  }
  return {probability};
}

/// A parameter stands for its expression.
pugi::xml_node OpenPsaExpressions::resolved(pugi::xml_node expression) {
  std::set<std::string> seen;
  while (std::string_view(expression.name()) == "parameter") {
    const std::string name = open_psa_name(expression);
    const auto at = parameters_.find(name);
    if (at == parameters_.end()) return expression;
    if (!seen.insert(name).second) {
      errors_.report(Code::netlist_loop, span(expression),
                     "the parameter " + backquoted(name) + " is defined by itself");
      return {};
    }
    expression = open_psa_child(at->second);
  }
  return expression;
}

/// The seconds in the unit of time that an expression and its parameters count in: one where they state none.
double OpenPsaExpressions::unit_of_time(pugi::xml_node expression) {
  std::set<double> units;
  std::set<std::string> seen;
  collect_units(expression, 0, units, seen);
  if (units.size() > 1) {
    errors_.report(Code::netlist_gate, span(expression),
                   "rate and time count in different units of time: expected one, as each is taken as it is");
  }
  return units.empty() ? 1.0 : *units.begin();
}

void OpenPsaExpressions::collect_units(pugi::xml_node expression, int depth, std::set<double>& units,
                                       std::set<std::string>& seen) {
  if (depth > deepest_open_psa) return;  // `value` reports it
  collect_unit(expression, units);
  if (std::string_view(expression.name()) == "parameter") {
    const auto at = parameters_.find(open_psa_name(expression));
    if (at == parameters_.end() || !seen.insert(at->first).second) return;
    collect_unit(at->second, units);
    expression = at->second;
  }
  for (const pugi::xml_node part : open_psa_children(expression)) collect_units(part, depth + 1, units, seen);
}

/// The units of the format. A year is one of 365 days.
void OpenPsaExpressions::collect_unit(pugi::xml_node element, std::set<double>& units) {
  constexpr double hour = 3600, year = 8760 * hour;
  static const std::map<std::string_view, double> known = {{"bool", 0},     {"int", 0},        {"float", 0},
                                                           {"demands", 0},  {"hours", hour},   {"hours-1", hour},
                                                           {"years", year}, {"years-1", year}, {"fit", 1e9 * hour}};
  const pugi::xml_attribute attribute = element.attribute("unit");
  if (!attribute) return;
  const auto unit = known.find(attribute.value());
  if (unit == known.end()) {
    errors_.report(Code::netlist_syntax, span(element),
                   "unknown unit " + backquoted(attribute.value()) +
                       ", expected hours, hours-1, years, years-1, fit, demands, bool, int or float");
  } else if (unit->second > 0) {
    units.insert(unit->second);
  }
}

double OpenPsaExpressions::value(pugi::xml_node expression, int depth) {
  const std::string_view kind = expression.name();
  if (depth > deepest_open_psa) {
    errors_.report(Code::nesting_too_deep, span(expression), "the expression is nested too deep, or defined by itself");
    return 0;
  }
  if (kind == "float" || kind == "int") {
    const std::string_view given = expression.attribute("value").value();
    double number = 0;
    const auto [end, failure] = std::from_chars(given.data(), given.data() + given.size(), number);
    if (failure != std::errc() || end != given.data() + given.size() || !std::isfinite(number)) {
      errors_.report(Code::netlist_syntax, span(expression), "expected a number, not " + backquoted(given));
      return 0;
    }
    return number;
  }
  if (kind == "parameter") {
    const auto at = parameters_.find(open_psa_name(expression));
    if (at == parameters_.end()) {
      errors_.report(Code::netlist_driver, span(expression),
                     "nothing defines the parameter " + backquoted(open_psa_name(expression)));
      return 0;
    }
    // Once each: a parameter that is read twice, and so on, would else be worked out twice as often each time.
    const auto known = values_.find(at->first);
    if (known != values_.end()) return known->second;
    const double result = value(open_psa_child(at->second), depth + 1);
    values_.emplace(at->first, result);
    return result;
  }
  const std::vector<pugi::xml_node> parts = open_psa_children(expression);
  std::vector<double> values;
  if (kind == "neg" || kind == "add" || kind == "sub" || kind == "mul" || kind == "div") {
    for (const pugi::xml_node part : parts) values.push_back(value(part, depth + 1));
    if (values.empty()) {
      errors_.report(Code::netlist_syntax, span(expression), "an operation without numbers");
      return 0;
    }
    double result = kind == "neg" ? -values.front() : values.front();
    for (std::size_t i = 1; i < values.size(); ++i) {
      result = kind == "add"   ? result + values[i]
               : kind == "sub" ? result - values[i]
               : kind == "mul" ? result * values[i]
                               : result / values[i];
    }
    return result;
  }
  errors_.report(Code::netlist_gate, span(expression),
                 (kind.empty() ? std::string("a definition without a number") : backquoted(kind) + " is not imported") +
                     ", expected float, int, parameter, exponential or arithmetic");
  return 0;
}

}  // namespace rmpl::compiler
