// A goal divided among groups of threads, and their commands put together.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/marked_reconfigurer.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "automata/assignment_text.hpp"
#include "automata/dependencies/marking_groups.hpp"
#include "base/check.hpp"
#include "runtime/reasoning/reconfigure/marking_planner.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;
using automata::Formula;
using automata::Marking;
using automata::ModelProgram;

/// The conjuncts of a goal; none where it is `true`.
std::vector<Assignment> assignments_in(const Formula& goal) {
  std::vector<Assignment> result;
  if (goal.is_true()) return result;
  for (const Formula& conjunct : conjuncts_of(goal)) {
    CHECK(conjunct.kind == Formula::Kind::member && conjunct.values.size() == 1 && "goals are assignments");
    result.push_back({conjunct.variable, conjunct.values.front()});
  }
  return result;
}

/// Some groups as one program, with the planner of it.
class Field {
 public:
  explicit Field(automata::MarkingGroup group) : group_(std::move(group)), planner_(group_.program) {}
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;

  MarkingPlanner& planner() { return planner_; }
  [[nodiscard]] const std::vector<std::size_t>& controls() const { return group_.controls; }
  [[nodiscard]] Assignment here(Assignment whole) const {
    const auto at = std::lower_bound(group_.variables.begin(), group_.variables.end(), whole.variable);
    return {automata::VariableId(static_cast<std::size_t>(at - group_.variables.begin())), whole.value};
  }
  [[nodiscard]] Marking here(const Marking& whole) const {
    Marking result;
    for (std::size_t l = 0; l < group_.locations.size(); ++l) {
      if (std::binary_search(whole.begin(), whole.end(), group_.locations[l])) result.emplace_back(l);
    }
    return result;
  }

 private:
  automata::MarkingGroup group_;
  MarkingPlanner planner_;
};

/// What a goal asks of a field: the positions of conjuncts, and what these are there.
struct Part {
  Field* field;
  bool joint;  ///< of several groups
  std::vector<std::size_t> conjuncts;
  std::vector<Assignment> goal;
  Marking from;
  MarkingMove move;
};

class MarkedReconfigurer final : public Reconfigurer {
 public:
  MarkedReconfigurer(const ModelProgram& program, const automata::MarkedPlant& plant)
      : program_(program), plant_(plant), groups_(program) {}

  Reconfiguration next(const automata::Modes& modes, const Formula& goal) override {
    const Marking marking = plant_.marking(modes);
    Reconfiguration result = towards(marking, assignments_in(goal));
    if (result.outcome != Reconfiguration::Outcome::no_plan) suit(marking, result);
    return result;
  }

