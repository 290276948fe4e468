// Plants in sampled time for PRISM: one module a component, synchronised on the control action of a period.
//
// Given modes, clocks and the control action components draw independently (verifier/markov), which is what
// synchronised modules do.
// SPDX-License-Identifier: MIT
#include "verifier/export/prism.hpp"

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "automata/assignment_text.hpp"
#include "base/error.hpp"
#include "base/product.hpp"
#include "verifier/markov/markov.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::PlantStep;

namespace {

std::string mode_variable(std::size_t component) { return "m" + std::to_string(component); }
std::string clock_variable(std::size_t component) { return "x" + std::to_string(component); }

/// With all the digits that it has.
std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// In the language of PRISM; empty where it holds everywhere.
std::string text_of(const Condition& condition) {
  std::string result;
  for (const std::vector<InMode>& combination : condition) {
    std::string all;
    for (const InMode& in : combination) {
      all += (all.empty() ? "" : " & ") + mode_variable(in.component.index()) + "=" + std::to_string(in.mode.value);
    }
    if (!all.empty()) result += (result.empty() ? "(" : " | (") + all + ")";
  }
  return result;
}

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
    const std::string text = to_text(plant_.variables, automata::commanded(plant_, action));
    return text.empty() ? "all controls idle" : text;
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
    base::for_each_combination(lists, add);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Modes modes = queue[next];
      for (const ControlAction& action : actions_) {
        if (!step_.consistent(modes, action)) {
          throw base::InputError("prism cannot say what follows where the command " + describe(action) +
                                 " contradicts the modes: " + verifier::describe(plant_, modes));
        }
        const automata::AllEnabled enabled = step_.enabled(modes, action);
        for (std::size_t c = 0; c < modes.size(); ++c) lists[c] = targets(ComponentId(c), modes[c], enabled[c]);
        base::for_each_combination(lists, add);
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

  /// As `verifier::settled_reading`; throws where there is none.
  [[nodiscard]] Units settled_reading(ComponentId component, ModeId mode) const {
    const auto reading = verifier::settled_reading(plant_[component], mode, period_);
    if (reading) return *reading;
    throw base::InputError(
        "prism cannot say a hazard that goes on changing for ever: the normal density of a transition of " +
        plant_[component].name + " has no upper bound");
  }

  void write_module(ComponentId id) {
    const automata::Component& component = plant_[id];
    const std::string m = mode_variable(id.index());
    const std::string x = clock_variable(id.index());
    Units longest = 0;
    for (std::size_t mode = 0; mode < component.modes.size(); ++mode) {
      longest = std::max(longest, settled_reading(id, ModeId(mode)));
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
    for (const EnabledClass& choice : enabled_classes(step_, id, mode, actions_[action], meter_)) {
      write_readings(id, mode, choice, label(action), clocked);
    }
  }

  /// One command for each stretch of readings over which the probabilities are the same.
  void write_readings(ComponentId id, ModeId mode, const EnabledClass& choice, const std::string& label, bool clocked) {
    const Units settled = settled_reading(id, mode);
    const std::string x = clock_variable(id.index());
    const std::string condition = text_of(choice.where);
    for (const Stretch& stretch : stretches(step_, id, mode, choice.enabled, period_, settled)) {
      out_ << "  [" << label << "] " << mode_variable(id.index()) << '=' << mode.value;
      if (stretch.first > 0) out_ << " & " << x << ">=" << stretch.first;
      if (stretch.last) out_ << " & " << x << "<=" << *stretch.last;
      if (!condition.empty()) out_ << " & (" << condition << ')';
      out_ << " -> " << updates_of(id, mode, stretch.moves, settled, clocked) << ";\n";
    }
  }

  static std::string updates_of(ComponentId id, ModeId mode, const std::vector<automata::Move>& moves, Units settled,
                                bool clocked) {
    const std::string m = mode_variable(id.index());
    const std::string x = clock_variable(id.index());
    std::string text;
    for (const automata::Move& move : moves) {
      text += (text.empty() ? "" : " + ") + number(move.probability) + ":(" + m +
              "'=" + std::to_string(move.mode.value) + ")";
      if (!clocked) continue;
      const bool runs = move.mode == mode && settled > 0;
      text += " & (" + x + "'=" + (runs ? "min(" + x + "+1," + std::to_string(settled) + ")" : "0") + ")";
    }
    return text;
  }

  void write_target() {
    const Condition where = where_holds(step_, question_.target, question_.entailed, meter_);
    std::string condition = where.empty() ? "false" : text_of(where);
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
