// Which strategy is best from some modes on, group by group (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "base/function_ref.hpp"
#include "runtime/reasoning/game/game.hpp"
#include "runtime/reasoning/game/game_goal.hpp"
#include "runtime/reasoning/game/plant_games.hpp"
#include "runtime/reasoning/game/played_game.hpp"
#include "runtime/reasoning/game/position.hpp"
#include "runtime/reasoning/game/rewards.hpp"
#include "runtime/reasoning/game/solve.hpp"
#include "runtime/reasoning/game/within_reach.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::runtime {

/// A game that was solved from one of its nodes.
struct SolvedGame {
  std::shared_ptr<const Game> game;
  std::shared_ptr<const Solution> solution;
  std::uint32_t start;             ///< the node that it was asked for
  std::vector<std::size_t> parts;  ///< of the goal
  bool best = true;                ///< all actions were looked at, not only useful ones
  bool bounds_counted = true;      ///< where they matter
  /// Components that have a part in it, ascending: that leave their mode on some run of it, or decide steps that come
  /// after the first wait or by command.
  std::vector<automata::ComponentId> part = {};
  std::vector<std::size_t> commanded = {};  ///< controls that it uses, ascending

  [[nodiscard]] const GameDecision& decision() const { return solution->at(start); }
};

/// Whether the goal is kept for as long as the executive rests, whatever comes: no age can make that better.
bool rests_for_good(const SolvedGame& solved);

/// A reward that is pursued in a game from one of its nodes.
struct PursuedReward {
  std::shared_ptr<const Game> game;
  std::shared_ptr<GameRewards> rewards;
  std::uint32_t start;
  GameRewards::Pursued pursued;

  /// What is sent in a node of the game on the way to the reward; none at its end.
  [[nodiscard]] std::uint32_t edge(std::uint32_t node) const { return rewards->edge(pursued, node); }
};

/// Strategies for one goal. Parts of the goal whose strategies do not touch each other's components are solved apart;
/// where they do, they are solved together (independence detection). So are parts of which one cannot be kept, if
/// together they are as surely had as apart, and no more is lost or neither lasts: what is short-lived comes last then.
/// So are components that a strategy disturbs and that no part reads: as long as none is disturbed, leaving it out is
/// exact. Where a group is too large with what it disturbs, it is left out all the same, if that cannot be harmed.
///
/// A group that is too large with all that decides its steps is solved with the least set of components whose answer is
/// that of all of them, where there is a certificate for that (least_groups.cpp).
///
/// Groups that are too large together take turns, as causal chains do (Williams and Nayak 1997; Chung 2003): first
/// those that can be kept, in the order of the goal; the next one when the goal of those before it holds. That is not
/// proved best.
///
/// Bounds count group by group: where timed transitions with bounds matter, a game over modes and ages is tried, and
/// where that is too large the one over modes alone stands. Keeps references.
class Strategist {
 public:
  /// With what a part of the goal is solved from the start on; all that its strategy disturbs is added.
  enum class Relevant {
    upstream,  ///< the components that it reads, and all that decides their steps
    read       ///< the components that it reads; the others are held, and no rewards are pursued
  };
  /// Which groups are solved with least sets of components.
  enum class Least {
    large,  ///< those that are too large with all that decides their steps
    all     ///< all for which there is a certificate
  };
  /// `cycle`: of the executive whose ages count; 0 is dense time, in which actions take none. Without it modes alone
  /// count. `common`: of the plant, where strategists share it.
  Strategist(automata::PlantStep& step, const NominalGraph& graph, const automata::Formula& goal,
             std::optional<automata::Ticks> cycle = std::nullopt, Relevant relevant = Relevant::upstream,
             Least least = Least::large, std::shared_ptr<PlantGames> common = nullptr);

