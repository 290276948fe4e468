// One step of a TCCA: the rules asked of the store, and what is remembered of their answers.
// SPDX-License-Identifier: MIT
#include "automata/step/plant_step.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rmpl::automata {
namespace {

/// How many whole states are remembered: so many that their modes, all together, are no more than this.
std::size_t states_remembered(const Plant& plant) {
  constexpr std::size_t modes_remembered = 1u << 16;
  return modes_remembered / (plant.components.size() + 1) + 1;
}

}  // namespace

class EnabledSets {
 public:
  explicit EnabledSets(const Plant& plant) {
    for (const Component& component : plant.components) by_mode_.emplace_back(component.modes.size());
  }

  /// The set with these members, by the bits of their positions among the exits; `make()` lists it the first time.
  template <class Make>
  const Enabled& find_or(ComponentId component, ModeId mode, const std::vector<std::uint64_t>& members,
                         const Make& make) {
    const auto [at, fresh] = by_mode_[component.index()][mode.index()].try_emplace(members);
    if (fresh) at->second = make();
    return at->second;
  }

 private:
  using Sets = std::unordered_map<std::vector<std::uint64_t>, Enabled, base::WordsHash>;
  std::vector<std::vector<Sets>> by_mode_;  ///< per component, per mode; looked up, never iterated
};

std::size_t PlantStep::StateActionHash::operator()(const StateAction& key) const noexcept {
  return base::mix_ids(base::mix_ids(base::hash_seed, key.modes), key.action);
}

PlantStep::PlantStep(const Plant& plant)
    : store_(plant),
      sets_(std::make_shared<EnabledSets>(plant)),
      has_restarts_(automata::has_restarts(plant)),
      enabled_(plant.components.size(), plant.controls.size()),
      wholes_(states_remembered(plant)) {
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const Component& component = plant.components[c];
    auto& exits = exits_.emplace_back(component.modes.size());
    auto& supports = supports_.emplace_back(component.modes.size());
    for (std::size_t i = 0; i < component.transitions.size(); ++i) {
      const Transition& t = component.transitions[i];
      supports[t.from.index()].join(locality().support_of(t.guard));
      if (can_ever_be_taken(t)) exits[t.from.index()].push_back({TransitionId(i), store_.watch(t.guard)});
    }
  }
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    auto& supports = commanded_supports_.emplace_back();
    Support all{{ComponentId(c)}, {}};
    for (const std::vector<Exit>& exits : exits_[c]) {
      Support& support = supports.emplace_back();
      for (const Exit& exit : exits) {
        for (const ConstraintStore::Part& part : exit.parts) support.join(store_.support_of(part));
      }
      all.join(support);
    }
    enabled_.add(all);
  }
  store_.prepare();
}

