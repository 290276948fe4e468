// Lines and events become moments; what was decided in a cycle stands with the moment at which it began.
// SPDX-License-Identifier: MIT
#include "runtime/executive/step/trace_moments.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

#include "automata/assignment_text.hpp"
#include "automata/json/parse.hpp"
#include "automata/place.hpp"
#include "base/error.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/executive/trace/log_names.hpp"
#include "runtime/executive/trace/trace_reader.hpp"

namespace rmpl::runtime {

using automata::Json;

namespace {

/// A member, or null.
const Json* find(const Json& object, const char* key) {
  const auto at = object.find(key);
  return at == object.end() || at->is_null() ? nullptr : &*at;
}

std::string text_or(const Json& object, const char* key, const std::string& otherwise = {}) {
  const Json* found = find(object, key);
  return found != nullptr && found->is_string() ? found->get<std::string>() : otherwise;
}

std::uint32_t line_of(const Json& object) {
  const Json* line = find(object, "line");
  const bool fits = line != nullptr && line->is_number_unsigned() &&
                    line->get<std::uint64_t>() <= std::numeric_limits<std::uint32_t>::max();
  return fits ? line->get<std::uint32_t>() : 0;
}

automata::Origin origin_of(const Json& object) { return {text_or(object, "file"), line_of(object), 0}; }

/// `name = value, …` of an object of names.
std::string pairs_of(const Json& object) {
  std::string text;
  if (!object.is_object()) return text;
  for (const auto& [name, value] : object.items()) {
    if (value.is_string()) text += (text.empty() ? "" : ", ") + name + " = " + value.get<std::string>();
  }
  return text;
}

/// The reason of a trace in words, as that of a flight.
std::string why_of(const Json& reason) {
  const std::string purpose = text_or(reason, "purpose");
  std::string text;
  if (purpose == "goal") {
    const Json* goal = find(reason, "goal");
    const std::string what = goal != nullptr ? pairs_of(*goal) : text_or(reason, "goal_constraint");
    if (!what.empty()) text = "for " + what;
  } else if (purpose == "reward") {
    text = "for reward";
  } else if (purpose == "model") {
    text = "all controls idle would contradict the model";
  }
  if (const Json* step = find(reason, "transition")) {
    text += (text.empty() ? "'" : ": '") + text_or(*step, "component") + "' from '" + text_or(*step, "from") +
            "' to '" + text_or(*step, "to") + "'" + in_parentheses(origin_of(*step));
  }
  return text + (reason.value("solved", true) ? "" : "; not proved optimal");
}

/// Reads lines or events one after the other, and puts together what belongs to a moment.
class Reader {
 public:
  Reader(const automata::Plant& plant, const automata::Program& program, std::string name)
      : plant_(plant), names_(plant), program_(program), name_(std::move(name)) {}

  std::vector<TraceMoment> read(const std::string& text) {
    Json whole = Json::parse(text, nullptr, false);
    if (!whole.is_discarded() && whole.is_object() && whole.contains("trace")) {
      witness(whole["trace"]);
    } else {
      lines(text);
    }
    if (found_.empty()) throw base::InputError(name_ + ": expected a trace, and there is none in it");
    return put_together();
  }

 private:
  /// What one line or event says. What was decided is about the cycle that it is the end of.
  struct Raw {
    TraceMoment moment;
    std::vector<Stop::Line> marking, goals;
    bool ended = false;  ///< nothing was marked in it
    std::string command, why;
    std::vector<std::string> decided;  ///< events of its start
  };

