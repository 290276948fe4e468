// Plants in sampled time for PRISM: one module a component, synchronised on the control action of a period. Modules
// that read the same, but for names, are one with other names.
//
// Given modes, clocks and the control action components draw independently (verifier/markov), which is what
// synchronised modules do.
// SPDX-License-Identifier: MIT
#include "verifier/export/prism.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
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

/// With all the digits that it has.
std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// What the components and commands that a module speaks of are called in it, by number.
struct Naming {
  std::vector<std::size_t> components;  ///< by component
  std::vector<std::size_t> labels;      ///< by control action

  [[nodiscard]] std::string mode(ComponentId component) const {
    return "m" + std::to_string(components[component.index()]);
  }
  [[nodiscard]] std::string clock(ComponentId component) const {
    return "x" + std::to_string(components[component.index()]);
  }
  [[nodiscard]] std::string label(std::size_t action) const { return "a" + std::to_string(labels[action]); }
};

/// In the language of PRISM; empty where it holds everywhere.
std::string text_of(const Condition& condition, const Naming& naming) {
  std::string result;
  for (const std::vector<InMode>& combination : condition) {
    std::string all;
    for (const InMode& in : combination) {
      all += (all.empty() ? "" : " & ") + naming.mode(in.component) + "=" + std::to_string(in.mode.value);
    }
    if (!all.empty()) result += (result.empty() ? "(" : " | (") + all + ")";
  }
  return result;
}

