// The Markov structure of a plant in sampled time.
// SPDX-License-Identifier: MIT
#include "verifier/markov/markov.hpp"

#include <algorithm>

#include "automata/logic/truth_table.hpp"
#include "base/product.hpp"
#include "verifier/zone/time_model.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::ModeId;
using automata::Modes;
using automata::Move;
using automata::Plant;
using automata::PlantStep;
using automata::Ticks;

namespace {

/// All modes of each of the components.
std::vector<std::vector<ModeId>> modes_of(const Plant& plant, const std::vector<ComponentId>& components) {
  std::vector<std::vector<ModeId>> result;
  for (const ComponentId c : components) {
    auto& modes = result.emplace_back();
    for (std::size_t m = 0; m < plant[c].modes.size(); ++m) modes.emplace_back(m);
  }
  return result;
}

/// Those of one type together, so that instances of one type come to the same formulas.
void sort_by_type(const Plant& plant, std::vector<ComponentId>& components) {
  std::stable_sort(components.begin(), components.end(),
                   [&](ComponentId a, ComponentId b) { return plant[a].type < plant[b].type; });
}

/// For combinations of modes of some components, a number each; asked where each number is.
class Cases {
 public:
  Cases(const Plant& plant, const std::vector<ComponentId>& components) {
    for (const ComponentId c : components) columns_.push_back(plant[c].mode);
  }

  void add(const std::vector<ModeId>& modes, std::size_t number) {
    std::vector<automata::ValueId>& row = rows_.emplace_back(std::vector<automata::ValueId>(), number).first;
    for (const ModeId mode : modes) row.emplace_back(mode.index());
  }

  [[nodiscard]] automata::Formula where(std::size_t number) const {
    automata::TruthTable table(columns_);
    for (const auto& [row, of] : rows_) table.add(row, of == number);
    return rows_.empty() ? automata::constant(false) : table.formula();
  }

 private:
  std::vector<automata::VariableId> columns_;
  std::vector<std::pair<std::vector<automata::ValueId>, std::size_t>> rows_;
};

void assume(const Plant& plant, const std::vector<ComponentId>& components, const std::vector<ModeId>& modes,
            std::vector<Assignment>& store) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    store.push_back({plant[components[i]].mode, automata::ValueId(modes[i].index())});
  }
}

bool same(const Enabled& a, const Enabled& b) {
  return a.faults == b.faults && a.untimed == b.untimed && a.timed == b.timed;
}

bool same(const std::vector<Move>& a, const std::vector<Move>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Move& x, const Move& y) { return x.mode == y.mode && x.probability == y.probability; });
}

}  // namespace

std::vector<EnabledClass> enabled_classes(PlantStep& step, ComponentId component, ModeId mode,
                                          const ControlAction& action, std::vector<ComponentId> read, Meter& meter) {
  const Plant& plant = step.plant();
  std::erase(read, component);
  sort_by_type(plant, read);
  std::vector<EnabledClass> classes;
  Cases cases(plant, read);
  base::for_each_combination(modes_of(plant, read), [&](const std::vector<ModeId>& chosen) {
    meter.poll();
    std::vector<Assignment> store = automata::assignments_of(plant, action);
    assume(plant, read, chosen, store);
    assume(plant, {component}, {mode}, store);
    if (!step.theory().consistent(store)) return;
    Modes modes(plant.components.size(), ModeId(0));
    for (std::size_t i = 0; i < chosen.size(); ++i) modes[read[i].index()] = chosen[i];
    modes[component.index()] = mode;
    const Enabled& enabled = step.enabled(component, modes, action);
    const auto known = std::find_if(classes.begin(), classes.end(),
                                    [&](const EnabledClass& other) { return same(other.enabled, enabled); });
    cases.add(chosen, static_cast<std::size_t>(known - classes.begin()));
    if (known == classes.end()) classes.push_back({enabled, {}});
  });
  for (std::size_t k = 0; k < classes.size(); ++k) classes[k].where = cases.where(k);
  return classes;
}

automata::Formula where_holds(PlantStep& step, const automata::Formula& formula, bool certain,
                              std::vector<ComponentId> read, Meter& meter) {
  const Plant& plant = step.plant();
  sort_by_type(plant, read);
  const automata::Theory::Handle handle = step.theory().encode(formula);
  Cases cases(plant, read);
  base::for_each_combination(modes_of(plant, read), [&](const std::vector<ModeId>& chosen) {
    meter.poll();
    std::vector<Assignment> store;
    assume(plant, read, chosen, store);
    if (!step.theory().consistent(store)) return;
    const bool holds = certain ? step.theory().entails(store, handle) : step.theory().allows(store, handle);
    cases.add(chosen, holds ? 1 : 0);
  });
  return cases.where(1);
}

std::optional<Units> settled_reading(const automata::Component& component, ModeId mode, Ticks period) {
  const TimeModel time = TimeModel::sampled(period);
  Units last = 0;
  for (const automata::Transition& t : component.transitions) {
    if (t.from != mode || !t.timing) continue;
    const bool endless = t.timing->upper.is_infinite();
    const bool changes = t.timing->density.kind != automata::Density::Kind::exponential && !component.is_fault(t);
    if (endless && changes) return std::nullopt;
    last = std::max(last, time.at_least(endless ? t.timing->lower : t.timing->upper));
  }
  return last;
}

std::vector<Stretch> stretches(const PlantStep& step, ComponentId component, ModeId mode, const Enabled& enabled,
                               Ticks period, Units settled) {
  std::vector<Stretch> result;
  for (Units reading = 0; reading <= settled; ++reading) {
    const Ticks before{reading * period.count};
    const Ticks now{before.count + period.count};
    std::vector<Move> moves = step.moves(component, mode, enabled, Ticks{0}, before, now);
    if (!result.empty() && same(result.back().moves, moves)) continue;
    if (!result.empty()) result.back().last = reading - 1;
    result.push_back({reading, std::nullopt, std::move(moves)});
  }
  return result;
}

}  // namespace rmpl::verifier