  void lines(const std::string& text) {
    std::istringstream in(text), again(text);
    LogReader reader(in, name_, plant_);
    std::size_t number = 0;
    Json whole = Json::object();
    std::string line;
    std::uint64_t cycle = 0;
    while (const auto read = reader.next()) {
      while (number < read->number && std::getline(again, line)) ++number;
      const Json json = Json::parse(line);  // the reader has seen that it is one
      merge_line(whole, json);
      if (!read->estimate) throw base::InputError(place(number) + ": expected `estimate`, as in a trace of a flight");
      Raw raw;
      cycle = read->cycle.value_or(found_.empty() ? 0 : cycle + 1);
      Stop& stop = raw.moment.stop;
      stop.cycle = cycle;
      stop.time = read->time;
      raw.moment.estimate = modes_of(*read->estimate, place(number));
      raw.moment.observations = read->observations;
      raw.moment.set_aside = read->set_aside;
      raw.moment.command = automata::action_from(plant_, read->command);
      if (const Json* truth = find(whole, "truth")) raw.moment.truth = named_modes(*truth, place(number));
      stop.readings = facts_of(plant_, read->observations);
      raw.command = to_text(plant_.variables, automata::commanded(plant_, raw.moment.command));
      if (const Json* reason = find(whole, "reason")) raw.why = why_of(*reason);
      marking(whole, raw);
      goals(whole, raw);
      events(whole, raw);
      evidence(json, raw);
      found_.push_back(std::move(raw));
    }
  }

  void marking(const Json& whole, Raw& raw) const {
    const Json* marking = find(whole, "marking");
    if (marking == nullptr || !marking->is_array()) return;
    raw.ended = marking->empty();
    for (const Json& number : *marking) {
      if (!number.is_number_unsigned()) continue;
      const auto id = number.get<std::uint64_t>();
      if (program_.locations.empty()) {
        raw.marking.push_back({std::to_string(id), {}});
      } else if (id >= 1 && id <= program_.locations.size()) {
        const automata::Location& location = program_.locations[id - 1];
        if (!location.composite) raw.marking.push_back({location.label, location.origin});
      } else {
        throw base::InputError(name_ + ": location " + std::to_string(id) + ": program '" + program_.name + "' has " +
                               std::to_string(program_.locations.size()));
      }
    }
  }

  static void goals(const Json& whole, Raw& raw) {
    const Json* by = find(whole, "asserted_by");
    if (const Json* goal = find(whole, "goal"); goal != nullptr && goal->is_object()) {
      for (const auto& [name, value] : goal->items()) {
        if (!value.is_string()) continue;
        const Json* asserting = by == nullptr ? nullptr : find(*by, name.c_str());
        raw.goals.push_back({name + " = " + value.get<std::string>(),
                             asserting != nullptr ? origin_of(*asserting) : automata::Origin{}});
      }
    }
    const Json* constraints = find(whole, "goal_constraints");
    if (constraints == nullptr || !constraints->is_array()) return;
    for (const Json& constraint : *constraints) {
      if (constraint.is_string()) raw.goals.push_back({constraint.get<std::string>(), {}});
      if (constraint.is_object()) raw.goals.push_back({text_or(constraint, "constraint"), origin_of(constraint)});
    }
  }

  static void events(const Json& whole, Raw& raw) {
    const Json* events = find(whole, "events");
    if (events == nullptr || !events->is_array()) return;
    for (const Json& event : *events) {
      if (!event.is_object()) continue;
      const std::string kind = text_or(event, "kind");
      const std::string message = text_or(event, "message");
      raw.moment.no_plan = raw.moment.no_plan || kind == "no-plan";
      if (kind == "inconsistent") {
        raw.moment.stop.told.push_back("surprise: " + message);
      } else if (kind == "no-plan") {
        raw.decided.push_back("no plan: " + message);
      } else if (kind == "goal-conflict" || kind == "irreversible" || kind == "commanded") {
        raw.decided.push_back(message);
      } else if (!message.empty()) {
        raw.moment.story.push_back(std::string(kind).append(": ").append(message));
      }
    }
  }

  static void evidence(const Json& line, Raw& raw) {
    const Json* all = find(line, "evidence");
    if (all == nullptr || !all->is_array()) return;
    for (const Json& one : *all) {
      const Json* readings = find(one, "readings");
      raw.moment.stop.faults.push_back(text_or(one, "component") + " = " + text_or(one, "fault") + ": " +
                                       text_or(one, "kind") +
                                       (readings == nullptr ? "" : " by " + pairs_of(*readings)));
    }
  }

