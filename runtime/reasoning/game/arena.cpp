// The part of a plant that a game is played in: tables of what each component may do, and the actions that matter.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/arena.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "automata/clock_use.hpp"
#include "base/hash.hpp"
#include "runtime/reasoning/nominal/idling.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Ticks;
using automata::ValueId;

namespace {

/// Rewards beyond ten thousand millions count as that, so that their sums are numbers.
std::int64_t millionths(double reward) {
  constexpr double greatest = 1e16;
  return std::llround(std::clamp(reward * 1e6, -greatest, greatest));
}

}  // namespace

std::size_t Arena::KeyHash::operator()(const std::vector<std::uint16_t>& key) const noexcept {
  std::uint64_t hash = base::hash_seed;
  for (const std::uint16_t word : key) hash = base::mix(hash, word);
  return hash;
}

Arena::Arena(automata::PlantStep& step, const NominalGraph& graph, const GameGoal& goal, std::vector<std::size_t> parts,
             std::vector<ComponentId> components, const Modes& start, Excludes excludes)
    : step_(step),
      graph_(graph),
      goal_(goal),
      idle_(idle_action(step.plant())),
      parts_(std::move(parts)),
      components_(std::move(components)),
      member_(step.plant().components.size()),
      start_(start) {
  const automata::Plant& plant = step.plant();
  for (std::size_t i = 0; i < components_.size(); ++i) member_[components_[i].index()] = i;
  for (std::size_t member = 0; member < components_.size(); ++member) {
    auto& known = known_.emplace_back();
    for (std::size_t m = 0; m < plant[components_[member]].modes.size(); ++m)
      known.emplace_back(plant, deciding(components_[member], ModeId(m)));
  }
  moves_by_member_.resize(components_.size());
  find_controls(excludes);
  find_context(excludes);
}

void Arena::find_controls(Excludes excludes) {
  const std::size_t count = plant().controls.size();
  std::vector<std::vector<std::size_t>> readers(count);  // by control, members
  std::vector<bool> coupled(count);
  for (std::size_t member = 0; member < components_.size(); ++member) {
    for (std::size_t m = 0; m < plant()[components_[member]].modes.size(); ++m) {
      for (const std::size_t i : deciding(components_[member], ModeId(m)).controls) {
        if (readers[i].empty() || readers[i].back() != member) readers[i].push_back(member);
      }
    }
  }
  const auto& islands = step_.locality().islands();
  for (std::size_t island = 0; island < islands.size(); ++island) {
    const auto& together = islands[island].support.controls;
    const bool ours = std::any_of(together.begin(), together.end(), [&](std::size_t i) { return !readers[i].empty(); });
    if (!ours || !excludes(island)) continue;
    for (const std::size_t i : together) coupled[i] = true;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (readers[i].empty() && !coupled[i]) continue;
    controls_.push_back(i);
    coupled_.push_back(coupled[i]);
    read_by_.push_back(std::move(readers[i]));
  }
}

std::vector<ComponentId> Arena::readers(const Modes& modes) const {
  std::vector<ComponentId> result;
  for (std::size_t c = 0; c < plant().components.size(); ++c) {
    if (member_[c]) continue;
    const automata::Support& support = deciding(ComponentId(c), modes[c]);
    const bool reads = std::any_of(support.components.begin(), support.components.end(),
                                   [&](ComponentId other) { return member_[other.index()].has_value(); }) ||
                       std::any_of(support.controls.begin(), support.controls.end(), [&](std::size_t i) {
                         return std::binary_search(controls_.begin(), controls_.end(), i);
                       });
    if (reads) result.emplace_back(c);
  }
  return result;
}

const automata::Support& Arena::deciding(ComponentId c, ModeId mode) const {
  const auto& known = graph_.deciding(c, mode);
  return known ? *known : step_.support(c, mode);
}

