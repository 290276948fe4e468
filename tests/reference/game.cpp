// The game of plans. SPDX-License-Identifier: MIT
#include "tests/reference/game.hpp"

#include <algorithm>
#include <tuple>

namespace rmpl::reference {

namespace {

/// The level that some actions are enough for.
Level level_of(Board& board, Node start, const May& may) {
  const std::set<Node> lasting = kept(board, may);
  std::set<Node> passing;
  for (const auto& [node, options] : board.nodes())
    if (board.holds(node)) passing.insert(node);
  const Rank to_last = rank_of(board, start, lasting, may);
  if (to_last <= Rank::fair) return {to_last, true};
  const Rank to_pass = rank_of(board, start, passing, may);
  if (to_pass > Rank::fair && to_last == Rank::hoped) return {to_last, true};
  return {to_pass, false};
}

/// The parts of the goal that an action loses in the next cycle, however lucky.
std::size_t lost_at_once(const Option& option) {
  if (!option.at_once || option.ways.empty()) return 0;
  const auto lost = [](const Option::Way& a, const Option::Way& b) { return a.cost.lost < b.cost.lost; };
  return std::min_element(option.ways.begin(), option.ways.end(), lost)->cost.lost;
}

bool has_rewards(const automata::Plant& plant) {
  return std::any_of(plant.components.begin(), plant.components.end(), [](const automata::Component& component) {
    return std::any_of(component.modes.begin(), component.modes.end(),
                       [](const automata::Mode& mode) { return mode.reward != 0; });
  });
}

}  // namespace

Game::Game(Board& board, Node start) : board_(board), all_([](Node, const Option&) { return true; }) {
  board_.explore(start);
  kept_ = reference::kept(board_, all_);
  for (const auto& [node, options] : board_.nodes())
    if (board_.holds(node)) holding_.insert(node);
  find_keeps();
  find_holds();

  // Where the goal is kept nothing is to be reached.
  const bool rewards = has_rewards(board_.step().plant()) && !kept_.contains(start);
  for (const Commands& way : rewards ? ways(start) : std::set<Commands>{{}}) {
    Chains found = chains(start, rewards ? counted(start, way) : std::set<std::size_t>{});
    const Level level = best(found, start);
    const Chain& chain = level.lasts ? found.lasting : found.passing;
    const GameCost cost = level.rank == Rank::none ? GameCost{} : chain.cost(start);
    if (chains_ && !(cost < solution_.cost)) continue;
    solution_.level = level;
    solution_.cost = cost;
    solution_.way = way;
    chains_.emplace(std::move(found));
  }
  follow(*chains_, start);
}

Level Game::level(Node node) const { return best(*chains_, node); }

Level Game::best(const Chains& chains, Node node) {
  const Rank lasting = chains.lasting.rank(node);
  const Rank passing = chains.passing.rank(node);
  if (lasting <= Rank::fair) return {lasting, true};
  if (passing <= Rank::fair || lasting == Rank::none) return {passing, false};
  return {lasting, true};
}

/// Actions that leave all controls as where nothing is wanted, but for these commands.
May Game::only(const Commands& way) const {
  return [way](Node, const Option& option) {
    return std::any_of(option.commands.begin(), option.commands.end(), [&](const Commands& commands) {
      return std::includes(way.begin(), way.end(), commands.begin(), commands.end());
    });
  };
}

/// The smallest sets of commands that are enough for the level that all are.
std::set<Commands> Game::ways(Node start) const {
  const Level wanted = level_of(board_, start, all_);
  Commands all;
  for (const auto& [node, options] : board_.nodes())
    for (const Option& option : options)
      for (const Commands& commands : option.commands) all.insert(commands.begin(), commands.end());
  std::vector<Commands> sets{{}};
  for (const auto& command : all)
    for (std::size_t known = sets.size(); known > 0; --known) {
      sets.push_back(sets[known - 1]);
      sets.back().insert(command);
    }
  std::stable_sort(sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::set<Commands> found;
  for (const Commands& set : sets) {
    const bool spared = std::any_of(found.begin(), found.end(), [&](const Commands& f) {
      return std::includes(set.begin(), set.end(), f.begin(), f.end());
    });
    if (!spared && level_of(board_, start, only(set)) == wanted) found.insert(set);
  }
  return found;
}

/// The components of a way, and what it takes with it: those with a control that their formulas mention, and those
/// that its actions may move, and that nothing moves where nothing is wanted.
std::set<std::size_t> Game::counted(Node start, const Commands& way) const {
  std::set<std::size_t> result = moved(start, only(way));
  for (const std::size_t c : moved(start, only({}))) result.erase(c);
  const automata::Plant& plant = board_.step().plant();
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    std::set<automata::VariableId> mentioned;
    const auto mention = [&](const automata::Formula& formula) {
      for (const automata::VariableId v : automata::variables_of(formula)) mentioned.insert(v);
    };
    for (const automata::Mode& mode : plant.components[c].modes) mention(mode.constraint);
    for (const automata::Transition& t : plant.components[c].transitions) mention(t.guard);
    for (const auto& [i, value] : way)
      if (mentioned.contains(plant.controls[i].variable)) result.insert(c);
  }
  return result;
}

/// The components that leave the mode of the start in some node that these actions lead to.
std::set<std::size_t> Game::moved(Node start, const May& may) const {
  std::set<std::size_t> result;
  std::set<Node> met{start};
  std::vector<Node> open{start};
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    for (std::size_t c = 0; c < board_.arena().modes(node).size(); ++c)
      if (board_.arena().modes(node)[c] != board_.arena().modes(start)[c]) result.insert(c);
    for (const Option& option : board_.options(node))
      if (may(node, option))
        for (const Option::Way& way : option.ways)
          if (met.insert(way.to).second) open.push_back(way.to);
  }
  return result;
}

