// The game, explored: what nature may do.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/game.hpp"

#include <algorithm>
#include <limits>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ModeId;
using automata::Ticks;

namespace {

constexpr std::size_t most_outcomes_of_one = 4096;  // of one action

std::int64_t sum(std::int64_t a, std::int64_t b) { return std::min(a + b, Cycles::never); }

/// So many units, no more than the longest time that there is.
std::int64_t times(std::int64_t count, Ticks unit) {
  constexpr std::int64_t longest = std::numeric_limits<std::int64_t>::max();
  return count > longest / unit.count ? longest : count * unit.count;
}

}  // namespace

/// What one component may do: an exit, or nothing where it stays.
struct Game::Choice {
  ModeId to;
  const LocalMoves::Exit* exit;
  Cycles cycles;  ///< after how many cycles, where ages are known
};

/// An action as it is looked at: the choices of all components, and one of each.
struct Game::Turn {
  bool waits = true, ends = false, at_once = false;
  bool free = false;   ///< after it components outside are free
  bool frees = false;  ///< it is the one that frees them
  bool ticks = false;  ///< it would be a wait
  std::vector<const LocalMoves*> moves;
  std::vector<std::vector<Choice>> choices;                   ///< by component
  std::vector<std::int64_t> dues;                             ///< by component: the cycle by which it leaves
  std::int64_t upper = Cycles::never, lower = Cycles::never;  ///< of all timed exits, in cycles
  std::vector<std::size_t> chosen;
};

std::size_t Game::KeyHash::operator()(const Key& key) const noexcept {
  std::uint64_t hash = base::mix(base::hash_seed, key.position);
  for (const Age& age : key.ages) {
    hash = base::mix(hash, static_cast<std::uint64_t>(age.least));
    hash = base::mix(hash, static_cast<std::uint64_t>(age.most));
    hash = base::mix(hash, static_cast<std::uint64_t>(age.charged));
  }
  return hash;
}

Game::Game(Arena& arena, Memory memory, Ticks cycle, Limits limits, const automata::Modes& start,
           const std::optional<std::vector<Age>>& ages)
    : arena_(arena), memory_(memory), cycle_(cycle), rules_(cycle), most_alike_(limits.alike) {
  if (memory == Memory::ages) find_caps();
  const auto position = position_of(start);
  too_large_ = !position;
  if (position) explore(limits, key_of(*position, ages));
  if (too_large_) {
    edges_ = {};
    outcomes_ = {};
    return;
  }
  spread_harm();
  forbid();
}

std::optional<std::uint32_t> Game::position_of(const automata::Modes& modes) const {
  std::vector<std::uint16_t> key;
  for (const ComponentId c : arena_.components()) key.push_back(static_cast<std::uint16_t>(modes[c.index()].index()));
  if (arena_.is_relaxed()) key.push_back(0);
  return arena_.find(key);
}

std::optional<std::uint32_t> Game::find(const automata::Modes& modes,
                                        const std::optional<std::vector<Age>>& ages) const {
  const auto position = position_of(modes);
  if (!position) return std::nullopt;
  const auto at = numbers_.find(key_of(*position, ages));
  return at == numbers_.end() ? std::nullopt : std::optional(at->second);
}

bool Game::is_fresh(std::uint32_t node) const {
  return key_of(nodes_[node].position, std::nullopt).ages == *ages_[node];
}

void Game::find_caps() {
  for (const ComponentId c : arena_.components()) {
    const automata::Component& component = arena_.plant()[c];
    auto& caps = caps_.emplace_back(component.modes.size());
    for (const automata::Transition& t : component.transitions) {
      if (!t.timing || component.is_fault(t)) continue;
      std::int64_t& cap = caps[t.from.index()];
      cap = std::max(cap, rules_.cap(rules_.window(t.timing->lower, t.timing->upper)));
    }
  }
}

/// Ages beyond what matters in a mode are as good as the least of these. Where few ages are kept none is told from
/// another by what has been charged.
void Game::cap(Key& key) const {
  const auto& modes = arena_.modes(key.position);
  for (std::size_t i = 0; i < key.ages.size(); ++i) {
    const std::int64_t most = caps_[i][modes[arena_.components()[i].index()].index()];
    Age& age = key.ages[i];
    age = {std::min(age.least, most), std::min(age.most, most), most_alike_ ? 0 : std::min(age.charged, most)};
  }
}