  void witness(const Json& trace) {
    if (!trace.is_array()) throw base::InputError(name_ + ": /trace: expected an array of events");
    for (const Json& event : trace) {
      const std::string at = name_ + ": /trace/" + std::to_string(found_.size());
      const Json* time = event.is_object() ? find(event, "time") : nullptr;
      const Json* modes = event.is_object() ? find(event, "modes") : nullptr;
      if (time == nullptr || !time->is_number() || modes == nullptr) {
        throw base::InputError(at + ": expected an event of a plant, with `time` and `modes`");
      }
      const auto ticks = automata::ticks_from_seconds(time->get<double>());
      if (!ticks || (!found_.empty() && *ticks < found_.back().moment.stop.time)) {
        throw base::InputError(at + "/time: expected seconds, not before the event before");
      }
      Raw raw;
      Stop& stop = raw.moment.stop;
      stop.cycle = found_.size();
      stop.of_witness = true;
      stop.time = *ticks;
      raw.moment.truth = named_modes(*modes, at + "/modes");
      raw.moment.estimate = *raw.moment.truth;
      std::vector<automata::Assignment> command;
      if (const Json* told = find(event, "command"); told != nullptr && told->is_object()) {
        for (const auto& [name, value] : told->items()) {
          if (!value.is_string())
            throw base::InputError(std::string(at).append("/command/").append(name).append(": expected a value"));
          command.push_back(names_.resolve(LogReader::Role::command, name, value.get<std::string>()));
        }
      }
      raw.moment.command = automata::action_from(plant_, command);
      raw.command = to_text(plant_.variables, automata::commanded(plant_, raw.moment.command));
      if (const Json* marked = find(event, "marking"); marked != nullptr && marked->is_array()) {
        raw.ended = marked->empty();
        for (const Json& location : *marked) {
          if (location.is_object())
            raw.marking.push_back({text_or(location, "label"), {text_or(location, "place"), 0, 0}});
        }
      }
      goals(event, raw);
      found_.push_back(std::move(raw));
    }
  }

  /// What a cycle decided stands where it begins: at the end of the one before, or of cycles that were left out since
  /// nothing changed in them.
  std::vector<TraceMoment> put_together() {
    std::vector<TraceMoment> moments;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      TraceMoment moment = std::move(found_[i].moment);
      Stop& stop = moment.stop;
      const Raw* next = i + 1 < found_.size() ? &found_[i + 1] : nullptr;
      if (next != nullptr && !stop.of_witness && next->moment.stop.cycle > stop.cycle + 1) next = &found_[i];
      stop.over = next == nullptr;
      if (next != nullptr) {
        stop.marking = next->marking;
        stop.goals = next->goals;
        stop.command = next->command;
        stop.why = next->why;
        stop.ended = next->ended;
        stop.told.insert(stop.told.end(), next->decided.begin(), next->decided.end());
      }
      if (moment.truth) stop.truth = facts_of(plant_, *moment.truth, {});
      if (!stop.of_witness) {
        stop.estimate = facts_of(plant_, moment.estimate, {});
        stop.believes_truth = moment.truth == moment.estimate;
      }
      moments.push_back(std::move(moment));
    }
    return moments;
  }

  [[nodiscard]] std::string place(std::size_t line) const { return name_ + ":" + std::to_string(line); }

  [[nodiscard]] automata::Modes modes_of(const std::vector<automata::Assignment>& told, const std::string& at) const {
    try {
      return names_.all_modes(told);
    } catch (const base::InputError& error) {
      throw base::InputError(at + ":" + error.what());
    }
  }

  [[nodiscard]] automata::Modes named_modes(const Json& names, const std::string& at) const {
    if (!names.is_object()) throw base::InputError(at + ": expected modes by the names of components");
    std::vector<automata::Assignment> told;
    for (const auto& [name, value] : names.items()) {
      if (!value.is_string())
        throw base::InputError(std::string(at).append(": ").append(name).append(": expected a mode"));
      try {
        told.push_back(names_.resolve(LogReader::Role::estimate, name, value.get<std::string>()));
      } catch (const base::InputError& error) {
        throw base::InputError(at + ": " + error.what());
      }
    }
    return modes_of(told, at);
  }

  const automata::Plant& plant_;
  LogNames names_;
  const automata::Program& program_;
  std::string name_;
  std::vector<Raw> found_;
};

}  // namespace

std::vector<TraceMoment> read_moments(const automata::Plant& plant, const automata::Program& program,
                                      const std::string& text, const std::string& name) {
  return Reader(plant, program, name).read(text);
}

}  // namespace rmpl::runtime