void Arena::find_context(Excludes excludes) {
  std::vector<bool> rests_on(member_.size());
  const auto add = [&](const std::vector<ComponentId>& components) {
    for (const ComponentId c : components) rests_on[c.index()] = rests_on[c.index()] || !member_[c.index()];
  };
  for (const ComponentId c : components_) {
    for (std::size_t m = 0; m < plant()[c].modes.size(); ++m) add(deciding(c, ModeId(m)).components);
  }
  const auto& islands = step_.locality().islands();
  for (std::size_t i = 0; i < islands.size(); ++i) {
    const auto& read = islands[i].support.components;
    const auto& commanded = islands[i].support.controls;
    const bool ours =
        std::any_of(read.begin(), read.end(), [&](ComponentId c) { return member_[c.index()].has_value(); }) ||
        std::any_of(commanded.begin(), commanded.end(), [&](std::size_t control) {
          return std::binary_search(controls_.begin(), controls_.end(), control);
        });
    if (ours && excludes(i)) add(read);
  }
  for (const std::size_t part : parts_) add(goal_.read_by(part));
  for (std::size_t c = 0; c < rests_on.size(); ++c) {
    if (rests_on[c]) context_.emplace_back(c);
  }
}

void Arena::restrict_to_useful() {
  std::vector<WantedModes> wanted;
  for (const std::size_t part : parts_) {
    for (WantedModes& more : goal_.wanted(part)) wanted.push_back(std::move(more));
  }
  for (std::size_t i = 0; i < components_.size() && parts_.empty(); ++i) {
    const auto& modes = plant()[components_[i]].modes;
    const double now = modes[start_[components_[i].index()].index()].reward;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (modes[m].reward > now) wanted.emplace_back(components_[i], std::vector<bool>(modes.size())).second[m] = true;
    }
  }
  useful_.emplace(graph_, std::move(wanted));
}

/// Whether a value of a control lets the component take a useful step that it may not take without, or keeps it from a
/// step that is none.
bool Arena::serves(std::size_t member, const Modes& modes, const LocalMoves& with, const LocalMoves& without) const {
  const ComponentId c = components_[member];
  const auto differs = [&](const LocalMoves& a, const LocalMoves& b, bool useful) {
    return std::any_of(a.exits.begin(), a.exits.end(), [&](const LocalMoves::Exit& exit) {
      return exit.to != modes[c.index()] && useful_->has(c, exit.transition) == useful &&
             std::find(b.exits.begin(), b.exits.end(), exit) == b.exits.end();
    });
  };
  return differs(with, without, true) || differs(without, with, false);
}

std::int64_t Arena::reward(std::size_t member, ModeId mode) const {
  return millionths(plant()[components_[member]].modes[mode.index()].reward);
}

std::vector<std::uint16_t> Arena::start() const {
  std::vector<std::uint16_t> modes;
  for (const ComponentId c : components_) modes.push_back(static_cast<std::uint16_t>(start_[c.index()].index()));
  return modes;
}

/// By preconditions where all of them are known: no store is asked then.
automata::Enabled Arena::enabled_of(ComponentId c, const Modes& modes, const ControlAction& action) {
  if (!graph_.deciding(c, modes[c.index()])) return step_.enabled(c, modes, action);
  automata::Enabled enabled;
  for (const NominalTransition& t : graph_.transitions(c)) {
    if (t.from == modes[c.index()] && graph_.met(t, modes, action)) automata::add_enabled(enabled, plant()[c], t.id);
  }
  return enabled;
}

LocalMoves Arena::moves_of(ComponentId c, const Modes& modes, const ControlAction& action) {
  return moves_with(c, modes[c.index()], enabled_of(c, modes, action));
}

LocalMoves Arena::moves_with(ComponentId c, ModeId mode, const automata::Enabled& enabled) const {
  const automata::Component& component = plant()[c];
  LocalMoves result;
  result.untimed = !enabled.untimed.empty();
  result.restarts = automata::restarts(component, enabled) && automata::needs_clock(component, mode);
  for (const automata::TransitionId id : result.untimed ? enabled.untimed : enabled.timed) {
    const automata::Transition& t = component.transitions[id.index()];
    if (t.timing && t.to == mode) {
      result.dawdles = true;
      continue;
    }
    const NominalTransition* nominal = graph_.find(c, id);
    const LocalMoves::Exit exit{.transition = id,
                                .to = t.to,
                                .lower = t.timing ? t.timing->lower : Ticks{},
                                .upper = t.timing ? t.timing->upper : Ticks{},
                                .branch = t.branch,
                                .irreversible = nominal != nullptr && nominal->irreversible,
                                .licensed = goal_.licenses(c, id)};
    const auto known = std::find_if(result.exits.begin(), result.exits.end(), [&](const LocalMoves::Exit& e) {
      return e.to == exit.to && (result.untimed || e.transition == exit.transition);
    });
    if (known == result.exits.end()) result.exits.push_back(exit);
  }
  return result;
}

