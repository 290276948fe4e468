// Plants in sampled time for PRISM: one module a component, synchronised on the control action of a period. Control
// actions that do the same are one, and so is what a module does in several modes. Modules that read the same, but for
// names, are one with other names.
//
// Given modes, clocks and the control action components draw independently (verifier/markov), which is what
// synchronised modules do.
// SPDX-License-Identifier: MIT
#include "verifier/export/prism.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/error.hpp"
#include "verifier/export/impossible_draws.hpp"
#include "verifier/export/influence.hpp"
#include "verifier/export/prism_text.hpp"
#include "verifier/markov/markov.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Plant;
using automata::PlantStep;
using prism::conjoin;
using prism::member_text;
using prism::Naming;
using prism::number;
using prism::Text;

namespace {

/// What a component draws from in a mode under a control action, where that is so.
struct Command {
  ModeId mode;
  automata::Formula where;
  std::vector<Stretch> stretches;  ///< of readings over which the probabilities are the same
  bool restarts = false;           ///< the clock starts anew
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
        influence_(step),
        initial_(initial_modes(plant_, question.from)) {
    for_each_action(plant_, question.commands, [this](const ControlAction& action) { actions_.push_back(action); });
    const auto drawn = [](const automata::Component& c) {
      return std::count_if(c.initial.begin(), c.initial.end(), [](double p) { return p > 0; }) > 1;
    };
    drawn_ = std::any_of(plant_.components.begin(), plant_.components.end(), drawn) && question.from.empty();
  }

  void run() {
    refuse_impossible_draws(step_, influence_, initial_, actions_, meter_);
    classify();
    const bool choice = classes_ > 1;
    out_ << (choice ? "mdp" : "dtmc") << "\n\n// " << plant_.name << ": a step is a period of "
         << automata::format_seconds(period_) << " s\n";
    if (drawn_) out_ << "// the first step, `start`, takes no time: it draws the initial modes\n";
    out_ << "// what is asked: " << (choice ? "Pmax" : "P") << "=? [ F \"target\" ]\n";
    for (std::size_t a = 0; a < actions_.size(); ++a) {
      out_ << "// a" << class_of_[a] << ": " << describe(plant_, actions_[a]) << '\n';
    }
    for (std::size_t c = 0; c < plant_.components.size(); ++c) write_module(ComponentId(c));
    write_target();
  }

 private:
  static constexpr std::size_t unnamed = static_cast<std::size_t>(-1);

  /// As `verifier::settled_reading`; throws where there is none.
  [[nodiscard]] Units settled_reading(ComponentId component, ModeId mode) const {
    const auto reading = verifier::settled_reading(plant_[component], mode, period_);
    if (reading) return *reading;
    throw base::InputError("prism cannot say a hazard that goes on changing for ever: the density of a transition of " +
                           plant_[component].name +
                           " is not exponential and has no upper bound; expected a finite one");
  }

  /// Finds out what each component does under each control action, and which of these do the same to all of them.
  void classify() {
    std::map<std::vector<std::string>, std::size_t> known;
    for (std::size_t a = 0; a < actions_.size(); ++a) {
      std::vector<std::vector<Command>> commands;
      std::vector<std::string> texts;
      for (std::size_t c = 0; c < plant_.components.size(); ++c) {
        commands.push_back(commands_of(ComponentId(c), actions_[a]));
        texts.push_back(text_of(ComponentId(c), commands.back(), "", own_names()));
      }
      const auto [like, fresh] = known.emplace(std::move(texts), classes_);
      class_of_.push_back(like->second);
      if (!fresh) continue;
      commands_.push_back(std::move(commands));
      ++classes_;
    }
  }

  /// Most commands are of no account for most components: what is read of them tells what comes of it.
  std::vector<Command> commands_of(ComponentId id, const ControlAction& action) {
    std::vector<Command> commands;
    for (std::size_t m = 0; m < plant_[id].modes.size(); ++m) {
      const ModeId mode(m);
      const automata::Support& support = influence_.support_of(id, mode);
      ControlAction read;
      for (const std::size_t control : support.controls) read.push_back(action[control]);
      const auto [known, fresh] = known_.emplace(std::tuple(id, mode, read), std::vector<Command>());
      if (fresh) {
        const Units settled = settled_reading(id, mode);
        for (const EnabledClass& choice : enabled_classes(step_, id, mode, action, support.components, meter_)) {
          known->second.push_back({mode, choice.where, stretches(step_, id, mode, choice.enabled, period_, settled),
                                   automata::restarts(plant_[id], choice.enabled)});
        }
      }
      commands.insert(commands.end(), known->second.begin(), known->second.end());
    }
    return commands;
  }