Game::Chains Game::chains(Node start, const std::set<std::size_t>& counted) const {
  const auto own = [&](Node node) {
    GameCost cost;
    if (const auto longest = longest_.find(node); longest != longest_.end() && longest->second != nullptr)
      cost.lost = lost_at_once(*longest->second);
    for (std::size_t c = 0; c < board_.arena().modes(node).size(); ++c) {
      const double gain = board_.reward(node, c) - board_.reward(start, c);
      cost.worth -= counted.contains(c) ? gain : std::min(0.0, gain);
      cost.reward -= board_.reward(node, c);
    }
    return cost;
  };
  // Of the nodes that keeping the goal comes back to for ever, the worst.
  const auto terminal = [&](Node node) {
    GameCost cost = own(node);
    if (!kept_.contains(node)) return cost;
    std::optional<GameCost> worst;
    for (const Node then : later(node)) {
      const std::set<Node> after = later(then);
      if (std::any_of(after.begin(), after.end(), [&](Node last) { return !later(last).contains(then); })) continue;
      const GameCost end = own(then);
      if (!worst) worst = end;
      worst->worth = std::max(worst->worth, end.worth);
      worst->reward = std::max(worst->reward, end.reward);
    }
    cost.worth = worst->worth;
    cost.reward = worst->reward;
    return cost;
  };
  return {Chain(board_, kept_, terminal, all_), Chain(board_, holding_, terminal, all_)};
}

/// The node, where the goal is kept, and all that keeping it leads to.
const std::set<Node>& Game::later(Node node) const {
  const auto [at, fresh] = later_.try_emplace(node);
  if (!fresh) return at->second;
  std::set<Node> met{node};
  std::vector<Node> open{node};
  while (!open.empty()) {
    const Option* option = keeping(open.back());
    open.pop_back();
    if (option == nullptr) continue;
    for (const Option::Way& way : option->ways)
      if (met.insert(way.to).second) open.push_back(way.to);
  }
  return later_[node] = std::move(met);
}

/// Nothing where there is no action at all.
const Option* Game::rest_option(Node node) const {
  for (const Option& option : board_.options(node))
    if (option.commands.front().empty()) return &option;
  return nullptr;
}

bool Game::keeps(const Option& option) const {
  return std::all_of(option.ways.begin(), option.ways.end(),
                     [&](const Option::Way& way) { return kept_.contains(way.to); });
}

/// Of the options of a node that count the least by what it takes and moves at worst.
template <class Counts>
const Option* Game::least(Node node, const Counts& counts) const {
  const auto key = [&](const Option& option) {
    std::tuple<std::size_t, std::size_t> worst;
    for (const Option::Way& way : option.ways) worst = std::max(worst, {way.cost.irreversible, way.cost.disturbed});
    return std::tuple(worst, board_.step().off_idle(option.action), option.action);
  };
  const Option* best = nullptr;
  for (const Option& option : board_.options(node))
    if (counts(option) && (best == nullptr || key(option) < key(*best))) best = &option;
  return best;
}

