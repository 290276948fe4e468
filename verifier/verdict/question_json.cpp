// What was asked, as JSON.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/question_json.hpp"

#include <string_view>

#include "base/overloaded.hpp"

namespace rmpl::verifier {

using automata::Plant;
using nlohmann::ordered_json;

namespace {

void add_window(ordered_json& json, const Window& window, bool fastest) {
  if (window.not_before) json["not_before"] = window.not_before->seconds();
  if (window.by) json["by"] = window.by->seconds();
  if (fastest) json["fastest"] = true;
}

ordered_json claim_of(const Plant& plant, const automata::Formula& formula, const Window& window, bool fastest) {
  ordered_json json = {{"formula", to_text(formula, plant.variables)}};
  add_window(json, window, fastest);
  return json;
}

ordered_json seconds_of(automata::Ticks time) {
  if (time.is_infinite()) return "inf";
  return time.seconds();
}

std::string_view name_of(Commands commands) {
  switch (commands) {
    case Commands::none:
      return "none";
    case Commands::one:
      return "one";
    case Commands::any:
      return "any";
  }
  return "";
}

/// What is free under a program and without one.
void add_freedom(ordered_json& json, const Plant& plant, const CheckOptions& options) {
  json["time"] = options.period ? ordered_json(options.period->seconds()) : ordered_json("dense");
  json["faults"] = options.faults ? ordered_json(*options.faults) : ordered_json("any");
  json["entailed"] = options.entailed;
  json["from"] = ordered_json::object();
  for (const automata::Assignment& a : options.from) {
    json["from"][plant.variables.name(a.variable)] = plant.variables.value(a);
  }
}

void add_bounds(ordered_json& json, const Bounds& bounds) {
  json["bounds"] = ordered_json::object();
  if (bounds.states) json["bounds"]["states"] = *bounds.states;
  if (bounds.time) json["bounds"]["seconds"] = seconds_of(*bounds.time);
  if (bounds.bytes) json["bounds"]["bytes"] = *bounds.bytes;
}

}  // namespace

ordered_json claim_of(const Plant& plant, const Property& property) {
  return std::visit(
      base::Overloaded{[&](const Reachability& p) { return claim_of(plant, p.target, p.window, p.fastest); },
                       [&](const Safety& p) { return claim_of(plant, p.never, p.window, p.fastest); },
                       [&](const Response& p) {
                         return ordered_json{{"after", to_text(p.after, plant.variables)},
                                             {"within", seconds_of(p.within)},
                                             {"formula", to_text(p.then, plant.variables)}};
                       },
                       [](const Stuck&) { return ordered_json::object(); },
                       [](const ProgramProperty& p) {
                         auto json = ordered_json::object();
                         if (!p.text.empty()) json["formula"] = p.text;
                         if (p.kind == ProgramProperty::Kind::eventually) json["within"] = seconds_of(p.within);
                         if (p.kind == ProgramProperty::Kind::response) {
                           json = {{"after", p.text}, {"within", seconds_of(p.within)}, {"formula", p.then_text}};
                         }
                         add_window(json, p.window, p.fastest);
                         return json;
                       }},
      property);
}

ordered_json question_json(const Plant& plant, const Question& question) {
  ordered_json json = claim_of(plant, question.property);
  add_freedom(json, plant, question.options);
  // Under a program the executive commands.
  if (!std::holds_alternative<ProgramProperty>(question.property)) {
    json["commands"] = name_of(question.options.commands);
  }
  json["fewest_faults"] = question.options.fewest_faults;
  json["cut_sets"] = question.options.cut_sets;
  add_bounds(json, question.bounds);
  return json;
}

ordered_json question_json(const Plant& plant, const ProgramQuestion& question) {
  ordered_json json = ordered_json::object();
  add_freedom(json, plant, question.options);
  json["fewest_faults"] = question.options.fewest_faults;
  json["cut_sets"] = question.options.cut_sets;
  add_bounds(json, question.bounds);
  return json;
}

}  // namespace rmpl::verifier
