// The components that a game is played with, and what each of them may do: the rest of the plant is held.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "automata/store/memory.hpp"
#include "base/function_ref.hpp"
#include "runtime/reasoning/game/game_goal.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::runtime {

/// What one component may do under a command, given the modes of the others (semantics 3, without faults).
struct LocalMoves {
  struct Exit {
    automata::TransitionId transition;
    automata::ModeId to;
    automata::Ticks lower, upper;  ///< of its clock; 0 and 0 where it is untimed
    std::uint32_t branch;          ///< timed exits with the same branch are one risk with several outcomes
    bool irreversible, licensed;   ///< it cannot be undone; the goal gives leave for that
    bool operator==(const Exit&) const = default;
  };
  /// Untimed: one of the exits is taken, in the next step. Timed: each may come between its bounds.
  bool untimed = false;
  bool restarts = false;    ///< the clock of its mode, which matters, starts anew
  bool dawdles = false;     ///< a timed self-transition competes with the timed exits, so that none of them is ever due
  std::vector<Exit> exits;  ///< untimed ones once a target; staying is an exit to the own mode where it is one
  bool operator==(const LocalMoves&) const = default;
};

/// A joint position: modes of the arena's components, and the actions that do something there.
struct Position {
  /// One action, with what each component may do under it. Actions that enable the same are one, the first.
  struct Action {
    std::uint32_t action;                  ///< an index for `Arena::action`
    std::uint32_t off;                     ///< controls off idle
    std::vector<const LocalMoves*> moves;  ///< by component of the arena
    bool frees = false;                    ///< components outside are free from here on (free_arena.hpp)
    bool ticks = false;                    ///< it takes one cycle and costs nothing, though it could be held
  };
  automata::Modes modes;        ///< of all components of the plant
  bool free = false;            ///< components outside may be in any mode (free_arena.hpp)
  std::vector<bool> held;       ///< by part of the goal that the arena is about
  bool goal = false;            ///< all are held
  std::int64_t reward = 0;      ///< of the arena's components, in millionths
  std::vector<Action> actions;  ///< the first is idle, or what is nearest to idle of what the model tolerates

  /// By the number of its action; null where it is none of this position.
  [[nodiscard]] const Action* find(std::uint32_t action) const {
    const auto at = std::find_if(actions.begin(), actions.end(), [&](const Action& a) { return a.action == action; });
    return at == actions.end() ? nullptr : &*at;
  }
};

/// Positions of a part of the plant, worked out as they are asked for. Keeps references.
class Arena {
 public:
  /// `parts`: of the goal, those that are to be reached here. `components`: ascending. `start`: possible modes of
  /// the whole plant; those of other components do not change. `excludes`: whether the constraints of an island may
  /// exclude modes or commands; it is asked here alone.
  using Excludes = base::FunctionRef<bool(std::size_t)>;
  Arena(automata::PlantStep& step, const NominalGraph& graph, const GameGoal& goal, std::vector<std::size_t> parts,
        std::vector<automata::ComponentId> components, const automata::Modes& start, Excludes excludes);
  virtual ~Arena() = default;
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  /// Components outside are not held: positions tell whether they are free, and their keys end with that.
  [[nodiscard]] virtual bool is_relaxed() const { return false; }
  /// Before the first position is asked for: only actions under which some component may take a useful step towards
  /// the parts, or towards more reward where there are none, or is kept from a step that is none.
  void restrict_to_useful();

  [[nodiscard]] const std::vector<automata::ComponentId>& components() const { return components_; }
  [[nodiscard]] const automata::Plant& plant() const { return step_.plant(); }
  [[nodiscard]] const GameGoal& goal() const { return goal_; }