std::uint32_t Game::node_of(Key key) {
  cap(key);
  const std::uint32_t position = key.position;
  if (most_alike_) {
    if (alike_.size() <= position) alike_.resize(position + std::size_t{1});
    if (alike_[position] >= *most_alike_) {
      const auto known = numbers_.find(key);
      return known == numbers_.end() ? unexplored(position) : known->second;
    }
  }
  const auto [at, fresh] = numbers_.try_emplace(std::move(key), static_cast<std::uint32_t>(nodes_.size()));
  if (fresh) {
    if (most_alike_) ++alike_[position];
    nodes_.push_back({position, 0, 0, 0, true});
    ages_.push_back(&at->first.ages);
  }
  return at->second;
}

/// The node of these modes from which on nothing is looked at.
std::uint32_t Game::unexplored(std::uint32_t position) {
  const auto [at, fresh] = unexplored_.try_emplace(position, static_cast<std::uint32_t>(nodes_.size()));
  if (fresh) {
    std::vector<Age>& unknown = unknown_ages_.emplace_back();
    const auto& modes = arena_.modes(position);
    for (std::size_t i = 0; i < arena_.components().size(); ++i) {
      unknown.push_back({0, caps_[i][modes[arena_.components()[i].index()].index()], 0});
    }
    nodes_.push_back({position, 0, 0, unknown_harm, false});
    ages_.push_back(&unknown);
  }
  return at->second;
}

Game::Key Game::key_of(std::uint32_t number, const std::optional<std::vector<Age>>& ages) const {
  Key key{number, {}};
  if (memory_ == Memory::modes) return key;
  if (ages) {
    key.ages = *ages;
    cap(key);
    return key;
  }
  const Position& position = arena_.at(number);
  for (std::size_t i = 0; i < arena_.components().size(); ++i) {
    std::int64_t due = Cycles::never;
    if (!position.actions.empty() && !position.actions.front().moves[i]->untimed &&
        !position.actions.front().moves[i]->dawdles) {
      for (const auto& exit : position.actions.front().moves[i]->exits)
        due = std::min(due, rules_.window(exit.lower, exit.upper).last);
    }
    key.ages.push_back({0, rules_.oldest(due), 0});
  }
  cap(key);
  return key;
}

void Game::explore(Limits limits, Key start) {
  node_of(std::move(start));
  const auto count = [&] { beyond_limits_ = nodes_.size() > limits.nodes || outcomes_.size() > limits.outcomes; };
  count();
  for (std::uint32_t node = 0; node < nodes_.size() && !too_large_ && !beyond_limits_; ++node) {
    const Position& position = arena_.at(nodes_[node].position);
    nodes_[node].first = static_cast<std::uint32_t>(edges_.size());
    if (!nodes_[node].explored) continue;
    for (const Position::Action& action : position.actions) {
      add_edge(node, position, action);
      if (outcomes_.size() > limits.outcomes) break;
    }
    nodes_[node].count = static_cast<std::uint32_t>(edges_.size()) - nodes_[node].first;
    too_large_ = too_large_ || arena_.too_large();
    count();
  }
  too_large_ = too_large_ || beyond_limits_;
}

