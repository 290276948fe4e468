// Witnesses as text and as JSON.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/trace.hpp"

#include <algorithm>

#include "automata/assignment_text.hpp"
#include "automata/fault_step.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::LocationId;
using automata::Plant;
using automata::Ticks;
using nlohmann::ordered_json;

namespace {

/// A component that an event moved.
struct Taken {
  const automata::Component& component;
  const automata::Mode& from;
  const automata::Mode& to;
  bool fault;
};

std::vector<Taken> taken(const Plant& plant, const Event& before, const Event& event) {
  std::vector<Taken> result;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    if (before.modes[c] == event.modes[c]) continue;
    const automata::Component& component = plant.components[c];
    result.push_back({component, component.modes[before.modes[c].index()], component.modes[event.modes[c].index()],
                      automata::is_fault_step(component, before.modes[c], event.modes[c])});
  }
  return result;
}

/// The goals with the lines that assert them.
std::string goal_text(const Subject& subject, const automata::Goals& goals) {
  std::string result;
  const auto add = [&](const std::string& text, LocationId by) {
    result += (result.empty() ? "" : ", ") + text + in_brackets(subject.program->locations[by.index()].origin);
  };
  for (std::size_t g = 0; g < goals.goal.size(); ++g) add(to_text(subject.plant.variables, goals.goal[g]), goals.by[g]);
  for (const automata::GoalConstraint& constraint : goals.constraints)
    add(to_text(constraint.formula, subject.plant.variables), constraint.by);
  return result;
}

std::string changes_text(const Plant& plant, const Event& before, const Event& event) {
  std::string result;
  for (const Taken& t : taken(plant, before, event)) {
    result += (result.empty() ? "" : ", ") + t.component.name + ": " + t.from.name + " -> " + t.to.name;
    if (t.fault) result += " (fault)";
  }
  for (const automata::ComponentId c : event.restarted) {
    result += (result.empty() ? "" : ", ") + plant[c].name + ": " +
              plant[c].modes[event.modes[c.index()].index()].name + " restarts";
  }
  return result;
}

/// The modes to start in, as far as they are not those that are most likely there.
std::string start_text(const Plant& plant, const automata::Modes& modes) {
  std::vector<Assignment> others;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const auto& initial = plant.components[c].initial;
    const auto likely = std::max_element(initial.begin(), initial.end()) - initial.begin();
    if (modes[c].index() != static_cast<std::size_t>(likely)) {
      others.push_back({plant.components[c].mode, automata::ValueId(modes[c].index())});
    }
  }
  return others.empty() ? "the initial modes" : "the initial modes, but " + to_text(plant.variables, others);
}

/// The lines of a run: a time, and what there is to say.
class Story {
 public:
  Story(const Subject& subject, const Witness& witness) : subject_(subject), witness_(witness) {}

  std::string tell(const std::string& end) {
    const std::vector<Event>& events = witness_.events;
    line(Ticks{0}, start_text(subject_.plant, events.front().modes));
    for (std::size_t e = 1; e < events.size(); ++e) {
      const Ticks since = events[e - 1].time;
      if (witness_.repeats_from == e) line(since, "from here on the run repeats:");
      // The end of a run that ends with its program says so itself.
      const bool last = e + 1 == events.size() && events[e].time == since;
      if (events[e].cycle && !last) tell_end(*events[e].cycle, since);
      if (events[e].cycle) tell_goal(*events[e].cycle, since);
      if (events[e].cycle && e + 1 == events.size()) {
        line(events[e].time, end);
      } else {
        tell_step(events[e - 1], events[e]);
      }
    }
    if (!end.empty() && !events.back().cycle) line(events.back().time, end);
    std::size_t width = 0;
    for (const auto& [time, text] : lines_) width = std::max(width, time.size());
    std::string result;
    for (const auto& [time, text] : lines_) {
      result.append(2 + width - time.size(), ' ');
      result += time;
      result += " s  ";
      result += text;
      result += '\n';
    }
    return result;
  }

 private:
  void line(Ticks time, const std::string& text) { lines_.emplace_back(automata::format_seconds(time), text); }