/// What a component draws from in a mode under a control action, where that is so.
struct Command {
  ModeId mode;
  std::size_t action;
  Condition where;
  std::vector<Stretch> stretches;  ///< of readings over which the probabilities are the same
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
      out_ << "// a" << a << ": " << describe(actions_[a]) << '\n';
    }
    for (std::size_t c = 0; c < plant_.components.size(); ++c) write_module(ComponentId(c));
    write_target();
  }

 private:
  static constexpr std::size_t unnamed = static_cast<std::size_t>(-1);

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
    throw base::InputError("prism cannot say a hazard that goes on changing for ever: the density of a transition of " +
                           plant_[component].name +
                           " is not exponential and has no upper bound; expected a finite one");
  }

  /// A module of its own; or where one before it reads the same, but for what components and commands are called, that
  /// one with other names.
  void write_module(ComponentId id) {
    const std::vector<Command> commands = commands_of(id);
    Naming common = common_naming(id, commands);
    const std::string text = body_of(id, commands, common);
    const automata::Component& component = plant_[id];
    std::string modes;
    for (std::size_t mode = 0; mode < component.modes.size(); ++mode) {
      modes += (mode == 0 ? "" : ", ") + std::to_string(mode) + ' ' + component.modes[mode].name;
    }
    out_ << "\nmodule c" << id.value;
    const auto [like, fresh] = written_.emplace(std::pair(modes, text), std::pair(id, common));
    if (fresh) {
      out_ << " // " << component.name << "\n  // " << modes << '\n'
           << body_of(id, commands, own_names()) << "endmodule\n";
      return;
    }
    const auto& [model, names] = like->second;
    out_ << " = c" << model.value << " [ " << renaming(model, names, common) << " ] endmodule // " << component.name
         << '\n';
  }

  /// `m2=m5, x2=x5, …`: what has the same common name in both.
  static std::string renaming(ComponentId model, const Naming& from, const Naming& to) {
    std::string text;
    const auto add = [&](char letter, const std::vector<std::size_t>& these, const std::vector<std::size_t>& those) {
      for (std::size_t i = 0; i < these.size(); ++i) {
        if (these[i] == unnamed || (letter == 'x' && i != model.index())) continue;
        const auto other = static_cast<std::size_t>(std::find(those.begin(), those.end(), these[i]) - those.begin());
        if (other == i) continue;
        text += (text.empty() ? "" : ", ") + (letter + std::to_string(i)) + '=' + letter + std::to_string(other);
      }
    };
    add('m', from.components, to.components);
    add('x', from.components, to.components);
    add('a', from.labels, to.labels);
    return text;
  }

  [[nodiscard]] Naming own_names() const {
    Naming naming;
    for (std::size_t c = 0; c < plant_.components.size(); ++c) naming.components.push_back(c);
    for (std::size_t a = 0; a < actions_.size(); ++a) naming.labels.push_back(a);
    return naming;
  }

  /// Names that like modules have in common: the component itself first, those that it reads by their types, commands
  /// by what they do to it.
  Naming common_naming(ComponentId id, const std::vector<Command>& commands) const {
    Naming naming{std::vector<std::size_t>(plant_.components.size(), unnamed),
                  std::vector<std::size_t>(actions_.size())};
    std::set<ComponentId> read;
    for (const Command& command : commands) {
      for (const auto& combination : command.where) {
        for (const InMode& in : combination) read.insert(in.component);
      }
    }
    read.erase(id);
    std::vector<ComponentId> sorted(read.begin(), read.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](ComponentId a, ComponentId b) { return plant_[a].type < plant_[b].type; });
    std::size_t next = 0;
    naming.components[id.index()] = next++;
    for (const ComponentId other : sorted) naming.components[other.index()] = next++;
    std::vector<std::pair<std::string, std::size_t>> by_effect;
    for (std::size_t a = 0; a < actions_.size(); ++a) by_effect.emplace_back("", a);
    for (const Command& command : commands) by_effect[command.action].first += text_of(id, command, "", naming);
    std::sort(by_effect.begin(), by_effect.end());
    for (std::size_t place = 0; place < by_effect.size(); ++place) naming.labels[by_effect[place].second] = place;
    return naming;
  }

  [[nodiscard]] std::vector<Command> commands_of(ComponentId id) {
    std::vector<Command> commands;
    for (std::size_t m = 0; m < plant_[id].modes.size(); ++m) {
      const ModeId mode(m);
      const Units settled = settled_reading(id, mode);
      for (std::size_t a = 0; a < actions_.size(); ++a) {
        for (const EnabledClass& choice : enabled_classes(step_, id, mode, actions_[a], meter_)) {
          commands.push_back({mode, a, choice.where, stretches(step_, id, mode, choice.enabled, period_, settled)});
        }
      }
    }
    return commands;
  }

  [[nodiscard]] Units longest_reading(ComponentId id) const {
    Units longest = 0;
    for (std::size_t m = 0; m < plant_[id].modes.size(); ++m)
      longest = std::max(longest, settled_reading(id, ModeId(m)));
    return longest;
  }

  /// Variables and commands.
  [[nodiscard]] std::string body_of(ComponentId id, const std::vector<Command>& commands, const Naming& naming) const {
    const automata::Component& component = plant_[id];
    const std::string m = naming.mode(id);
    const Units longest = longest_reading(id);
    const std::vector<ModeId>& initial = initial_[id.index()];
    std::string text = "  " + m + " : [" + (drawn_ ? "-1.." : "0..") + std::to_string(component.modes.size() - 1) +
                       "] init " + (drawn_ ? "-1" : std::to_string(initial.front().value)) + ";\n";
    if (longest > 0) {
      text += "  " + naming.clock(id) + " : [0.." + std::to_string(longest) + "] init 0; // periods in the mode\n";
    }
    if (drawn_) {
      text += "  [start] " + m + "=-1 -> ";
      for (std::size_t i = 0; i < initial.size(); ++i) {
        const double share = initial.size() == 1 ? 1 : component.initial[initial[i].index()];
        text += (i == 0 ? "" : " + ") + number(share) + ":(" + m + "'=" + std::to_string(initial[i].value) + ')';
      }
      text += ";\n";
    }
    std::vector<const Command*> ordered;
    ordered.reserve(commands.size());
    for (const Command& command : commands) ordered.push_back(&command);
    std::stable_sort(ordered.begin(), ordered.end(), [&](const Command* one, const Command* other) {
      return std::pair(one->mode, naming.labels[one->action]) < std::pair(other->mode, naming.labels[other->action]);
    });
    for (const Command* command : ordered) text += text_of(id, *command, naming.label(command->action), naming);
    return text;
  }

  /// A line for each stretch.
  [[nodiscard]] std::string text_of(ComponentId id, const Command& command, const std::string& label,
                                    const Naming& naming) const {
    const Units settled = settled_reading(id, command.mode);
    const std::string x = naming.clock(id);
    const std::string condition = verifier::text_of(command.where, naming);
    std::string text;
    for (const Stretch& stretch : command.stretches) {
      text += "  [" + label + "] " + naming.mode(id) + '=' + std::to_string(command.mode.value);
      if (stretch.first > 0) text += " & " + x + ">=" + std::to_string(stretch.first);
      if (stretch.last) text += " & " + x + "<=" + std::to_string(*stretch.last);
      if (!condition.empty()) text += " & (" + condition + ')';
      text += " -> " + updates_of(id, command.mode, stretch.moves, settled, naming) + ";\n";
    }
    return text;
  }

  [[nodiscard]] std::string updates_of(ComponentId id, ModeId mode, const std::vector<automata::Move>& moves,
                                       Units settled, const Naming& naming) const {
    const std::string m = naming.mode(id);
    const std::string x = naming.clock(id);
    const bool clocked = longest_reading(id) > 0;
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
    std::string condition = where.empty() ? "false" : verifier::text_of(where, own_names());
    if (condition.empty()) condition = "true";
    out_ << "\nlabel \"target\" = " << (drawn_ ? "m0>=0 & (" + condition + ")" : condition) << ";\n";
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
  /// Modules that are written out: by their modes and their text under common names, whose they are, and these names.
  std::map<std::pair<std::string, std::string>, std::pair<ComponentId, Naming>> written_;
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
