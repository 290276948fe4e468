// Plants in sampled time for PRISM: one module a component, synchronised on the control action of a period.
//
// A component's choices depend on its mode, its clock (counted in periods), the modes that its guards can depend on,
// and the control action; given these, components draw independently (semantics 3), which is what synchronised modules
// do.
// SPDX-License-Identifier: MIT
#include "verifier/export/prism.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/error.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/zone/time_model.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::PlantStep;
using automata::Support;
using base::InputError;

namespace {

std::string mode_variable(std::size_t component) { return "m" + std::to_string(component); }
std::string clock_variable(std::size_t component) { return "x" + std::to_string(component); }

/// With all the digits that it has.
std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// For every combination of modes of some components, a class; asked which combinations a class has.
class Cases {
 public:
  explicit Cases(std::vector<ComponentId> components) : components_(std::move(components)) {}

  void add(std::vector<ModeId> modes, std::size_t number) { rows_.emplace_back(std::move(modes), number); }

  /// A condition for each class: of components that decide nothing nothing is said. Impossible combinations, which were
  /// never added, may be in any class or in none.
  std::map<std::size_t, std::string> conditions() {
    for (std::size_t c = components_.size(); c-- > 0;) drop_if_idle(c);
    std::map<std::size_t, std::string> result;
    for (const auto& [modes, number] : rows_) {
      std::string all;
      for (std::size_t c = 0; c < components_.size(); ++c) {
        all +=
            (all.empty() ? "" : " & ") + mode_variable(components_[c].index()) + "=" + std::to_string(modes[c].value);
      }
      std::string& condition = result[number];
      if (!all.empty()) condition += (condition.empty() ? "(" : " | (") + all + ")";
    }
    return result;
  }

 private:
  void drop_if_idle(std::size_t c) {
    std::map<std::vector<ModeId>, std::size_t> rest;
    for (const auto& [modes, number] : rows_) {
      std::vector<ModeId> others = modes;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(c));
      if (rest.emplace(std::move(others), number).first->second != number) return;
    }
    components_.erase(components_.begin() + static_cast<std::ptrdiff_t>(c));
    rows_.assign(rest.begin(), rest.end());
  }

  std::vector<ComponentId> components_;
  std::vector<std::pair<std::vector<ModeId>, std::size_t>> rows_;
};

class Writer {
 public:
  Writer(std::ostream& out, PlantStep& step, const ExportQuestion& question, automata::Ticks period,
         const Limits& limits)
      : out_(out),
        step_(step),
        plant_(step.plant()),
        question_(question),
        period_(period),
        meter_(limits),
        initial_(initial_modes(plant_, question.from)) {
    for_each_action(plant_, question.commands, [this](const ControlAction& action) { actions_.push_back(action); });
    const auto drawn = [](const automata::Component& c) {
      return std::count_if(c.initial.begin(), c.initial.end(), [](double p) { return p > 0; }) > 1;
    };
    drawn_ = std::any_of(plant_.components.begin(), plant_.components.end(), drawn) && question.from.empty();
  }

  void run() {
    refuse_impossible();
    const bool choice = actions_.size() > 1;
    out_ << (choice ? "mdp" : "dtmc") << "\n\n// " << plant_.name << ": a step is a period of "
         << automata::format_seconds(period_) << " s\n";
    if (drawn_) out_ << "// the first step, `start`, takes no time: it draws the initial modes\n";
    out_ << "// what is asked: " << (choice ? "Pmax" : "P") << "=? [ F \"target\" ]\n";
    for (std::size_t a = 0; a < actions_.size(); ++a) {
      out_ << "// " << label(a) << ": " << describe(actions_[a]) << '\n';
    }
    for (std::size_t c = 0; c < plant_.components.size(); ++c) write_module(ComponentId(c));
    write_target();
  }

 private:
  static std::string label(std::size_t action) { return "a" + std::to_string(action); }

  std::string describe(const ControlAction& action) const {
    std::string text;
    for (const automata::Assignment& a : automata::commanded(plant_, action)) {
      text += (text.empty() ? "" : ", ") + plant_.variables.name(a.variable) + " = " + plant_.variables.value(a);
    }
    return text.empty() ? "all controls idle" : text;
  }

  /// Visits every combination of one mode from each list.
  static void for_each_combination(const std::vector<std::vector<ModeId>>& lists,
                                   const std::function<void(const std::vector<ModeId>&)>& visit) {
    std::vector<ModeId> modes;
    const std::function<void()> extend = [&] {
      if (modes.size() == lists.size()) return visit(modes);
      for (const ModeId mode : lists[modes.size()]) {
        modes.push_back(mode);
        extend();
        modes.pop_back();
      }
    };
    extend();
  }