 private:
  Reconfiguration towards(const Marking& marking, const std::vector<Assignment>& wanted) {
    std::map<std::size_t, std::vector<std::size_t>> by_group;  // conjuncts
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const auto& home = groups_.home(wanted[i].variable);
      if (!home) return without_plan(i, wanted, ": no location of the model program tells this variable", 0);
      by_group[home->group].push_back(i);
    }
    std::vector<Part> parts;
    parts.reserve(by_group.size());
    for (const auto& [group, conjuncts] : by_group) parts.push_back(planned({group}, conjuncts, wanted, marking));
    if (parts.size() > 1 && !are_apart(parts)) {
      std::vector<std::size_t> all;
      all.reserve(by_group.size());
      for (const auto& part : by_group) all.push_back(part.first);
      std::vector<std::size_t> conjuncts(wanted.size());
      for (std::size_t i = 0; i < wanted.size(); ++i) conjuncts[i] = i;
      std::vector<Part> together;
      together.push_back(planned(all, conjuncts, wanted, marking));
      return answer(together, wanted);
    }
    return answer(parts, wanted);
  }

  /// Where idle values contradict what is told, those that do not take their place.
  void suit(const Marking& marking, Reconfiguration& result) {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const auto& controls = groups_[g].controls;
      if (controls.empty()) continue;
      Field& own = field({g});
      automata::Command command;
      for (const std::size_t c : controls) command.emplace_back(result.action[c]);
      const auto permitted = own.planner().permitted(own.here(marking), command);
      if (!permitted || *permitted == command) continue;
      for (std::size_t c = 0; c < controls.size(); ++c) result.action[controls[c]] = *(*permitted)[c];
      if (result.outcome != Reconfiguration::Outcome::command && result.why.purpose == Reason::Purpose::none) {
        result.why.purpose = Reason::Purpose::model;
      }
      result.outcome = Reconfiguration::Outcome::command;
    }
  }

  Field& field(const std::vector<std::size_t>& groups) {
    auto& known = fields_[groups];
    if (!known) known = std::make_unique<Field>(groups_.joined(groups));
    return *known;
  }

  Part planned(const std::vector<std::size_t>& groups, const std::vector<std::size_t>& conjuncts,
               const std::vector<Assignment>& wanted, const Marking& marking) {
    Field& own = field(groups);
    Part part{&own, groups.size() > 1, conjuncts, {}, own.here(marking), {}};
    for (const std::size_t c : conjuncts) part.goal.push_back(own.here(wanted[c]));
    part.move = own.planner().next(part.from, part.goal);
    return part;
  }

  /// Whether each can be planned for without a look at the others: no two have a control in common, and what one comes
  /// to is there still when another gets there. Where one has no plan, all together have none.
  static bool are_apart(std::vector<Part>& parts) {
    const auto fails = [](const Part& part) {
      return part.move.kind == MarkingMove::Kind::nowhere || part.move.kind == MarkingMove::Kind::failure;
    };
    if (std::any_of(parts.begin(), parts.end(), fails)) return true;
    std::set<std::size_t> controls;
    for (const Part& part : parts) {
      for (const std::size_t control : part.field->controls()) {
        if (!controls.insert(control).second) return false;
      }
    }
    return std::all_of(parts.begin(), parts.end(), [](Part& part) { return part.field->planner().lasts(part.goal); });
  }

  Reconfiguration answer(std::vector<Part>& parts, const std::vector<Assignment>& wanted) const {
    Reconfiguration result;
    result.action = automata::idle_action(plant_.plant());
    for (Part& part : parts) {
      MarkingPlanner& planner = part.field->planner();
      result.checked += planner.looked_at();
      if (part.move.kind == MarkingMove::Kind::done) continue;
      const std::size_t open = open_conjunct(part, wanted);
      const std::string together = part.joint ? " together with the rest of the goal" : "";
      if (part.move.kind == MarkingMove::Kind::nowhere) {
        return without_plan(open, wanted, together + ", whatever the model program draws", result.checked);
      }
      if (part.move.kind == MarkingMove::Kind::failure) {
        return without_plan(open, wanted, together + " without an improbable draw, which counts as a failure",
                            result.checked);
      }
      if (part.move.kind == MarkingMove::Kind::given_up) {
        return without_plan(open, wanted, ": the search was given up, because there are too many markings",
                            result.checked);
      }
      const bool acts = take(part, result.action);
      const bool first = result.why.purpose == Reason::Purpose::none;
      if (first || (acts && result.outcome != Reconfiguration::Outcome::command)) {
        result.why = {Reason::Purpose::goal, Reason::Obstacle::none, static_cast<std::uint32_t>(open)};
        result.component = plant_.plant().component_of(wanted[open].variable);
      }
      if (acts || first) result.outcome = acts ? Reconfiguration::Outcome::command : Reconfiguration::Outcome::wait;
    }
    return result;
  }

  /// The first conjunct that is not achieved yet, of those that the command has to do with where there is one.
  [[nodiscard]] std::size_t open_conjunct(Part& part, const std::vector<Assignment>& wanted) const {
    std::optional<std::size_t> first;
    for (std::size_t c = 0; c < part.goal.size(); ++c) {
      if (part.field->planner().entails(part.from, part.goal[c])) continue;
      const auto& controls = groups_[groups_.home(wanted[part.conjuncts[c]].variable)->group].controls;
      const auto& own = part.field->controls();
      for (std::size_t i = 0; i < part.move.command.size(); ++i) {
        const bool busy = part.move.command[i] != plant_.plant().controls[own[i]].idle;
        if (busy && std::binary_search(controls.begin(), controls.end(), own[i])) return part.conjuncts[c];
      }
      if (!first) first = part.conjuncts[c];
    }
    return first.value_or(part.conjuncts.front());
  }

  /// Puts the command of a part into the action; whether there is something off idle.
  bool take(const Part& part, automata::ControlAction& action) const {
    const auto& controls = part.field->controls();
    bool some = false;
    for (std::size_t c = 0; c < controls.size(); ++c) {
      action[controls[c]] = *part.move.command[c];
      some = some || action[controls[c]] != plant_.plant().controls[controls[c]].idle;
    }
    return some;
  }

  [[nodiscard]] Reconfiguration without_plan(std::size_t conjunct, const std::vector<Assignment>& wanted,
                                             const std::string& why, std::size_t checked) const {
    Reconfiguration result;
    result.outcome = Reconfiguration::Outcome::no_plan;
    result.action = automata::idle_action(plant_.plant());
    result.why = {Reason::Purpose::goal, Reason::Obstacle::not_found, static_cast<std::uint32_t>(conjunct)};
    result.component = plant_.plant().component_of(wanted[conjunct].variable);
    std::string goals = to_text(program_.variables, wanted[conjunct]);
    result.reason = "no commands lead to " + goals + why;
    result.checked = checked;
    return result;
  }

  const ModelProgram& program_;
  const automata::MarkedPlant& plant_;
  automata::MarkingGroups groups_;
  std::map<std::vector<std::size_t>, std::unique_ptr<Field>> fields_;  ///< by groups, as they are asked for
};

}  // namespace

std::unique_ptr<Reconfigurer> make_marked_reconfigurer(const ModelProgram& program,
                                                       const automata::MarkedPlant& plant) {
  return std::make_unique<MarkedReconfigurer>(program, plant);
}

}  // namespace rmpl::runtime