  /// `since`: the end of the cycle before. All from there on assert the same.
  void tell_goal(const Cycle& cycle, Ticks since) {
    const std::string goal = to_text(cycle.goals.formula(), subject_.plant.variables);
    if (goal == goal_) return;
    goal_ = goal;
    if (!cycle.goals.empty()) line(since, "goal " + goal_text(subject_, cycle.goals));
  }

  /// Runs go on after the program has ended, where what is owed may still come.
  void tell_end(const Cycle& cycle, Ticks since) {
    if (!cycle.marking.empty() || ended_) return;
    ended_ = true;
    line(since, "the program has ended");
  }

  void tell_step(const Event& before, const Event& event) {
    const std::string changes = changes_text(subject_.plant, before, event);
    const std::string command = to_text(subject_.plant.variables, automata::commanded(subject_.plant, event.action));
    const bool repeated = changes.empty() && event.action == command_;
    command_ = event.action;
    if (event.cycle && ((changes.empty() && command.empty()) || repeated)) return;
    line(event.time,
         (command.empty() ? "" : "command " + command + ": ") + (changes.empty() ? "nothing changes" : changes));
  }

  const Subject& subject_;
  const Witness& witness_;
  std::string goal_ = "true";
  bool ended_ = false;
  automata::ControlAction command_;
  std::vector<std::pair<std::string, std::string>> lines_;
};

ordered_json json_of(const Plant& plant, const std::vector<Assignment>& assignments) {
  ordered_json result = ordered_json::object();
  for (const Assignment& a : assignments) result[plant.variables.name(a.variable)] = plant.variables.value(a);
  return result;
}

ordered_json json_of(const automata::Program& program, const automata::Marking& marking) {
  ordered_json result = ordered_json::array();
  for (const LocationId id : marking) {
    const automata::Location& location = program.locations[id.index()];
    ordered_json entry = {{"location", id.index() + 1}, {"label", location.label}};
    if (location.origin.line > 0) entry["place"] = to_text(location.origin);
    result.push_back(std::move(entry));
  }
  return result;
}

}  // namespace

std::string text_of(const Subject& subject, const Witness& witness, const std::string& end) {
  return Story(subject, witness).tell(end);
}

ordered_json json_of(const Subject& subject, const Witness& witness) {
  const Plant& plant = subject.plant;
  const std::vector<Event>& events = witness.events;
  ordered_json result = ordered_json::array();
  for (std::size_t e = 0; e < events.size(); ++e) {
    ordered_json moved = ordered_json::object();
    for (const Taken& t : taken(plant, events[e == 0 ? 0 : e - 1], events[e])) {
      moved[t.component.name] = {{"from", t.from.name}, {"to", t.to.name}};
    }
    ordered_json event = {{"time", events[e].time.seconds()},
                          {"modes", json_of(plant, automata::assignments_of(plant, events[e].modes))},
                          {"command", json_of(plant, automata::commanded(plant, events[e].action))},
                          {"taken", std::move(moved)}};
    if (!events[e].restarted.empty()) {
      event["restarted"] = ordered_json::array();
      for (const automata::ComponentId c : events[e].restarted) event["restarted"].push_back(plant[c].name);
    }
    if (subject.program != nullptr) {
      // At the start nothing is asserted yet; the marking there is that of the first cycle.
      const Cycle& cycle = *events[std::max<std::size_t>(e, 1)].cycle;
      event["start"] = e == 0 ? 0.0 : cycle.begin.seconds();
      event["marking"] = json_of(*subject.program, cycle.marking);
      event["goal"] = e == 0 ? ordered_json::object() : json_of(plant, cycle.goals.goal);
      if (e > 0 && !cycle.goals.constraints.empty()) {
        event["goal_constraints"] = ordered_json::array();
        for (const automata::GoalConstraint& constraint : cycle.goals.constraints)
          event["goal_constraints"].push_back(to_text(constraint.formula, plant.variables));
      }
      if (e > 0 && !cycle.left_out.empty()) {
        event["left_out"] = ordered_json::array();
        for (const runtime::LeftOut& left_out : cycle.left_out)
          event["left_out"].push_back(to_text(left_out.goals.formula(), plant.variables));
      }
    }
    result.push_back(std::move(event));
  }
  return result;
}

}  // namespace rmpl::verifier