/// Fills the turn. Whether its combinations are few enough.
bool Game::list_choices(std::uint32_t node, const Position& position, const Position::Action& action, Turn& turn) {
  std::size_t combinations = 1;
  for (std::size_t i = 0; i < arena_.components().size(); ++i) {
    const LocalMoves& moves = *action.moves[i];
    const ModeId mode = position.modes[arena_.components()[i].index()];
    turn.moves.push_back(&moves);
    auto& choices = turn.choices.emplace_back();
    std::int64_t& due = turn.dues.emplace_back(Cycles::never);
    if (moves.untimed) {
      // What makes a clock younger is a step of its own; then it may be held.
      const bool renews =
          moves.restarts && memory_ == Memory::ages && (ages(node)[i].least != 0 || ages(node)[i].most != 0);
      turn.waits = turn.waits && !renews;
      for (const LocalMoves::Exit& exit : moves.exits) {
        turn.waits = turn.waits && exit.to == mode;
        choices.push_back({exit.to, &exit, Cycles{0, Cycles::never}});
      }
    } else {
      const bool aged = memory_ == Memory::ages;
      const auto window = [&](const LocalMoves::Exit& exit) {
        return aged ? rules_.window(exit.lower, exit.upper) : window_of(exit.lower, exit.upper, rules_.unit());
      };
      for (const LocalMoves::Exit& exit : moves.exits) {
        if (!moves.dawdles) due = std::min(due, window(exit).last);
        turn.lower = std::min(turn.lower, window(exit).first);
      }
      turn.upper = std::min(turn.upper, due);
      const std::size_t before = choices.size();
      const Age age = aged ? ages(node)[i] : Age{};
      // However old it is, it has left after the cycle by which a new one has to leave.
      const Cycles stay = aged ? rules_.staying(age, due) : Cycles{1, due <= 1 ? 0 : Cycles::never};
      if (!stay.empty()) choices.push_back({mode, nullptr, stay});
      for (const LocalMoves::Exit& exit : moves.exits) {
        const Cycles leave = aged ? rules_.leaving(age, window(exit), due) : Cycles{};
        if (!leave.empty()) choices.push_back({exit.to, &exit, leave});
      }
      turn.at_once = turn.at_once || (stay.empty() && choices.size() > before);
    }
    combinations *= choices.size();
    if (combinations > most_outcomes_of_one) return false;
  }
  turn.free = position.free || action.frees;
  turn.frees = action.frees;
  turn.ticks = turn.waits && action.ticks;
  turn.waits = turn.waits && !action.ticks;
  turn.ends = !turn.waits || turn.upper != Cycles::never;
  turn.at_once = turn.at_once || !turn.waits;
  return true;
}

void Game::add_edge(std::uint32_t node, const Position& position, const Position::Action& action) {
  Turn turn;
  if (!list_choices(node, position, action, turn)) {
    too_large_ = true;
    return;
  }
  // Where it could not be held it is listed as it is.
  if (action.ticks && !action.frees && !turn.ticks) return;
  Edge edge{action.action, action.off, static_cast<std::uint32_t>(outcomes_.size()), 0};
  edge.entry = static_cast<std::uint32_t>(&action - position.actions.data());
  edge.waits = turn.waits;
  edge.ends = turn.ends;
  edge.at_once = turn.at_once;
  classes_.clear();
  turn.chosen.assign(turn.choices.size(), 0);
  const bool possible = std::none_of(turn.choices.begin(), turn.choices.end(), [](const auto& c) { return c.empty(); });
  while (possible) {
    add_outcome(node, position, turn, edge);
    std::size_t at = turn.chosen.size();
    while (at > 0 && turn.chosen[at - 1] + 1 == turn.choices[at - 1].size()) turn.chosen[--at] = 0;
    if (at == 0) break;
    ++turn.chosen[at - 1];
  }
  edge.count = static_cast<std::uint32_t>(outcomes_.size()) - edge.first;
  edge.choices = static_cast<std::uint32_t>(classes_.size());
  // All that could come of it is excluded: it is no action, but what the executive rests with may be such a one.
  edge.dead = edge.count == 0 && edge.ends;
  if (!edge.dead || edges_.size() == nodes_[node].first) edges_.push_back(edge);
}