const LocalMoves* Arena::local(std::size_t member, const Modes& modes, const ControlAction& action) {
  const ComponentId c = components_[member];
  return known_[member][modes[c.index()].index()].find(
      modes, action, [&]() -> const LocalMoves* { return kept(member, moves_of(c, modes, action)); });
}

const LocalMoves* Arena::kept(std::size_t member, LocalMoves moves) {
  auto& all = moves_by_member_[member];
  const auto equal = std::find_if(all.begin(), all.end(), [&](const LocalMoves* m) { return *m == moves; });
  if (equal != all.end()) return *equal;
  moves_.push_back(std::move(moves));
  return all.emplace_back(&moves_.back());
}

std::uint32_t Arena::number_of(const ControlAction& action) {
  auto& numbers = action_numbers_[base::mix_ids(base::hash_seed, action)];
  for (const std::uint32_t number : numbers) {
    if (actions_[number] == action) return number;
  }
  actions_.push_back(action);
  Order& order = orders_.emplace_back();
  for (std::size_t i = 0; i < action.size(); ++i) {
    if (action[i] != idle_[i]) order.emplace_back(i, action[i]);
  }
  numbers.push_back(static_cast<std::uint32_t>(actions_.size() - 1));
  return numbers.back();
}

std::optional<std::uint32_t> Arena::find(const std::vector<std::uint16_t>& key) {
  const auto [at, fresh] = numbers_.try_emplace(key);
  if (!fresh) return at->second;
  Modes modes = start_;
  for (std::size_t i = 0; i < components_.size(); ++i) modes[components_[i].index()] = ModeId(key[i]);
  const bool free = key.size() > components_.size() && key.back() != 0;
  if (!tolerates(modes, free)) return std::nullopt;
  Position position;
  position.free = free;
  for (std::size_t i = 0; i < components_.size(); ++i) position.reward += reward(i, ModeId(key[i]));
  position.held = goal_.held(modes, parts_);
  position.goal = std::find(position.held.begin(), position.held.end(), false) == position.held.end();
  position.modes = std::move(modes);
  at->second = static_cast<std::uint32_t>(positions_.size());
  positions_.push_back(std::move(position));
  listed_.push_back(false);
  return at->second;
}

bool Arena::tolerates(const Modes& modes, bool /*free*/) { return step_.possible(modes); }

std::vector<std::pair<ComponentId, ModeId>> Arena::conflict(const std::vector<std::uint16_t>& key) {
  Modes modes = start_;
  for (std::size_t i = 0; i < components_.size(); ++i) modes[components_[i].index()] = ModeId(key[i]);
  std::vector<std::pair<ComponentId, ModeId>> result;
  for (const ComponentId c : step_.conflict(modes)) result.emplace_back(c, modes[c.index()]);
  return result;
}

const Position& Arena::at(std::uint32_t number) {
  Position& position = positions_[number];
  if (!listed_[number]) {
    listed_[number] = true;
    list_actions(position);
  }
  return position;
}

