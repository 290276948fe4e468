// Frames, scopes and variables of the stop where a run stands.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/debug_scopes.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "automata/place.hpp"
#include "base/error.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "runtime/executive/trace/three_digits.hpp"
#include "tools/rmpl-run/debug_adapter.hpp"
#include "tools/rmpl-run/step_choice.hpp"

namespace rmpl::tools {

using automata::Json;
using runtime::Stop;

std::optional<std::string> text_argument(const Json& arguments, const char* key) {
  const auto at = arguments.find(key);
  if (at == arguments.end() || at->is_null()) return std::nullopt;
  if (!at->is_string()) throw base::InputError(std::string("`") + key + "`: expected a text");
  return at->get<std::string>();
}

namespace {

Json variable(const std::string& name, const std::string& value) {
  return {{"name", name}, {"value", value}, {"variablesReference", 0}};
}

Json source_of(const std::string& file) {
  const std::filesystem::path path = canonical_path(file);
  return {{"name", path.filename().string()}, {"path", path.string()}};
}

}  // namespace

/// The marked locations that hold no others, the one that was hit first, then from the last of the program to the
/// first.
Json DebugAdapter::stack_trace(const Json& arguments) {
  const automata::Program& program = flight().program();
  std::vector<automata::LocationId> marked;
  if (!flight_->ended()) {
    for (const automata::LocationId id : flight_->decided().marking) {
      if (!program.locations[id.index()].composite || id == hit_) marked.push_back(id);
    }
  }
  std::reverse(marked.begin(), marked.end());
  std::stable_partition(marked.begin(), marked.end(), [&](automata::LocationId id) { return id == hit_; });
  Json frames = Json::array();
  for (const automata::LocationId id : marked) {
    const automata::Location& location = program.locations[id.index()];
    Json frame{{"id", id.index() + 1},
               {"name", location.label},
               {"line", location.origin.line},
               {"column", location.origin.column}};
    if (location.origin.line > 0) frame["source"] = source_of(location.origin.file);
    frames.push_back(std::move(frame));
  }
  if (frames.empty()) {
    frames.push_back(
        {{"id", program.locations.size() + 1}, {"name", "the program has ended"}, {"line", 0}, {"column", 0}});
  }
  const std::size_t total = frames.size();
  const Json first = arguments.value("startFrame", Json(0)), most = arguments.value("levels", Json(0));
  if (first.is_number_unsigned() && first.get<std::size_t>() > 0) {
    frames.erase(frames.begin(),
                 frames.begin() + static_cast<std::ptrdiff_t>(std::min(total, first.get<std::size_t>())));
  }
  if (most.is_number_unsigned() && most.get<std::size_t>() > 0 && most.get<std::size_t>() < frames.size()) {
    frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(most.get<std::size_t>()), frames.end());
  }
  return {{"stackFrames", frames}, {"totalFrames", total}};
}

Json DebugAdapter::scopes(const Json&) {
  Json all = Json::array();
  const auto add = [&](const char* name, DebugScope scope) {
    all.push_back({{"name", name}, {"variablesReference", static_cast<int>(scope)}, {"expensive", false}});
  };
  (void)flight();
  add("Goal and command", DebugScope::decided);
  add("Belief", DebugScope::belief);
  if (flight_->has_truth()) add("Truth", DebugScope::truth);
  add("Readings", DebugScope::readings);
  add("May come", DebugScope::ahead);
  return {{"scopes", all}};
}

Json DebugAdapter::variables(const Json& arguments) {
  const Stop stop = flight().stop();
  const Json reference = arguments.value("variablesReference", Json(0));
  Json all = Json::array();
  const auto add_facts = [&](const std::vector<Stop::Fact>& facts) {
    for (const Stop::Fact& fact : facts) {
      all.push_back(variable(fact.name, fact.value));
      all.back()["evaluateName"] = fact.name + " = " + fact.value;
    }
  };
  if (reference == static_cast<int>(DebugScope::decided)) {
    all.push_back(variable("time", runtime::moment(stop.time)));
    all.push_back(variable("cycle", std::to_string(stop.cycle)));
    for (std::size_t g = 0; g < stop.goals.size(); ++g) {
      all.push_back(variable(g == 0 ? "goal" : "goal " + std::to_string(g + 1),
                             stop.goals[g].text + in_parentheses(stop.goals[g].origin)));
    }
    all.push_back(variable("command", stop.command.empty() ? "none" : stop.command));
    if (!stop.why.empty()) all.push_back(variable("why", stop.why));
    for (std::size_t t = 0; t < stop.told.size(); ++t) {
      all.push_back(variable(t == 0 ? "told" : "told " + std::to_string(t + 1), stop.told[t]));
    }
  } else if (reference == static_cast<int>(DebugScope::belief)) {
    add_facts(stop.estimate);
    for (std::size_t b = 0; b < stop.belief.size(); ++b) {
      all.push_back(variable(
          b == 0 ? "likely" : "likely " + std::to_string(b + 1),
          runtime::three_digits(stop.belief[b].probability) + (b == 0 ? std::string() : ": " + stop.belief[b].text)));
    }
    for (std::size_t f = 0; f < stop.faults.size(); ++f) {
      all.push_back(variable(f == 0 ? "fault" : "fault " + std::to_string(f + 1), stop.faults[f]));
    }
  } else if (reference == static_cast<int>(DebugScope::truth)) {
    add_facts(stop.truth);
  } else if (reference == static_cast<int>(DebugScope::readings)) {
    add_facts(stop.readings);
  } else if (reference == static_cast<int>(DebugScope::ahead)) {
    std::size_t number = 0;
    for (const runtime::Prospect& prospect : flight_->ahead()) {
      all.push_back(variable(std::to_string(++number), to_text(prospect, flight_->plant(), flight_->time())));
    }
  }
  return {{"variables", all}};
}

/// What is typed into the console may choose something for the cycle that begins.
bool DebugAdapter::choose(const std::string& text) {
  using Choose = void (*)(runtime::FlightSteps&, const std::string&, const Common&);
  static constexpr std::array<std::pair<std::string_view, Choose>, 3> verbs{
      {{"fault ", choose_fault}, {"command ", choose_command}, {"observe ", choose_reading}}};
  for (const auto& [verb, choose_it] : verbs) {
    if (!text.starts_with(verb)) continue;
    choose_it(*flight_, text.substr(verb.size()), common_);
    return true;
  }
  return false;
}

/// A name tells its mode or reading; all else is a condition, as a breakpoint has it.
Json DebugAdapter::evaluate(const Json& arguments) {
  const std::string text = text_argument(arguments, "expression").value_or("");
  (void)flight();
  if (arguments.value("context", Json()) == "repl" && choose(text)) {
    return {{"result", "in the cycle that begins"}, {"variablesReference", 0}};
  }
  const Stop stop = flight().stop();
  for (const std::vector<Stop::Fact>* facts : {&stop.estimate, &stop.readings}) {
    for (const Stop::Fact& fact : *facts) {
      if (fact.name == text) return {{"result", fact.value}, {"variablesReference", 0}};
    }
  }
  const DebugCondition condition = debug_condition(text, flight_->plant(), flight_->has_truth());
  runtime::Watch watch(*flight_, condition.formula, condition.truth);
  return {{"result", watch.holds(flight_->last(), flight_->ended()) ? "true" : "false"}, {"variablesReference", 0}};
}

}  // namespace rmpl::tools