/// The set of those exits all of whose parts are implied.
template <class Implied>
const Enabled& PlantStep::sort_out(ComponentId id, ModeId mode, Implied&& implied) {
  const std::vector<Exit>& exits = exits_[id.index()][mode.index()];
  found_.assign((exits.size() + 63) / 64, 0);
  for (std::size_t i = 0; i < exits.size(); ++i) {
    const auto& parts = exits[i].parts;
    if (std::all_of(parts.begin(), parts.end(), implied)) found_[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  return sets_->find_or(id, mode, found_, [&] {
    Enabled set;
    for (std::size_t i = 0; i < exits.size(); ++i) {
      if ((found_[i / 64] >> (i % 64) & 1) != 0) add_enabled(set, plant()[id], exits[i].transition);
    }
    return set;
  });
}

const Enabled& PlantStep::enabled(ComponentId component, const Modes& modes, const ControlAction& action) {
  return sort_out(component, modes[component.index()],
                  [&](const ConstraintStore::Part& part) { return store_.implies(part, modes, action); });
}

PlantStep::Whole PlantStep::work_out(const Modes& modes, const ControlAction& action) {
  Whole result{consistent(modes, action), {}};
  result.enabled.from_ = sets_;
  result.enabled.sets_.reserve(modes.size());
  if (!result.consistent) {
    for (std::size_t c = 0; c < modes.size(); ++c) {
      result.enabled.sets_.push_back(
          &sort_out(ComponentId(c), modes[c], [](const ConstraintStore::Part&) { return true; }));
    }
    return result;
  }
  ConstraintStore::Consequences implied(store_, modes, action);
  enabled_.ask(modes, action);
  for (std::size_t c = 0; c < modes.size(); ++c) {
    auto& answer = enabled_[c];
    if (!answer) {
      answer =
          &sort_out(ComponentId(c), modes[c], [&implied](const ConstraintStore::Part& part) { return implied(part); });
    }
    result.enabled.sets_.push_back(*answer);
  }
  return result;
}

const PlantStep::Whole& PlantStep::whole(const Modes& modes, const ControlAction& action) {
  asked_.modes = modes;
  asked_.action = action;
  if (const Whole* known = wholes_.find(asked_)) return *known;
  return wholes_.add(asked_, work_out(modes, action));
}

const AllEnabled& PlantStep::enabled(const Modes& modes, const ControlAction& action) {
  return whole(modes, action).enabled;
}

const AllEnabled* PlantStep::enabled_if_permitted(const Modes& modes, const ControlAction& action) {
  const Whole& known = whole(modes, action);
  return known.consistent ? &known.enabled : nullptr;
}

bool PlantStep::permits(const Modes& modes, const ControlAction& action) { return whole(modes, action).consistent; }

std::vector<Move> PlantStep::moves(ComponentId component, ModeId mode, const Enabled& enabled, Ticks clock_start,
                                   Ticks before, Ticks now) const {
  auto result = moves_of(plant()[component], mode, enabled, now - clock_start, now - before);
  std::erase_if(result, [](const Move& move) { return move.probability <= std::numeric_limits<double>::min(); });
  return result;
}

const std::vector<std::vector<Move>>& PlantStep::moves(const SystemState& state, const ControlAction& action,
                                                       Ticks before, Ticks now) {
  const auto& allowed = enabled(state.modes, action);
  const Ticks step = now - before;
  const bool comparable = moved_.step == step && moved_.enabled.size() == allowed.size();
  moved_.moves.resize(allowed.size());
  for (std::size_t c = 0; c < allowed.size(); ++c) {
    const ComponentId id(c);
    // What is enabled tells the mode, too.
    if (comparable && &moved_.enabled[c] == &allowed[c] && !clock_matters(plant()[id], allowed[c])) continue;
    moved_.moves[c] = moves(id, state.modes[c], allowed[c], state.clock_starts[c], before, now);
  }
  moved_.enabled = allowed;
  moved_.step = step;
  return moved_.moves;
}

double PlantStep::probability(const SystemState& state, const ControlAction& action, Ticks before, Ticks now,
                              const Modes& next) {
  double product = 1;
  const auto& all = moves(state, action, before, now);
  for (std::size_t c = 0; c < all.size() && product > 0; ++c) {
    const auto at = std::find_if(all[c].begin(), all[c].end(), [&](const Move& m) { return m.mode == next[c]; });
    product *= at == all[c].end() ? 0.0 : at->probability;
  }
  return product;
}

bool PlantStep::leads(const SystemState& state, const ControlAction& action, Ticks before, Ticks now,
                      const Modes& next) {
  const AllEnabled& allowed = enabled(state.modes, action);
  for (std::size_t c = 0; c < next.size(); ++c) {
    const auto all =
        moves_of(plant().components[c], state.modes[c], allowed[c], now - state.clock_starts[c], now - before);
    if (std::none_of(all.begin(), all.end(), [&](const Move& m) { return m.mode == next[c]; })) return false;
  }
  return true;
}

const std::vector<bool>& PlantStep::restarted(const Modes& modes, const ControlAction& action) {
  restarted_.assign(modes.size(), false);
  if (!has_restarts_) return restarted_;
  const AllEnabled& all = enabled(modes, action);
  for (std::size_t c = 0; c < modes.size(); ++c) restarted_[c] = restarts(plant().components[c], all[c]);
  return restarted_;
}

SystemState PlantStep::advance(const SystemState& state, const ControlAction& action, const Modes& next, Ticks now) {
  return automata::advance(state, restarted(state.modes, action), next, now);
}

std::vector<std::vector<Move>> PlantStep::initial_moves() const {
  std::vector<std::vector<Move>> all;
  for (const Component& component : plant().components) all.push_back(initial_moves_of(component));
  return all;
}

}  // namespace rmpl::automata
