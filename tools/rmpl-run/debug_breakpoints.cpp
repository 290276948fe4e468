// A hit is a change: what holds in cycle after cycle stops a run once.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/debug_breakpoints.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include "automata/assignment_text.hpp"
#include "base/error.hpp"
#include "compiler/session/compiler.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::tools {

using automata::Json;
using runtime::Event;

namespace {

constexpr std::string_view truth_word = "truth ";

const char* kind_of(const std::string& filter) {
  for (const char* known : {"surprise", "noplan", "goal-conflict"}) {
    if (filter == known) return known;
  }
  throw base::InputError("no exception is called '" + filter + "'; expected surprise, noplan or goal-conflict");
}

}  // namespace

std::string canonical_path(const std::string& path) {
  std::error_code unknown;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, unknown);
  return unknown ? path : canonical.string();
}

DebugCondition debug_condition(const std::string& text, const automata::Plant& plant, bool has_truth) {
  DebugCondition condition;
  condition.truth = text.starts_with(truth_word);
  if (condition.truth && !has_truth) throw base::InputError("this trace does not record the truth; ask the estimate");
  const std::string asked = condition.truth ? text.substr(truth_word.size()) : text;
  auto compiled = condition.truth ? compiler::compile_formula(asked, plant, "condition")
                                  : compiler::compile_program_formula(asked, plant, "condition");
  if (!compiled.formula) throw base::InputError(grammar::render_text(compiled.findings, false));
  condition.formula = std::move(*compiled.formula);
  return condition;
}

void DebugBreakpoints::bind(runtime::FlightSteps& flight) {
  flight_ = &flight;
  look_anew();
}

void DebugBreakpoints::watch(Condition& condition) {
  condition.watch = std::make_unique<runtime::Watch>(*flight_, condition.formula, condition.truth);
  condition.held = condition.watch->holds(flight_->last(), flight_->ended());
}

void DebugBreakpoints::look_anew() {
  marking_ = flight_->decided().marking;
  estimate_ = flight_->last().estimate;
  if (flight_->last().truth != nullptr) truth_ = *flight_->last().truth;
  for (Condition& condition : conditions_) watch(condition);
}

/// A line without a location moves on to the next one that has some.
Json DebugBreakpoints::set_lines(const std::string& path, const Json& lines) {
  const std::string file = canonical_path(path);
  std::erase_if(lines_, [&](const Line& line) { return line.path == file; });
  const automata::Plant& plant = flight_->plant();
  const automata::Program& program = flight_->program();
  std::map<std::string, bool> same;  // by the name in the origin: the disk is asked once for each
  const auto line_in_file = [&](const automata::Origin& origin) -> std::uint32_t {
    if (origin.line == 0) return 0;
    const auto [known, fresh] = same.try_emplace(origin.file, false);
    if (fresh) known->second = canonical_path(origin.file) == file;
    return known->second ? origin.line : 0;
  };
  std::vector<std::uint32_t> of_locations, of_modes;
  for (const automata::Location& location : program.locations) of_locations.push_back(line_in_file(location.origin));
  for (const automata::Component& component : plant.components) {
    for (const automata::Mode& mode : component.modes) of_modes.push_back(line_in_file(mode.origin));
  }
  Json answer = Json::array();
  for (const Json& asked : lines) {
    const Json* number = asked.is_object() && asked.contains("line") ? &asked["line"] : nullptr;
    if (number == nullptr || !number->is_number_unsigned()) throw base::InputError("breakpoints: expected a `line`");
    const auto wanted = number->get<std::uint64_t>();
    std::uint32_t nearest = 0;
    for (const std::vector<std::uint32_t>* all : {&of_locations, &of_modes}) {
      for (const std::uint32_t line : *all) {
        if (line >= wanted && (nearest == 0 || line < nearest)) nearest = line;
      }
    }
    Json told{{"id", ++last_id_}, {"verified", nearest > 0}};
    if (nearest == 0) {
      told["message"] = "no step of the program and no mode of the plant begins here or below";
    } else {
      told["line"] = nearest;
      Line line{last_id_, file, {}, {}};
      for (std::size_t l = 0; l < of_locations.size(); ++l) {
        if (of_locations[l] == nearest) line.locations.emplace_back(l);
      }
      std::size_t at = 0;
      for (std::size_t c = 0; c < plant.components.size(); ++c) {
        for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
          if (of_modes[at++] == nearest) line.modes.emplace_back(c, m);
        }
      }
      lines_.push_back(std::move(line));
    }
    answer.push_back(std::move(told));
  }
  return answer;
}