/// What is sent where nothing is wanted, if that keeps the goal; else the least that does.
void Game::find_keeps() {
  const auto rests = [&](Node node) {
    const Option* rest = rest_option(node);
    return rest != nullptr && keeps(*rest) ? rest : nullptr;
  };
  if (board_.arena().actions_take_time()) {
    for (const Node node : kept_) {
      const Option* rest = rests(node);
      keeps_[node] = rest != nullptr ? rest : least(node, [&](const Option& option) { return keeps(option); });
    }
    return;
  }
  // What leads to a wait, step by step: by resting as long as that does, then where resting does not keep the goal,
  // then where it goes round in circles.
  const auto leads = [&](const Option& option) {
    return keeps(option) && (option.waits || std::all_of(option.ways.begin(), option.ways.end(),
                                                         [&](const auto& way) { return keeps_.contains(way.to); }));
  };
  const auto found = [&](const auto& choose) {
    std::map<Node, const Option*> next;
    for (const Node node : kept_) {
      if (keeps_.contains(node)) continue;
      if (const Option* option = choose(node)) next[node] = option;
    }
    keeps_.insert(next.begin(), next.end());
    return !next.empty();
  };
  const auto by_rest = [&](Node node) {
    const Option* rest = rests(node);
    return rest != nullptr && leads(*rest) ? rest : nullptr;
  };
  const auto by_action = [&](Node node) { return rests(node) == nullptr ? least(node, leads) : nullptr; };
  const auto out_of_circles = [&](Node node) { return least(node, leads); };
  while (found(by_rest) || found(by_action) || found(out_of_circles)) {
  }
}

/// What keeps the goal in a node of K.
const Option* Game::keeping(Node node) const {
  const auto at = keeps_.find(node);
  return at == keeps_.end() ? nullptr : at->second;
}

/// The longest time for which the goal holds at worst, by steps more and more far-sighted.
void Game::find_holds() {
  std::map<Node, std::int64_t> times;
  const auto time = [&](const Option& option) {
    std::optional<std::int64_t> least;
    for (const Option::Way& way : option.ways) {
      const auto later = times.find(way.to);
      const std::int64_t all = way.soonest + (later == times.end() ? 0 : later->second);
      if (!least || all < *least) least = all;
    }
    return least.value_or(0);
  };
  for (const Node node : holding_)
    if (!kept_.contains(node)) times[node] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (auto& [node, best] : times)
      for (const Option& option : board_.options(node)) {
        const std::int64_t found = time(option);
        if (found > best) {
          best = found;
          changed = true;
        }
      }
  }
  for (const auto& [node, most] : times) {
    const Option* best = nullptr;
    for (const Option& option : board_.options(node)) {
      if (time(option) != most) continue;
      if (best == nullptr || board_.step().off_idle(option.action) < board_.step().off_idle(best->action))
        best = &option;
    }
    longest_[node] = best;
  }
}

/// `bound`: the level whose strategy is followed, until its target is reached.
Decision Game::decide(const Chains& chains, Node node, std::optional<Level> bound) const {
  if (kept_.contains(node)) return {Decision::Purpose::keep, keeping(node)};
  Level level = bound.value_or(best(chains, node));
  if ((level.lasts ? chains.lasting : chains.passing).rank(node) == Rank::none) level = best(chains, node);
  if (level.rank != Rank::none && level.lasts) return {Decision::Purpose::reach, chains.lasting.option(node)};
  if (holding_.contains(node)) return {Decision::Purpose::hold, longest_.at(node)};
  if (level.rank != Rank::none) return {Decision::Purpose::reach, chains.passing.option(node)};
  return {Decision::Purpose::none, rest_option(node)};
}

void Game::follow(const Chains& chains, Node start) {
  std::vector<std::pair<Node, bool>> open;
  const auto meet = [&](Node node, bool reached) {
    reached = reached || (solution_.level.lasts ? kept_ : holding_).contains(node);
    const auto bound = reached ? std::nullopt : std::optional(solution_.level);
    if (solution_.strategy.try_emplace({node, reached}, decide(chains, node, bound)).second)
      open.emplace_back(node, reached);
  };
  meet(start, false);
  while (!open.empty()) {
    const auto [node, reached] = open.back();
    open.pop_back();
    const Option* option = solution_.strategy.at({node, reached}).option;
    if (option == nullptr) continue;
    for (const Option::Way& way : option->ways) meet(way.to, reached);
  }
}

}  // namespace rmpl::reference