  /// The position with these modes of the arena's components, by its key; none where the model excludes them.
  std::optional<std::uint32_t> find(const std::vector<std::uint16_t>& modes);
  /// Its actions are known. Lasts as long as the arena.
  const Position& at(std::uint32_t position);
  [[nodiscard]] const automata::Modes& modes(std::uint32_t position) const { return positions_[position].modes; }
  [[nodiscard]] const std::vector<bool>& held(std::uint32_t position) const { return positions_[position].held; }
  [[nodiscard]] std::vector<std::uint16_t> start() const;
  /// Of a component of the arena in a mode, in millionths.
  [[nodiscard]] std::int64_t reward(std::size_t member, automata::ModeId mode) const;
  [[nodiscard]] const automata::ControlAction& action(std::uint32_t number) const { return actions_[number]; }
  /// Actions by declaration: the lists of controls off idle with their values, one entry after the other.
  using Order = std::vector<std::pair<std::size_t, automata::ValueId>>;
  [[nodiscard]] const Order& order(std::uint32_t action) const { return orders_[action]; }
  /// Positions of controls, in `Plant::controls`, that some component of the arena reads, and of those that the model
  /// may exclude together with such; ascending.
  [[nodiscard]] const std::vector<std::size_t>& controls() const { return controls_; }
  /// Of modes that the model excludes: a smallest set of components and modes that cannot be together.
  std::vector<std::pair<automata::ComponentId, automata::ModeId>> conflict(const std::vector<std::uint16_t>& modes);
  /// Some position has more actions than are listed: the arena is too large.
  [[nodiscard]] bool too_large() const { return too_large_; }

  /// What decides which steps leave a mode.
  [[nodiscard]] const automata::Support& deciding(automata::ComponentId component, automata::ModeId mode) const;
  /// What a component, of the arena or not, may do under an action that these modes of the plant tolerate.
  LocalMoves moves_of(automata::ComponentId component, const automata::Modes& modes,
                      const automata::ControlAction& action);
  /// Components outside whose modes the arena rests on, ascending: it is the same arena from wherever they are the
  /// same.
  [[nodiscard]] const std::vector<automata::ComponentId>& context() const { return context_; }
  [[nodiscard]] const automata::Modes& start_modes() const { return start_; }
  /// Components outside that read modes of the arena or its controls, where they are in these modes; ascending.
  [[nodiscard]] std::vector<automata::ComponentId> readers(const automata::Modes& modes) const;

 protected:
  static constexpr std::size_t most_actions = 4096;

  virtual void list_actions(Position& position);
  /// Whether the model tolerates the modes of the position together.
  virtual bool tolerates(const automata::Modes& modes, bool free);
  /// What a component may do where these transitions are enabled.
  [[nodiscard]] LocalMoves moves_with(automata::ComponentId component, automata::ModeId mode,
                                      const automata::Enabled& enabled) const;
  /// The one of all equal moves of a member.
  const LocalMoves* kept(std::size_t member, LocalMoves moves);
  std::uint32_t number_of(const automata::ControlAction& action);
  [[nodiscard]] bool is_member(automata::ComponentId component) const { return member_[component.index()].has_value(); }

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  const GameGoal& goal_;
  automata::ControlAction idle_;
  bool too_large_ = false;

 private:
  automata::Enabled enabled_of(automata::ComponentId component, const automata::Modes& modes,
                               const automata::ControlAction& action);
  const LocalMoves* local(std::size_t member, const automata::Modes& modes, const automata::ControlAction& action);
  void find_controls(Excludes excludes);
  void find_context(Excludes excludes);
  [[nodiscard]] bool serves(std::size_t member, const automata::Modes& modes, const LocalMoves& with,
                            const LocalMoves& without) const;
  std::vector<std::vector<automata::ValueId>> values_that_matter(const Position& position,
                                                                 const automata::ControlAction& base);

  std::vector<std::size_t> parts_;
  std::vector<automata::ComponentId> components_;
  std::vector<automata::ComponentId> context_;
  std::vector<std::optional<std::size_t>> member_;  ///< by component of the plant: its place here
  std::vector<std::size_t> controls_;               ///< that some component here reads, ascending
  std::vector<bool> coupled_;                       ///< by place in `controls_`: the model may exclude values of it
  std::vector<std::vector<std::size_t>> read_by_;   ///< by place in `controls_`: members that read it in some mode
  automata::Modes start_;

  struct KeyHash {
    std::size_t operator()(const std::vector<std::uint16_t>& key) const noexcept;
  };
  std::unordered_map<std::vector<std::uint16_t>, std::optional<std::uint32_t>, KeyHash> numbers_;
  std::deque<Position> positions_;
  std::vector<bool> listed_;

  std::vector<std::vector<automata::Memory<const LocalMoves*>>> known_;  ///< by member, by mode: what it may do
  std::deque<LocalMoves> moves_;                                         ///< each once a component
  std::vector<std::vector<const LocalMoves*>> moves_by_member_;
  std::vector<automata::ControlAction> actions_;
  std::vector<Order> orders_;  ///< by action
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> action_numbers_;
  std::optional<UsefulSteps> useful_;  ///< where only these are looked at
};

}  // namespace rmpl::runtime