std::vector<std::vector<ValueId>> Arena::values_that_matter(const Position& position, const ControlAction& base) {
  // A value matters where some component may do under it what it may not under an earlier one, whatever the other
  // controls that this component reads have for values.
  std::vector<std::vector<ValueId>> kept;
  ControlAction action = base;
  std::vector<const LocalMoves*> effect;
  std::vector<std::size_t> members;  // of the entries of the effect
  for (std::size_t at = 0; at < controls_.size(); ++at) {
    const std::size_t i = controls_[at];
    const std::size_t count = plant().variables[plant().controls[i].variable].values.size();
    std::vector<ValueId> values{base[i]};
    for (std::size_t v = 0; v < count; ++v) {
      if (ValueId(v) != base[i]) values.emplace_back(v);
    }
    std::vector<std::vector<const LocalMoves*>> effects;
    std::vector<ValueId> different;
    for (const ValueId v : values) {
      effect.clear();
      members.clear();
      action[i] = v;
      const bool tolerated = step_.consistent(position.modes, action);
      effect.push_back(nullptr);
      members.push_back(0);
      for (const std::size_t member : read_by_[at]) {
        const ComponentId c = components_[member];
        const automata::Support& support = deciding(c, position.modes[c.index()]);
        if (!support.reads_control(i)) continue;
        std::vector<std::size_t> others;
        for (const std::size_t other : support.controls) {
          if (other != i) others.push_back(other);
        }
        // All values of the other controls that the component reads, like an odometer.
        for (bool more = true; more;) {
          effect.push_back(step_.consistent(position.modes, action) ? local(member, position.modes, action) : nullptr);
          members.push_back(member);
          more = false;
          for (const std::size_t other : others) {
            const std::size_t size = plant().variables[plant().controls[other].variable].values.size();
            const std::size_t next = action[other].index() + 1;
            action[other] = ValueId(next == size ? 0 : next);
            if (action[other] != base[other]) {
              more = true;
              break;
            }
          }
        }
      }
      const bool same = std::find(effects.begin(), effects.end(), effect) != effects.end();
      if (tolerated && same && !coupled_[at]) continue;
      if (useful_ && !effects.empty() && !coupled_[at]) {
        // The entries of one value are those of another in the same order, a component after the other.
        bool serving = false;
        for (std::size_t k = 0; k < effect.size() && !serving; ++k) {
          serving = effect[k] != nullptr && effects.front()[k] != nullptr &&
                    serves(members[k], position.modes, *effect[k], *effects.front()[k]);
        }
        if (!serving) continue;
      }
      effects.push_back(effect);
      different.push_back(v);
    }
    action[i] = base[i];
    kept.push_back(std::move(different));
  }
  return kept;
}

void Arena::list_actions(Position& position) {
  const ControlAction base = resting_action(step_, position.modes);
  const auto values = values_that_matter(position, base);
  std::size_t count = 1;
  for (const auto& v : values) {
    count *= v.size();
    if (count > most_actions) {
      too_large_ = true;
      return;
    }
  }
  std::vector<std::size_t> chosen(values.size(), 0);
  std::vector<Position::Action> all;
  ControlAction action = base;
  for (;;) {
    if (step_.consistent(position.modes, action)) {
      Position::Action entry{number_of(action), 0, {}};
      for (std::size_t i = 0; i < action.size(); ++i) {
        if (action[i] != idle_[i]) ++entry.off;
      }
      for (std::size_t member = 0; member < components_.size(); ++member)
        entry.moves.push_back(local(member, position.modes, action));
      all.push_back(std::move(entry));
    }
    std::size_t at = values.size();
    while (at > 0 && chosen[at - 1] + 1 == values[at - 1].size()) {
      --at;
      chosen[at] = 0;
      action[controls_[at]] = values[at][0];
    }
    if (at == 0) break;
    ++chosen[at - 1];
    action[controls_[at - 1]] = values[at - 1][chosen[at - 1]];
  }
  if (all.empty()) return;
  // Of actions that enable the same the one with the fewest controls off idle stands for all, then the first by order.
  const auto before = [&](const Position::Action& a, const Position::Action& b) {
    return order(a.action) < order(b.action);
  };
  std::sort(all.begin(), all.end(), [&](const Position::Action& a, const Position::Action& b) {
    return a.off != b.off ? a.off < b.off : before(a, b);
  });
  std::set<std::vector<const LocalMoves*>> known;
  const std::uint32_t idle = number_of(base);
  const auto rest = std::find_if(all.begin(), all.end(), [&](const auto& a) { return a.action == idle; });
  if (rest == all.end()) return;
  known.insert(rest->moves);
  Position::Action first = std::move(*rest);
  all.erase(rest);
  std::erase_if(all, [&](const Position::Action& a) { return !known.insert(a.moves).second; });
  std::sort(all.begin(), all.end(), before);
  position.actions.push_back(std::move(first));
  for (Position::Action& action_entry : all) position.actions.push_back(std::move(action_entry));
}

}  // namespace rmpl::runtime
