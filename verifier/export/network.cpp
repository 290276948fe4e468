// Tables of what guards, bounds and the store say, component by component.
// SPDX-License-Identifier: MIT
#include "verifier/export/network.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "automata/controls.hpp"
#include "automata/logic/truth_table.hpp"
#include "automata/step/transition_rules.hpp"
#include "base/product.hpp"
#include "verifier/behaviour/joint_choices.hpp"
#include "verifier/export/influence.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::Formula;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::Support;
using automata::TruthTable;
using automata::ValueId;
using automata::VariableId;

namespace {

using Values = std::vector<ValueId>;

/// The modes and controls that something depends on: a column each.
struct Columns {
  std::vector<ComponentId> components;
  std::vector<std::size_t> controls;
  std::vector<VariableId> variables;  ///< of both
  bool wide = false;                  ///< there are too many rows to look at all of them
};

/// What guards of a component in a mode read, and what they enable: under any free command, and under none.
struct Guards {
  Columns columns;
  std::map<Values, Enabled> rows, idle_rows;
};

/// What some constraints of the store say: whether modes are possible, and whether a command contradicts them.
struct Say {
  Columns columns;
  std::map<Values, bool> possible, consistent, idle_consistent;
};

class Building {
 public:
  Building(automata::PlantStep& step, const ExportQuestion& question, const Limits& limits, std::size_t most_rows)
      : step_(step),
        plant_(step.plant()),
        question_(question),
        meter_(limits),
        most_rows_(most_rows),
        idle_(automata::idle_action(plant_)),
        network_{TimeModel::dense(plant_, {}), {}, {}, {}, question.commands, question.faults},
        handle_(step.theory().encode(question.target)),
        influence_(step) {}

  Network run() {
    set_up();
    const bool wide = fill();
    if (wide) explore();
    for (const Say& say : says_) add_says(say);
    const auto initial = initial_modes(plant_, question_.from);
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      network_.processes.push_back(process(ComponentId(c), initial[c]));
    }
    TruthTable table(target_columns_.variables);
    for (const auto& [values, holds] : target_rows_) table.add(values, holds);
    network_.target = table.formula();
    return std::move(network_);
  }

 private:
  /// Columns of one kind of component together, so that instances of one type come to the same formulas.
  [[nodiscard]] Columns columns_of(const Support& support, std::optional<ComponentId> but) const {
    Columns columns;
    for (const ComponentId c : support.components) {
      if (c != but) columns.components.push_back(c);
    }
    std::stable_sort(columns.components.begin(), columns.components.end(),
                     [&](ComponentId a, ComponentId b) { return plant_[a].type < plant_[b].type; });
    columns.controls = support.controls;
    std::size_t rows = 1;
    const auto add = [&](VariableId variable) {
      columns.variables.push_back(variable);
      rows = std::min(rows * plant_.variables[variable].values.size(), most_rows_ + 1);
    };
    for (const ComponentId c : columns.components) add(plant_[c].mode);
    for (const std::size_t control : columns.controls) add(plant_.controls[control].variable);
    columns.wide = rows > most_rows_;
    return columns;
  }