  struct Answer {
    bool solved = false;             ///< else some group is too large, and nothing below is known
    bool best = true;                ///< all actions were looked at; else only useful ones in some group
    std::vector<SolvedGame> groups;  ///< with a strategy each; or one group alone that has none
    std::vector<SolvedGame> later;   ///< groups that have their turn later, as together with others they are too large
    Rank rank = Rank::sure;
    bool lasts = true;
    bool bounds_counted = true;      ///< no game over ages was too large
    automata::ControlAction action;  ///< of all `groups` together
  };
  /// From possible modes. Groups in force go on from where they are: `position` is what the edges of the last answer
  /// led to.
  Answer from(const automata::Modes& modes, const StrategyPosition& position = {});
  /// What follows when `sent` goes out on an answer from these modes. Null where nothing more is known then than modes
  /// tell.
  [[nodiscard]] std::shared_ptr<const StrategyEdges> edges(const Answer& answer, const automata::Modes& modes,
                                                           const automata::ControlAction& sent);
  /// What is pursued for reward beside an answer that keeps the goal or waits, over modes. While it waits, the
  /// components that have a part in its strategies have none in that. Groups that are too large pursue nothing.
  /// `action` becomes that of the answer with what pursues rewards.
  std::vector<PursuedReward> rewards(const automata::Modes& modes, const Answer& answer,
                                     automata::ControlAction& action);

  /// The components with which a part of the goal is solved from the start on; ascending.
  [[nodiscard]] const std::vector<automata::ComponentId>& relevant(std::size_t part) const { return relevant_[part]; }

  /// The goal as text, as positions name it.
  [[nodiscard]] const std::string& goal() const { return goal_text_; }
  /// Of ages in games that know them.
  [[nodiscard]] automata::Ticks age_unit() const { return AgeRules(cycle_.value_or(automata::Ticks{0})).unit(); }

 private:
  struct Group {
    std::vector<std::size_t> parts;
    std::vector<automata::ComponentId> components;  ///< ascending: all that it rests on
    std::vector<automata::ComponentId> least = {};  ///< ascending: with these alone it is solved; with all where empty
    std::optional<SolvedGame> solved = {};          ///< where it is about the goal
    std::optional<PursuedReward> reward = {};       ///< where it is about rewards
    /// Of a group that is solved with its least components: all that it would rest on if it were solved with all, and
    /// the controls that these read; ascending.
    std::vector<automata::ComponentId> rests_on = {};
    std::vector<std::size_t> controls = {};
    std::vector<automata::ComponentId> touched = {};  ///< components that its strategy moves, ascending
    std::vector<std::size_t> commanded = {};          ///< controls that its strategy uses, ascending
    bool later = false;                               ///< another group goes first
    std::vector<std::uint32_t> nodes = {};            ///< of the game, that its strategy comes to
    std::optional<std::vector<Age>> ages = {};        ///< where a strategy is in force

    [[nodiscard]] const std::vector<automata::ComponentId>& played() const {
      return least.empty() ? components : least;
    }
    [[nodiscard]] const std::vector<automata::ComponentId>& reads() const {
      return least.empty() ? components : rests_on;
    }
    [[nodiscard]] const std::vector<std::size_t>& read_controls() const {
      return least.empty() ? game().arena().controls() : controls;
    }
    [[nodiscard]] const Game& game() const { return solved ? *solved->game : *reward->game; }
    [[nodiscard]] std::uint32_t start() const { return solved ? solved->start : reward->start; }
    /// What is sent in a node; at the end of what is pursued what the executive rests with.
    [[nodiscard]] std::uint32_t edge(std::uint32_t node) const {
      const std::uint32_t edge = solved ? solved->solution->at(node).edge : reward->edge(node);
      const Game::Node& at = game().nodes()[node];
      return edge == GameDecision::no_edge && at.count > 0 ? at.first : edge;
    }
  };