  /// Where modes that contradict the store may be drawn, the semantics draws again; modules cannot. Time is not looked
  /// at: some that no run comes to may be refused.
  void refuse_impossible() {
    std::set<Modes> seen;
    std::vector<Modes> queue;
    const auto add = [&](const Modes& modes) {
      meter_.poll();
      if (!seen.insert(modes).second) return;
      if (!step_.possible(modes)) {
        throw base::InputError("prism cannot say that modes are impossible, and these may be drawn: " +
                               verifier::describe(plant_, modes));
      }
      meter_.count_state();
      queue.push_back(modes);
    };
    std::vector<std::vector<ModeId>> lists = initial_;
    for_each_combination(lists, add);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Modes modes = queue[next];
      for (const ControlAction& action : actions_) {
        if (!step_.consistent(modes, action)) {
          throw base::InputError("prism cannot say what follows where the command " + describe(action) +
                                 " contradicts the modes: " + verifier::describe(plant_, modes));
        }
        const automata::AllEnabled enabled = step_.enabled(modes, action);
        for (std::size_t c = 0; c < modes.size(); ++c) lists[c] = targets(ComponentId(c), modes[c], enabled[c]);
        for_each_combination(lists, add);
      }
    }
  }

  [[nodiscard]] std::vector<ModeId> targets(ComponentId component, ModeId mode, const Enabled& enabled) const {
    std::set<ModeId> result;
    if (enabled.untimed.empty()) result.insert(mode);
    const auto add = [&](automata::TransitionId t) { result.insert(plant_[component].transitions[t.index()].to); };
    std::for_each(enabled.faults.begin(), enabled.faults.end(), add);
    std::for_each(enabled.untimed.begin(), enabled.untimed.end(), add);
    std::for_each(enabled.timed.begin(), enabled.timed.end(), add);
    return {result.begin(), result.end()};
  }

  /// The reading in periods from which on nothing depends on the clock any more.
  [[nodiscard]] Units last_reading(ComponentId component, ModeId mode) const {
    const TimeModel time = TimeModel::sampled(period_);
    Units last = 0;
    for (const automata::Transition& t : plant_[component].transitions) {
      if (t.from != mode || !t.timing) continue;
      const bool endless = t.timing->upper.is_infinite();
      if (endless && t.timing->density.kind == automata::Density::Kind::normal && !plant_[component].is_fault(t)) {
        throw base::InputError(
            "prism cannot say a hazard that goes on changing for ever: the normal density of a transition of " +
            plant_[component].name + " has no upper bound");
      }
      last = std::max(last, time.at_least(endless ? t.timing->lower : t.timing->upper));
    }
    return last;
  }

  void write_module(ComponentId id) {
    const automata::Component& component = plant_[id];
    const std::string m = mode_variable(id.index());
    const std::string x = clock_variable(id.index());
    Units longest = 0;
    for (std::size_t mode = 0; mode < component.modes.size(); ++mode) {
      longest = std::max(longest, last_reading(id, ModeId(mode)));
    }
    out_ << "\nmodule c" << id.value << " // " << component.name << "\n  // ";
    for (std::size_t mode = 0; mode < component.modes.size(); ++mode) {
      out_ << (mode == 0 ? "" : ", ") << mode << ' ' << component.modes[mode].name;
    }
    const std::vector<ModeId>& initial = initial_[id.index()];
    out_ << "\n  " << m << " : [" << (drawn_ ? "-1.." : "0..") << component.modes.size() - 1 << "] init "
         << (drawn_ ? "-1" : std::to_string(initial.front().value)) << ";\n";
    if (longest > 0) out_ << "  " << x << " : [0.." << longest << "] init 0; // periods in the mode\n";
    if (drawn_) {
      out_ << "  [start] " << m << "=-1 -> ";
      for (std::size_t i = 0; i < initial.size(); ++i) {
        const double share = initial.size() == 1 ? 1 : component.initial[initial[i].index()];
        out_ << (i == 0 ? "" : " + ") << number(share) << ":(" << m << "'=" << initial[i].value << ')';
      }
      out_ << ";\n";
    }
    for (std::size_t mode = 0; mode < component.modes.size(); ++mode) {
      for (std::size_t a = 0; a < actions_.size(); ++a) write_commands(id, ModeId(mode), a, longest > 0);
    }
    out_ << "endmodule\n";
  }

  /// What the component may do in a mode under an action, by what is enabled.
  void write_commands(ComponentId id, ModeId mode, std::size_t action, bool clocked) {
    const Support& support = step_.support(id, mode);
    std::vector<std::vector<ModeId>> lists;
    for (const ComponentId c : support.components) {
      auto& modes = lists.emplace_back();
      for (std::size_t m = 0; m < plant_[c].modes.size(); ++m) {
        if (c != id || m == mode.index()) modes.emplace_back(m);
      }
    }
    std::vector<Enabled> classes;
    Cases cases(support.components);
    for_each_combination(lists, [&](const std::vector<ModeId>& chosen) {
      meter_.poll();
      Modes modes(plant_.components.size(), ModeId(0));
      std::vector<automata::Assignment> store = automata::assignments_of(plant_, actions_[action]);
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        modes[support.components[i].index()] = chosen[i];
        store.push_back({plant_[support.components[i]].mode, automata::ValueId(chosen[i].index())});
      }
      modes[id.index()] = mode;
      if (!step_.theory().consistent(store)) return;
      const Enabled& enabled = step_.enabled(id, modes, actions_[action]);
      const auto same = [&](const Enabled& e) {
        return e.faults == enabled.faults && e.untimed == enabled.untimed && e.timed == enabled.timed;
      };
      const auto known = std::find_if(classes.begin(), classes.end(), same);
      cases.add(chosen, static_cast<std::size_t>(known - classes.begin()));
      if (known == classes.end()) classes.push_back(enabled);
    });
    for (const auto& [number, condition] : cases.conditions()) {
      write_readings(id, mode, classes[number], label(action), condition, clocked);
    }
  }

  /// One command for each stretch of readings over which the probabilities are the same.
  void write_readings(ComponentId id, ModeId mode, const Enabled& enabled, const std::string& label,
                      const std::string& condition, bool clocked) {
    const Units last = last_reading(id, mode);
    Units first = 0;
    std::string updates = updates_of(id, mode, enabled, 0, clocked);
    for (Units reading = 1; reading <= last + 1; ++reading) {
      std::string next = reading <= last ? updates_of(id, mode, enabled, reading, clocked) : "";
      if (next == updates) continue;
      out_ << "  [" << label << "] " << mode_variable(id.index()) << '=' << mode.value;
      const std::string x = clock_variable(id.index());
      if (first > 0) out_ << " & " << x << ">=" << first;
      if (reading <= last) out_ << " & " << x << "<=" << reading - 1;
      if (!condition.empty()) out_ << " & (" << condition << ')';
      out_ << " -> " << updates << ";\n";
      first = reading;
      updates = std::move(next);
    }
  }

  std::string updates_of(ComponentId id, ModeId mode, const Enabled& enabled, Units reading, bool clocked) {
    const std::string m = mode_variable(id.index());
    const std::string x = clock_variable(id.index());
    const automata::Ticks before{reading * period_.count};
    const automata::Ticks now{before.count + period_.count};
    std::string text;
    for (const automata::Move& move : step_.moves(id, mode, enabled, automata::Ticks{0}, before, now)) {
      text += (text.empty() ? "" : " + ") + number(move.probability) + ":(" + m +
              "'=" + std::to_string(move.mode.value) + ")";
      if (!clocked) continue;
      const Units last = last_reading(id, mode);
      const bool runs = move.mode == mode && last > 0;
      text += " & (" + x + "'=" + (runs ? "min(" + x + "+1," + std::to_string(last) + ")" : "0") + ")";
    }
    return text;
  }

  void write_target() {
    const Support support = step_.locality().support_of(question_.target);
    const automata::Theory::Handle target = step_.theory().encode(question_.target);
    std::vector<std::vector<ModeId>> lists;
    for (const ComponentId c : support.components) {
      auto& modes = lists.emplace_back();
      for (std::size_t m = 0; m < plant_[c].modes.size(); ++m) modes.emplace_back(m);
    }
    Cases cases(support.components);
    for_each_combination(lists, [&](const std::vector<ModeId>& chosen) {
      meter_.poll();
      std::vector<automata::Assignment> store;
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        store.push_back({plant_[support.components[i]].mode, automata::ValueId(chosen[i].index())});
      }
      if (!step_.theory().consistent(store)) return;
      const bool holds =
          question_.entailed ? step_.theory().entails(store, target) : step_.theory().allows(store, target);
      cases.add(chosen, holds ? 1 : 0);
    });
    const auto conditions = cases.conditions();
    const auto found = conditions.find(1);
    std::string condition = found == conditions.end() ? "false" : found->second;
    if (condition.empty()) condition = "true";
    out_ << "\nlabel \"target\" = " << (drawn_ ? mode_variable(0) + ">=0 & (" + condition + ")" : condition) << ";\n";
  }

  std::ostream& out_;
  PlantStep& step_;
  const Plant& plant_;
  const ExportQuestion& question_;
  automata::Ticks period_;
  Meter meter_;
  std::vector<std::vector<ModeId>> initial_;  ///< by component
  std::vector<ControlAction> actions_;
  bool drawn_ = false;  ///< the initial modes are drawn, in a step of its own
};

}  // namespace

void write_prism(std::ostream& out, PlantStep& step, const ExportQuestion& question, automata::Ticks period,
                 const Limits& limits) {
  if (question.faults > 0) {
    throw base::InputError(
        "prism weighs faults by their probability and does not bound their number; expected no --faults");
  }
  Writer(out, step, question, period, limits).run();
}

}  // namespace rmpl::verifier