  void set_up() {
    for (const Support& support : influence_.exclusions()) {
      says_.push_back({columns_of(support, std::nullopt), {}, {}, {}});
    }
    guards_.resize(plant_.components.size());
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      for (std::size_t m = 0; m < plant_.components[c].modes.size(); ++m) {
        guards_[c].push_back({columns_of(influence_.support_of(ComponentId(c), ModeId(m)), ComponentId(c)), {}, {}});
      }
    }
    const std::vector<VariableId> asked = automata::variables_of(question_.target);
    target_columns_ =
        columns_of({influence_.support_of(std::set(asked.begin(), asked.end()), false).components, {}}, std::nullopt);
  }

  /// Fills the tables that are not wide; whether there are others.
  bool fill() {
    bool wide = target_columns_.wide;
    for (Say& say : says_) {
      wide = wide || say.columns.wide;
      if (!say.columns.wide) for_each_row(say.columns, [&](const Values& values) { note(say, values); });
    }
    for (std::size_t c = 0; c < guards_.size(); ++c) {
      for (std::size_t m = 0; m < guards_[c].size(); ++m) {
        Guards& guards = guards_[c][m];
        wide = wide || guards.columns.wide;
        if (guards.columns.wide) continue;
        for_each_row(guards.columns, [&](const Values& values) { note(guards, ComponentId(c), ModeId(m), values); });
      }
    }
    if (!target_columns_.wide) for_each_row(target_columns_, [&](const Values& values) { note_target(values); });
    return wide;
  }

  /// `visit(values)` for all values of the columns that the free commands allow.
  template <class Visit>
  void for_each_row(const Columns& columns, const Visit& visit) {
    std::vector<Values> lists;
    for (const VariableId variable : columns.variables) {
      auto& values = lists.emplace_back();
      for (std::size_t v = 0; v < plant_.variables[variable].values.size(); ++v) values.emplace_back(v);
    }
    base::for_each_combination(lists, [&](const Values& values) {
      meter_.poll();
      if (permits(question_.commands, off_idle(columns, values))) visit(values);
    });
  }

  [[nodiscard]] std::size_t off_idle(const Columns& columns, const Values& values) const {
    std::size_t off = 0;
    for (std::size_t i = 0; i < columns.controls.size(); ++i) {
      if (values[columns.components.size() + i] != plant_.controls[columns.controls[i]].idle) ++off;
    }
    return off;
  }

  [[nodiscard]] static Values row_of(const Columns& columns, const Modes& modes, const ControlAction& action) {
    Values values;
    for (const ComponentId c : columns.components) values.emplace_back(modes[c.index()].index());
    for (const std::size_t control : columns.controls) values.push_back(action[control]);
    return values;
  }

  /// The store of some columns, the first `count` of them.
  static std::vector<Assignment> store_of(const Columns& columns, const Values& values, std::size_t count) {
    std::vector<Assignment> store;
    for (std::size_t i = 0; i < count; ++i) store.push_back({columns.variables[i], values[i]});
    return store;
  }

  void note(Say& say, const Values& values) {
    if (say.consistent.contains(values)) return;
    const Columns& columns = say.columns;
    const std::size_t modes = columns.components.size();
    const Values of_modes(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(modes));
    const auto [known, fresh] = say.possible.emplace(of_modes, false);
    if (fresh) known->second = step_.theory().consistent(store_of(columns, values, modes));
    if (!known->second) return;
    const bool fits = step_.theory().consistent(store_of(columns, values, values.size()));
    say.consistent.emplace(values, fits);
    if (off_idle(columns, values) == 0) say.idle_consistent.emplace(values, fits);
  }

  /// What is enabled, where the store of the columns contradicts nothing.
  void note(Guards& guards, ComponentId id, ModeId mode, const Values& values) {
    if (guards.rows.contains(values)) return;
    const Columns& columns = guards.columns;
    std::vector<Assignment> store = store_of(columns, values, values.size());
    store.push_back({plant_[id].mode, ValueId(mode.index())});
    if (!step_.theory().consistent(store)) return;
    Modes modes(plant_.components.size(), ModeId(0));
    ControlAction action = idle_;
    for (std::size_t i = 0; i < columns.components.size(); ++i) {
      modes[columns.components[i].index()] = ModeId(values[i].index());
    }
    for (std::size_t i = 0; i < columns.controls.size(); ++i) {
      action[columns.controls[i]] = values[columns.components.size() + i];
    }
    modes[id.index()] = mode;
    const Enabled& enabled = step_.enabled(id, modes, action);
    guards.rows.emplace(values, enabled);
    if (off_idle(columns, values) == 0) guards.idle_rows.emplace(values, enabled);
  }

  void note_target(const Values& values) {
    const std::vector<Assignment> store = store_of(target_columns_, values, values.size());
    if (target_rows_.contains(values) || !step_.theory().consistent(store)) return;
    target_rows_.emplace(
        values, question_.entailed ? step_.theory().entails(store, handle_) : step_.theory().allows(store, handle_));
  }

  /// Fills the wide tables with what can be met: time is not looked at, faults are counted.
  void explore() {
    std::map<Modes, unsigned> least;  // faults on the way there
    std::vector<std::vector<Modes>> open(question_.faults + 1);
    const auto come_to = [&](const Modes& modes, unsigned faults) {
      const auto [known, fresh] = least.emplace(modes, faults);
      if (!fresh && known->second <= faults) return;
      if (fresh) note_modes(modes);
      known->second = faults;
      if (step_.possible(modes)) open[faults].push_back(modes);
    };
    base::for_each_combination(initial_modes(plant_, question_.from), [&](const Modes& modes) { come_to(modes, 0); });
    for (unsigned faults = 0; faults < open.size(); ++faults) {
      for (std::size_t next = 0; next < open[faults].size(); ++next) {
        const Modes modes = open[faults][next];
        if (least.at(modes) < faults) continue;
        meter_.count_state();
        leave(modes, question_.faults - faults,
              [&](const JointChoice& joint) { come_to(joint.modes, faults + joint.faults); });
      }
    }
  }

  /// Modes that may be come to, possible or not.
  void note_modes(const Modes& modes) {
    for (Say& say : says_) {
      if (say.columns.wide) note(say, row_of(say.columns, modes, idle_));
    }
    if (!step_.possible(modes)) return;
    if (target_columns_.wide) note_target(row_of(target_columns_, modes, idle_));
  }

  /// Notes what is enabled in a state, and visits what may be done there.
  template <class Visit>
  void leave(const Modes& modes, unsigned faults, const Visit& visit) {
    std::set<std::vector<std::vector<Choice>>> seen;
    for_each_action(plant_, question_.commands, [&](const ControlAction& action) {
      meter_.poll();
      for (Say& say : says_) {
        if (say.columns.wide) note(say, row_of(say.columns, modes, action));
      }
      const bool fits = step_.consistent(modes, action);
      const automata::AllEnabled& enabled = step_.enabled(modes, action);
      std::vector<std::vector<Choice>> all;
      for (std::size_t c = 0; c < modes.size(); ++c) {
        Guards& guards = guards_[c][modes[c].index()];
        if (fits && guards.columns.wide) {
          const Values values = row_of(guards.columns, modes, action);
          guards.rows.emplace(values, enabled[c]);
          if (off_idle(guards.columns, values) == 0) guards.idle_rows.emplace(values, enabled[c]);
        }
        all.push_back(choices(plant_.components[c], modes[c], enabled[c], network_.time));
      }
      if (!seen.insert(all).second) return;
      for_each_joint(all, faults, [&](const JointChoice& joint) {
        meter_.poll();
        visit(joint);
      });
    });
  }

  static Formula formula_of(const Columns& columns, const std::map<Values, bool>& rows, std::size_t count) {
    TruthTable table({columns.variables.begin(), columns.variables.begin() + static_cast<std::ptrdiff_t>(count)});
    for (const auto& [values, holds] : rows) table.add(values, holds);
    return table.formula();
  }

  void add_says(const Say& say) {
    const auto holds_not = [](const auto& row) { return !row.second; };
    const auto add = [&](const std::map<Values, bool>& rows, std::size_t count, std::vector<Formula>& to) {
      if (std::any_of(rows.begin(), rows.end(), holds_not)) to.push_back(formula_of(say.columns, rows, count));
    };
    add(say.possible, say.columns.components.size(), network_.possible);
    add(say.consistent, say.columns.variables.size(), consistent_);
    add(say.idle_consistent, say.columns.variables.size(), idle_consistent_);
  }

  ComponentProcess process(ComponentId id, const std::vector<ModeId>& initial) const {
    const automata::Component& component = plant_[id];
    ComponentProcess process;
    process.initial = initial;
    process.clocked = std::any_of(component.transitions.begin(), component.transitions.end(),
                                  [](const automata::Transition& t) { return t.timing.has_value(); });
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      add_steps(process, id, ModeId(m));
      add_rests(process, id, ModeId(m));
    }
    return process;
  }

  /// What a store that contradicts itself enables: everything.
  [[nodiscard]] Enabled everything(ComponentId id, ModeId mode) const {
    return automata::enabled_in(plant_[id], mode, [](automata::TransitionId) { return true; });
  }

  void add_steps(ComponentProcess& process, ComponentId id, ModeId mode) const {
    const Guards& guards = guards_[id.index()][mode.index()];
    std::map<Taken, Formula> all;
    std::vector<std::pair<const Values*, std::vector<Taken>>> rows;
    for (const auto& [values, enabled] : guards.rows) {
      rows.emplace_back(&values, taken(id, mode, enabled));
      for (const Taken& choice : rows.back().second) all.emplace(choice, Formula{});
    }
    for (auto& [choice, where] : all) {
      if (choice.first.faults > question_.faults) continue;
      TruthTable table(guards.columns.variables);
      for (const auto& [values, of] : rows) table.add(*values, std::find(of.begin(), of.end(), choice) != of.end());
      where = both(consistent_, table.formula());
    }
    for (const auto& [choice, where] : all) add_step(process, mode, choice, where);
    if (consistent_.empty()) return;
    const Formula contradicted = automata::negation(automata::conjunction(consistent_));
    for (const Taken& choice : taken(id, mode, everything(id, mode))) add_step(process, mode, choice, contradicted);
  }

  /// A choice, and whether the clock starts anew with it.
  using Taken = std::pair<Choice, bool>;
  [[nodiscard]] std::vector<Taken> taken(ComponentId id, ModeId mode, const Enabled& enabled) const {
    std::vector<Taken> result;
    for (const Choice& choice : dull(choices(plant_[id], mode, enabled, network_.time))) {
      const bool anew = choice.mode != mode || automata::restarts(plant_[id], enabled);
      result.emplace_back(choice, anew && plant_.has_timed_exit(id, choice.mode));
    }
    return result;
  }

  /// Which ends of an interval are sharp is of no account for who has instants.
  static std::vector<Choice> dull(std::vector<Choice> choices) {
    for (Choice& choice : choices) choice.sharp = {};
    return choices;
  }

  void add_step(ComponentProcess& process, ModeId mode, const Taken& taken, const Formula& where) const {
    const auto& [choice, restarts] = taken;
    if (where == automata::constant(false) || choice.faults > question_.faults) return;
    process.steps.push_back({mode, choice.mode, where, choice.clock, choice.faults > 0, restarts});
  }

  void add_rests(ComponentProcess& process, ComponentId id, ModeId mode) const {
    const Guards& guards = guards_[id.index()][mode.index()];
    const auto waits_of = [&](const Enabled& enabled) {
      const bool restarts = automata::restarts(plant_[id], enabled) && plant_.has_timed_exit(id, mode);
      return Waits(waits(plant_[id], mode, enabled, network_.time), restarts);
    };
    std::map<Waits, std::vector<const Values*>> all;
    for (const auto& [values, enabled] : guards.idle_rows) all[waits_of(enabled)].push_back(&values);
    for (const auto& [waits, rows] : all) {
      TruthTable table(guards.columns.variables);
      for (const auto& [other, values] : all) {
        for (const Values* of : values) table.add(*of, other == waits);
      }
      add_rests(process, mode, both(idle_consistent_, table.formula()), waits);
    }
    if (idle_consistent_.empty()) return;
    const Formula contradicted = automata::negation(automata::conjunction(idle_consistent_));
    add_rests(process, mode, contradicted, waits_of(everything(id, mode)));
  }

  /// See `waits` in choices.hpp, and whether they are of a clock that restarts.
  using Waits = std::pair<std::vector<Interval>, bool>;

  static void add_rests(ComponentProcess& process, ModeId mode, const Formula& where, const Waits& of) {
    const auto& [waits, restarts] = of;
    if (restarts) {
      for (const Interval& wait : waits) process.rests.push_back({mode, where, wait, false, true});
      process.rests.push_back({mode, where, {}, true});
      return;
    }
    for (const Interval& wait : waits) process.rests.push_back({mode, where, wait, false});
    // At the end of a wait no time can pass either way.
    for (const Interval& halt : gaps(waits)) process.rests.push_back({mode, where, halt, true});
  }

  static Formula both(const std::vector<Formula>& some, const Formula& other) {
    if (some.empty() || other == automata::constant(false)) return other;
    std::vector<Formula> all = some;
    if (!other.is_true()) all.push_back(other);
    return automata::conjunction(std::move(all));
  }

  automata::PlantStep& step_;
  const Plant& plant_;
  const ExportQuestion& question_;
  Meter meter_;
  const std::size_t most_rows_;  ///< of a table that is made of all of them
  const ControlAction idle_;
  Network network_;
  automata::Theory::Handle handle_;  ///< of the target
  Influence influence_;
  std::vector<Say> says_;
  std::vector<std::vector<Guards>> guards_;  ///< by component, by mode
  Columns target_columns_;
  std::map<Values, bool> target_rows_;
  std::vector<Formula> consistent_;       ///< where a command contradicts no modes: all of it
  std::vector<Formula> idle_consistent_;  ///< the same where all controls are idle
};

}  // namespace

Network network_of(automata::PlantStep& step, const ExportQuestion& question, const Limits& limits,
                   std::size_t most_rows) {
  return Building(step, question, limits, most_rows).run();
}

}  // namespace rmpl::verifier