  [[nodiscard]] bool has_at_most(std::size_t most, const Group& group, const automata::Modes& modes) const;
  [[nodiscard]] bool is_small(const Group& group, const automata::Modes& modes) const;
  bool solve_group(Group& group, const automata::Modes& modes);
  /// What is said of the answer of a group that is solved with few components.
  struct Certificate {
    bool holds = false;                             ///< it is the answer of all components
    std::vector<automata::ComponentId> more = {};   ///< else components with which it may be
    std::vector<automata::ComponentId> wider = {};  ///< on which the group rests, too
  };
  bool solve_least(Group& group, const automata::Modes& modes);
  Certificate certificate(Group& group, const automata::Modes& modes);
  Certificate relaxed(const Group& group, const automata::Modes& modes);
  [[nodiscard]] std::vector<automata::ComponentId> gaining(const std::vector<automata::ComponentId>& components,
                                                           const automata::Modes& modes,
                                                           const WithinReach& reach) const;
  [[nodiscard]] std::vector<automata::ComponentId> restless(const std::vector<automata::ComponentId>& components,
                                                            const automata::Modes& modes) const;
  std::vector<automata::ComponentId> moved_outside(const Group& group,
                                                   const std::vector<automata::ComponentId>& components,
                                                   const automata::Modes& modes, bool everywhere);
  [[nodiscard]] std::vector<std::size_t> controls_of(const Group& group,
                                                     const std::vector<automata::ComponentId>& components) const;
  bool tolerates_all_commands();
  bool harmless(std::vector<automata::ComponentId> components);
  bool harmless_held(const Group& group, const automata::Modes& modes);
  bool pursue(Group& group, const automata::Modes& modes, const std::vector<automata::ComponentId>& taken);
  [[nodiscard]] bool has_rewards(automata::ComponentId component, automata::ModeId from) const;
  Group reward_group(std::vector<automata::ComponentId> components, std::vector<std::size_t> parts,
                     const std::vector<automata::ComponentId>& taken);
  static bool in_context(const Arena& arena, const automata::Modes& modes);
  [[nodiscard]] bool is_left_alone(const Group& group) const;
  void forget_large();
  PlayedGame& game_of(const Group& group, const automata::Modes& modes, bool useful = true);
  static std::shared_ptr<const Game> kept_with(std::shared_ptr<Arena> arena, const Game* game);
  static SolvedGame solved(PlayedGame& played, std::uint32_t start, const std::vector<std::size_t>& parts);
  std::vector<Group> first_groups(const automata::Modes& modes, const StrategyPosition& position);
  bool go_on(Group& group, const automata::Modes& modes);
  [[nodiscard]] bool bounds_matter(const Group& group, const automata::Modes& modes) const;
  Answer answer(const automata::Modes& modes, const StrategyPosition& position);
  bool rests_from(const SolvedGame& solved, const automata::Modes& modes);
  void count_ages(Group& group, const PlayedGame& over_modes, const automata::Modes& modes);
  using MakeArena = base::FunctionRef<std::shared_ptr<Arena>()>;
  bool play_over_ages(Group& group, const MakeArena& make_arena, const Game::Limits& limits,
                      const automata::Modes& modes);
  std::shared_ptr<Arena> arena_of(const Group& group, const automata::Modes& modes, bool all_actions);
  static bool leaves(const Game& game, const Game::Edge& edge, std::uint32_t node, std::size_t member);
  std::vector<automata::ComponentId> follow(Group& group, const automata::Modes& modes);
  using Apart = std::set<std::pair<std::vector<std::size_t>, std::vector<std::size_t>>>;  ///< parts of two groups
  void merge_common(std::vector<Group>& groups) const;
  static void merge_all(std::vector<Group>& groups);
  bool merge_touching(std::vector<Group>& groups, const automata::Modes& modes, Apart& in_turn);
  bool judge_together(std::vector<Group>& groups, const automata::Modes& modes, const Apart& apart, Answer& answer);
  static void set_turns(std::vector<Group>& groups, const Apart& in_turn);
  [[nodiscard]] bool touches(const Group& a, const Group& b) const;
  [[nodiscard]] bool agree(const Group& a, const Group& b) const;
  bool merge_passing(std::vector<Group>& groups, const automata::Modes& modes, Apart& apart);
  std::vector<automata::ComponentId> neighbours(const std::vector<automata::ComponentId>& components,
                                                const std::vector<std::size_t>& controls);
  static Group merged(const Group& a, const Group& b);

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  std::optional<automata::Ticks> cycle_;  ///< where ages count
  bool counts_ages_;                      ///< in the answer at hand
  bool holds_;                            ///< the components that no part of the goal reads
  Least least_;
  GameGoal goal_;
  std::string goal_text_;
  std::vector<std::vector<automata::ComponentId>> relevant_;  ///< by part
  using Key = std::pair<std::vector<std::size_t>, std::vector<automata::ComponentId>>;
  std::map<Key, std::vector<PlayedGame>> games_;       ///< over modes, but for those that the goal leaves alone
  std::map<Key, std::vector<PlayedGame>> aged_games_;  ///< over modes and ages
  std::shared_ptr<PlantGames> common_;
  std::set<Key> without_least_;  ///< groups, with their components, that have no least ones for the answer at hand
};

}  // namespace rmpl::runtime