  /// A module of its own; or where one before it reads the same, but for what components and commands are called, that
  /// one with other names.
  void write_module(ComponentId id) {
    const Naming common = common_naming(id);
    const std::string text = body_of(id, common);
    const automata::Component& component = plant_[id];
    std::string modes;
    for (std::size_t mode = 0; mode < component.modes.size(); ++mode) {
      modes += (mode == 0 ? "" : ", ") + std::to_string(mode) + ' ' + component.modes[mode].name;
    }
    out_ << "\nmodule c" << id.value;
    const auto [like, fresh] = written_.emplace(std::pair(modes, text), std::pair(id, common));
    if (fresh) {
      out_ << " // " << component.name << "\n  // " << modes << '\n' << body_of(id, own_names()) << "endmodule\n";
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
    for (std::size_t a = 0; a < classes_; ++a) naming.labels.push_back(a);
    return naming;
  }

  /// Names that like modules have in common: the component itself first, those that it reads by their types, commands
  /// by what they do to it.
  [[nodiscard]] Naming common_naming(ComponentId id) const {
    Naming naming{std::vector<std::size_t>(plant_.components.size(), unnamed), std::vector<std::size_t>(classes_)};
    std::set<ComponentId> read;
    for (const auto& by_component : commands_) {
      for (const Command& command : by_component[id.index()]) {
        for (const automata::VariableId mode : automata::variables_of(command.where)) {
          read.insert(*plant_.component_of(mode));
        }
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
    for (std::size_t a = 0; a < classes_; ++a) {
      by_effect.emplace_back(text_of(id, commands_[a][id.index()], "", naming), a);
    }
    std::sort(by_effect.begin(), by_effect.end());
    for (std::size_t place = 0; place < by_effect.size(); ++place) naming.labels[by_effect[place].second] = place;
    return naming;
  }

  [[nodiscard]] Units longest_reading(ComponentId id) const {
    Units longest = 0;
    for (std::size_t m = 0; m < plant_[id].modes.size(); ++m)
      longest = std::max(longest, settled_reading(id, ModeId(m)));
    return longest;
  }

  /// Variables and commands.
  [[nodiscard]] std::string body_of(ComponentId id, const Naming& naming) const {
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
    std::vector<std::size_t> classes(classes_);
    for (std::size_t a = 0; a < classes_; ++a) classes[naming.labels[a]] = a;
    for (const std::size_t a : classes) text += text_of(id, commands_[a][id.index()], naming.label(a), naming);
    return text;
  }

  /// A line for each thing that is done, whatever the modes.
  [[nodiscard]] std::string text_of(ComponentId id, const std::vector<Command>& commands, const std::string& label,
                                    const Naming& naming) const {
    const std::string x = naming.clock(id);
    /// Of one of them: where it is done but for the own mode, and in which modes.
    using Done = std::vector<std::pair<std::string, std::vector<std::size_t>>>;
    std::vector<std::pair<std::string, Done>> by_updates;  // as they are met
    const auto find = [](auto& list, const std::string& key) -> auto& {
      const auto found = std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.first == key; });
      return (found == list.end() ? list.emplace_back(key, decltype(found->second)()) : *found).second;
    };
    for (const Command& command : commands) {
      const Units settled = settled_reading(id, command.mode);
      for (const Stretch& stretch : command.stretches) {
        std::string where;
        if (stretch.first > 0) conjoin(where, x + ">=" + std::to_string(stretch.first));
        if (stretch.last) conjoin(where, x + "<=" + std::to_string(*stretch.last));
        if (!command.where.is_true()) conjoin(where, prism::text_of(command.where, plant_, naming).operand());
        find(find(by_updates, updates_of(id, command, stretch.moves, settled, naming)), where)
            .push_back(command.mode.index());
      }
    }
    std::string text;
    for (const auto& [updates, done] : by_updates) {
      std::string guard;
      for (const auto& [where, modes] : done) {
        const std::size_t all = plant_[id].modes.size();
        std::string all_of;
        if (modes.size() < all) {
          all_of = member_text(naming.mode(id), modes, all, drawn_).operand();
        } else if (drawn_) {
          all_of = naming.mode(id) + ">=0";
        }
        conjoin(all_of, where);
        if (all_of.empty()) all_of = "true";
        guard += (guard.empty() ? "" : " | ") + (done.size() == 1 ? all_of : "(" + all_of + ")");
      }
      text += "  [" + label + "] " + guard + " -> " + updates + ";\n";
    }
    return text;
  }

  /// What stays as it is is not told.
  [[nodiscard]] std::string updates_of(ComponentId id, const Command& command, const std::vector<automata::Move>& moves,
                                       Units settled, const Naming& naming) const {
    const std::string m = naming.mode(id);
    const std::string x = naming.clock(id);
    const bool clocked = longest_reading(id) > 0;
    std::string text;
    for (const automata::Move& move : moves) {
      std::string update;
      if (move.mode != command.mode) update = "(" + m + "'=" + std::to_string(move.mode.value) + ")";
      if (clocked) {
        const bool runs = move.mode == command.mode && settled > 0 && !command.restarts;
        conjoin(update, "(" + x + "'=" + (runs ? "min(" + x + "+1," + std::to_string(settled) + ")" : "0") + ")");
      }
      text += (text.empty() ? "" : " + ") + number(move.probability) + ":" + (update.empty() ? "true" : update);
    }
    return text;
  }

  void write_target() {
    const std::vector<automata::VariableId> asked = automata::variables_of(question_.target);
    const automata::Formula where =
        where_holds(step_, question_.target, question_.entailed,
                    influence_.support_of(std::set(asked.begin(), asked.end()), false).components, meter_);
    const Text condition = prism::text_of(where, plant_, own_names());
    out_ << "\nlabel \"target\" = " << (drawn_ ? "m0>=0 & " + condition.operand() : condition.text) << ";\n";
  }

  std::ostream& out_;
  PlantStep& step_;
  const Plant& plant_;
  const ExportQuestion& question_;
  automata::Ticks period_;
  Meter meter_;
  Influence influence_;
  std::vector<std::vector<ModeId>> initial_;  ///< by component
  std::vector<ControlAction> actions_;
  std::vector<std::size_t> class_of_;                        ///< by control action
  std::vector<std::vector<std::vector<Command>>> commands_;  ///< by class of control actions, by component
  std::size_t classes_ = 0;
  std::map<std::tuple<ComponentId, ModeId, ControlAction>, std::vector<Command>> known_;  ///< by what controls tell
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
