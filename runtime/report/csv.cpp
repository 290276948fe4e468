// Comma-separated values: a line a change.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>

#include "automata/place.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/report/exports.hpp"

namespace rmpl::runtime {
namespace {

using automata::Ticks;

/// A field as it stands in a file: in quotes where it has to be. What a spreadsheet would take for a formula is led by
/// an apostrophe.
std::string field(std::string_view text) {
  std::string result(text);
  if (!result.empty() && std::string_view("=+-@\t\r").find(result.front()) != std::string_view::npos) {
    result.insert(0, "'");
  }
  if (result.find_first_of(",\"\r\n") == std::string::npos) return result;
  std::string quoted = "\"";
  for (const char c : result) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string number(double value) { return JsonLine().number(value).text(); }

class Table {
 public:
  explicit Table(const Flight& flight) : flight_(flight), plant_(*flight.plant) {}

  std::string text() {
    add_modes("truth", flight_.truth);
    add_modes("estimate", flight_.estimate);
    add_belief();
    add_samples();
    add_readings();
    add_events();
    add_program();
    add_commands();
    std::stable_sort(lines_.begin(), lines_.end(), [](const Line& a, const Line& b) { return a.time < b.time; });
    std::string result = "time,kind,name,value,note\r\n";
    for (const Line& line : lines_) result += automata::format_seconds(line.time) + line.rest;
    return result;
  }

 private:
  struct Line {
    Ticks time;
    std::string rest;
  };

  void add(Ticks time, std::string_view kind, std::string_view name, std::string_view value,
           std::string_view note = {}) {
    lines_.push_back(
        {time, "," + std::string(kind) + "," + field(name) + "," + field(value) + "," + field(note) + "\r\n"});
  }

  /// A value that stands as it is: a number below 0 is no formula.
  void add_line(Ticks time, std::string_view kind, std::string_view name, const std::string& value) {
    lines_.push_back({time, "," + std::string(kind) + "," + field(name) + "," + value + ",\r\n"});
  }

  void add_modes(std::string_view kind, const std::vector<Track<automata::ModeId>>& tracks) {
    for (std::size_t c = 0; c < tracks.size(); ++c) {
      const automata::Component& component = plant_.components[c];
      for (const auto& change : tracks[c].changes()) {
        const automata::Mode& mode = component.modes[change.value.index()];
        add(change.time, kind, component.name, mode.name, mode.fault ? "fault" : "");
      }
    }
  }

  void add_belief() {
    for (std::size_t c = 0; c < flight_.belief.size(); ++c) {
      const automata::Component& component = plant_.components[c];
      for (const auto& change : flight_.belief[c].changes()) {
        Shares shares = change.value;
        if (const auto* mode = flight_.estimate[c].at(change.time); shares.empty() && mode != nullptr) {
          shares.emplace_back(*mode, 100);
        }
        for (const auto& [mode, percent] : shares) {
          add(change.time, "belief", component.name, std::to_string(percent), component.modes[mode.index()].name);
        }
      }
    }
  }

  void add_samples() {
    for (const FlownChannel& channel : flight_.channels) {
      for (const auto& change : channel.signal.changes()) {
        add_line(change.time, "sample", channel.name,
                 change.value.number ? number(*change.value.number) : field(change.value.text));
      }
    }
  }

  void add_readings() {
    for (std::size_t i = 0; i < flight_.readings.size(); ++i) {
      const automata::Variable& variable = plant_.variables[plant_.observables[i]];
      for (const auto& change : flight_.readings[i].changes()) {
        add(change.time, "reading", variable.name, change.value ? variable.values[change.value->index()] : "");
      }
    }
  }

  void add_events() {
    for (const Happening& happening : flight_.happenings) {
      add(happening.from, "event", happening.component ? plant_[*happening.component].name : "", happening.kind,
          happening.text);
    }
    for (const Asked& asked : flight_.asked) {
      add(asked.time.value_or(flight_.end), "verdict", asked.text, asked.verdict,
          asked.reason + (asked.reason.empty() || asked.evidence.empty() ? "" : ": ") + asked.evidence);
    }
  }

  void add_program() {
    for (const auto& change : flight_.marking.changes()) {
      std::string marking;
      for (const automata::LocationId l : change.value) {
        marking += (marking.empty() ? "" : " ") + std::to_string(l.index() + 1);
      }
      add(change.time, "marking", flight_.program != nullptr ? flight_.program->name : "", marking);
    }
    std::vector<AssertedGoal> before;
    for (const auto& change : flight_.goals.changes()) {
      const auto in = [](const std::vector<AssertedGoal>& goals, const AssertedGoal& goal) {
        return std::any_of(goals.begin(), goals.end(),
                           [&](const AssertedGoal& other) { return other.goal.variable == goal.goal.variable; });
      };
      for (const AssertedGoal& goal : before) {
        if (!in(change.value, goal)) add(change.time, "goal", plant_.variables.name(goal.goal.variable), "");
      }
      for (const AssertedGoal& goal : change.value) {
        add(change.time, "goal", plant_.variables.name(goal.goal.variable), plant_.variables.value(goal.goal),
            goal.by ? place_of(*goal.by) : "");
      }
      before = change.value;
    }
    std::vector<AssertedConstraint> constraints;
    for (const auto& change : flight_.constraints.changes()) {
      const auto in = [](const std::vector<AssertedConstraint>& all, const AssertedConstraint& one) {
        return std::any_of(all.begin(), all.end(),
                           [&](const AssertedConstraint& other) { return other.text == one.text; });
      };
      for (const AssertedConstraint& one : constraints) {
        if (!in(change.value, one)) add(change.time, "goal", one.text, "");
      }
      for (const AssertedConstraint& one : change.value) {
        add(change.time, "goal", one.text, "true", one.by ? place_of(*one.by) : "");
      }
      constraints = change.value;
    }
    for (const auto& change : flight_.set_aside.changes()) add(change.time, "set aside", "", change.value);
  }

  [[nodiscard]] std::string place_of(automata::LocationId location) const {
    const automata::Origin& origin = flight_.program->locations[location.index()].origin;
    return origin.line > 0 ? automata::short_place(origin) : "";
  }

  void add_commands() {
    for (std::size_t i = 0; i < flight_.commands.size(); ++i) {
      const automata::Control& control = plant_.controls[i];
      for (const auto& change : flight_.commands[i].changes()) {
        const Explanation* why = change.value == control.idle ? nullptr : flight_.explanations.at(change.time);
        add(change.time, "command", plant_.variables.name(control.variable),
            plant_.variables.value({control.variable, change.value}), why == nullptr ? "" : why->why);
      }
    }
  }

  const Flight& flight_;
  const automata::Plant& plant_;
  std::vector<Line> lines_;
};

}  // namespace

std::string to_csv(const Flight& flight) { return Table(flight).text(); }

}  // namespace rmpl::runtime