Json DebugBreakpoints::set_conditions(const Json& breakpoints) {
  conditions_.clear();
  Json answer = Json::array();
  for (const Json& asked : breakpoints) {
    Json told{{"id", ++last_id_}};
    const std::string text = asked.is_object() && asked.contains("name") && asked["name"].is_string()
                                 ? asked["name"].get<std::string>()
                                 : std::string();
    try {
      DebugCondition read = debug_condition(text, flight_->plant(), flight_->has_truth());
      Condition condition;
      condition.id = last_id_;
      condition.text = text;
      condition.truth = read.truth;
      condition.formula = std::move(read.formula);
      watch(condition);
      conditions_.push_back(std::move(condition));
      told["verified"] = true;
    } catch (const base::InputError& error) {
      told["verified"] = false;
      told["message"] = error.what();
    }
    answer.push_back(std::move(told));
  }
  return answer;
}

Json DebugBreakpoints::set_data(const Json& breakpoints) {
  data_.clear();
  Json answer = Json::array();
  for (const Json& asked : breakpoints) {
    std::string id = asked.is_object() && asked.contains("dataId") && asked["dataId"].is_string()
                         ? asked["dataId"].get<std::string>()
                         : std::string();
    const bool truth = id.starts_with(truth_word);
    if (truth) id = id.substr(truth_word.size());
    const auto component = flight_->plant().find_component(id);
    Json told{{"id", ++last_id_}, {"verified", component.has_value()}};
    if (component) {
      data_.push_back({last_id_, *component, truth});
    } else {
      told["message"] = "no component is called '" + id + "'";
    }
    answer.push_back(std::move(told));
  }
  return answer;
}

void DebugBreakpoints::set_reports(const Json& filters) {
  std::set<std::string> known;
  for (const Json& filter : filters) known.insert(kind_of(filter.is_string() ? filter.get<std::string>() : ""));
  reports_ = std::move(known);
}

std::optional<DebugHit> DebugBreakpoints::newly_marked(bool all) {
  const automata::Marking& now = flight_->decided().marking;
  DebugHit hit;
  for (const Line& line : lines_) {
    for (const automata::LocationId location : line.locations) {
      const bool marked = std::find(now.begin(), now.end(), location) != now.end();
      const bool before = std::find(marking_.begin(), marking_.end(), location) != marking_.end();
      if (!marked || (before && !all)) continue;
      hit.ids.push_back(line.id);
      hit.location = location;
      hit.text = flight_->program().locations[location.index()].label;
      break;
    }
  }
  if (hit.ids.empty()) return std::nullopt;
  hit.reason = "breakpoint";
  return hit;
}

std::optional<DebugHit> DebugBreakpoints::look_at_start() { return newly_marked(true); }

std::optional<DebugHit> DebugBreakpoints::look(const runtime::CycleRecord& record, bool ended) {
  std::optional<DebugHit> found;
  const auto report = [&](const Event& event) {
    const bool wanted = (event.kind == Event::Kind::inconsistent && reports_.contains("surprise")) ||
                        (event.kind == Event::Kind::no_plan && reports_.contains("noplan")) ||
                        (event.kind == Event::Kind::goal_conflict && reports_.contains("goal-conflict"));
    if (wanted && !found) found = DebugHit{"exception", {}, event.message, std::nullopt};
  };
  for (const Event& event : record.events) {
    if (event.kind == Event::Kind::inconsistent) report(event);
  }
  // What was decided for the cycle that begins; a goal may be without a plan in cycle after cycle.
  for (const Event& event : flight_->decided().events) {
    const bool new_one = std::find(record.events.begin(), record.events.end(), event) == record.events.end();
    if (event.kind != Event::Kind::inconsistent && new_one) report(event);
  }
  if (auto marked = newly_marked(false); marked && !found) found = std::move(marked);
  const automata::Modes& estimate = record.estimate;
  for (const Line& line : lines_) {
    for (const auto& [component, mode] : line.modes) {
      const std::size_t c = component.index();
      if (found || estimate[c] != mode || (!estimate_.empty() && estimate_[c] == mode)) continue;
      found = DebugHit{"breakpoint", {line.id}, to_text(flight_->plant()[component], mode), std::nullopt};
    }
  }
  for (Condition& condition : conditions_) {
    const bool holds = condition.watch->holds(record, ended);
    if (holds && !condition.held && !found) {
      found = DebugHit{"function breakpoint", {condition.id}, condition.text, std::nullopt};
    }
    condition.held = holds;
  }
  for (const Data& data : data_) {
    const std::size_t c = data.component.index();
    const automata::Modes& before = data.truth ? truth_ : estimate_;
    const automata::Modes* now = data.truth ? record.truth : &estimate;
    if (found || now == nullptr || before.empty() || before[c] == (*now)[c]) continue;
    found = DebugHit{"data breakpoint", {data.id}, to_text(flight_->plant()[data.component], (*now)[c]), std::nullopt};
  }
  marking_ = flight_->decided().marking;
  estimate_ = estimate;
  if (record.truth != nullptr) truth_ = *record.truth;
  return found;
}

}  // namespace rmpl::tools