void Game::add_outcome(std::uint32_t node, const Position& position, const Turn& turn, Edge& edge) {
  const auto& components = arena_.components();
  const GameGoal& goal = arena_.goal();
  std::vector<std::uint16_t> modes;
  std::vector<std::pair<std::size_t, std::uint32_t>> timed;
  Cycles cycles = memory_ == Memory::ages ? rules_.length(turn.waits) : Cycles{1, turn.waits ? Cycles::never : 1};
  Outcome outcome{};
  std::uint64_t takes = 0;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const Choice& choice = turn.choices[i][turn.chosen[i]];
    const ComponentId c = components[i];
    const ModeId from = position.modes[c.index()];
    cycles = cycles.meet(choice.cycles);
    modes.push_back(static_cast<std::uint16_t>(choice.to.index()));
    if (choice.exit == nullptr) continue;
    if (!turn.moves[i]->untimed) timed.emplace_back(i, choice.exit->branch);
    if (choice.to == from) continue;
    if (!goal.reads(c)) ++outcome.cost.disturbed;
    if (!choice.exit->irreversible) continue;
    if (choice.exit->licensed) {
      ++outcome.cost.irreversible;
    } else if (!arena_.is_relaxed()) {
      takes |= bit_of({{c.value, from.value}, {c.value, choice.to.value}});
    }
  }
  if (cycles.empty() || (turn.waits && timed.empty())) return;
  if (arena_.is_relaxed()) modes.push_back(turn.free ? 1 : 0);
  const auto target = arena_.find(modes);
  if (!target && arena_.is_relaxed()) return;
  if (!target) {
    Harm excluded;
    for (const auto& [c, m] : arena_.conflict(modes)) excluded.emplace_back(c.value, m.value);
    excluded.push_back(exclusion);
    edge.takes |= bit_of(std::move(excluded));
    return;
  }
  edge.takes |= takes;
  const bool bounded = memory_ == Memory::ages ? cycles.last != Cycles::never : turn.ends;
  std::int64_t charge = 1;
  if (memory_ == Memory::ages) {
    charge = bounded ? cycles.last : cycles.first;
  } else if (turn.waits) {
    charge = bounded ? turn.upper : turn.lower;
  }
  Key key{*target, {}};
  if (memory_ == Memory::ages) {
    const std::vector<Age>& ages = this->ages(node);
    for (std::size_t i = 0; i < ages.size() && turn.waits; ++i) {
      if (turn.dues[i] == Cycles::never) continue;
      // What may be overdue leaves at once, or is due.
      const bool overdue = ages[i].most > rules_.oldest(turn.dues[i]);
      const std::int64_t least = overdue ? rules_.length(true).first : 0;
      charge = std::min(charge, std::max(least, turn.dues[i] - ages[i].charged));
    }
    for (std::size_t i = 0; i < ages.size(); ++i) {
      const bool stays = modes[i] == position.modes[components[i].index()].index() && !turn.moves[i]->restarts;
      key.ages.push_back(!stays ? Age{}
                                : Age{ages[i].least + cycles.first,
                                      std::min(sum(ages[i].most, cycles.last), rules_.oldest(turn.dues[i])),
                                      sum(ages[i].charged, charge)});
    }
  }
  // Without ages what ends a wait is chance.
  if (memory_ == Memory::modes && turn.waits) timed.clear();
  const bool coincides = !turn.waits && !timed.empty();
  outcome.choice = classes_.try_emplace(std::move(timed), static_cast<std::uint32_t>(classes_.size())).first->second;
  outcome.irreversible = takes != 0 || outcome.cost.irreversible != 0;
  outcome.coincides = coincides;
  const std::vector<bool>& then = arena_.held(*target);
  for (std::size_t p = 0; p < then.size(); ++p) {
    if (position.held[p] && !then[p]) ++outcome.cost.lost;
  }
  outcome.cost.commands = static_cast<std::uint16_t>(edge.off);
  outcome.cost.waits = edge.off == 0 ? 1 : 0;
  outcome.cost.moves = turn.waits && edge.off == 0 ? 0 : 1;
  outcome.cost.unbounded = bounded ? 0 : 1;
  outcome.cost.time = turn.waits ? times(charge, rules_.unit()) : cycle_.count;
  if (turn.ticks) outcome.cost.commands = outcome.cost.waits = outcome.cost.moves = 0;
  if (turn.frees) ++outcome.cost.disturbed;
  outcome.soonest = times((memory_ == Memory::ages || !turn.waits ? cycles.first : turn.lower), rules_.unit());
  outcome.node = node_of(std::move(key));
  outcomes_.push_back(outcome);
}

}  // namespace rmpl::runtime
