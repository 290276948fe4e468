// What nature may do in one cycle where nothing fails (semantics 3): the ground of the game of plans.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::reference {

/// What one component may do. It takes one of `at_once` where there are any; else it stays, or takes one of `timed`.
struct Freedom {
  std::vector<automata::ModeId> at_once;           ///< targets of enabled untimed exits, ascending, each once
  std::vector<const automata::Transition*> timed;  ///< enabled exits with bounds, which lead elsewhere
  bool dawdles = false;                            ///< one that leads nowhere competes, so that none of them is due
  bool restarts = false;                           ///< a restart starts its clock, which matters, anew
  bool operator==(const Freedom&) const = default;

  [[nodiscard]] bool leaves_at_once(automata::ModeId from) const {
    return !at_once.empty() && !(at_once.size() == 1 && at_once.front() == from);
  }
};

/// Modes that exclude each other by the model, none of which can be spared; by component, ascending.
using Nogood = std::vector<std::pair<std::size_t, automata::ModeId>>;

/// The nominal step, without clocks. Faults are never taken, and take nothing away from the others. Remembers all that
/// it was asked. Keeps a reference to the plant.
class GameStep {
 public:
  using Action = std::size_t;  ///< a position in `actions`

  explicit GameStep(const automata::Plant& plant);

  [[nodiscard]] const automata::Plant& plant() const { return plant_; }
  /// Every value for every control, in the order in which equal ones are taken: by the controls that are off idle, with
  /// their values, one after the other; so idle is the first, and what commands the first control goes before the rest.
  [[nodiscard]] const std::vector<automata::ControlAction>& actions() const { return actions_; }
  [[nodiscard]] Action idle() const { return 0; }
  [[nodiscard]] std::size_t off_idle(Action action) const;

  bool possible(const automata::Modes& modes) { return nogoods(modes).empty(); }
  bool entails(const automata::Modes& modes, const automata::Formula& formula);
  /// Whether the store of some possible modes, with some action that does not contradict them, implies its guard.
  bool can_be_taken(std::size_t component, const automata::Transition& transition);
  /// By component; nothing where modes and action contradict each other.
  const std::optional<std::vector<Freedom>>& freedom(const automata::Modes& modes, Action action);
  /// All smallest sets of these modes that exclude each other.
  const std::vector<Nogood>& nogoods(const automata::Modes& modes);

 private:
  std::optional<std::vector<Freedom>> find_freedom(const automata::Modes& modes, Action action);

  const automata::Plant& plant_;
  std::vector<automata::ControlAction> actions_;
  automata::Theory theory_;
  /// By action, as far as it was asked for.
  using Freedoms = std::vector<std::unique_ptr<const std::optional<std::vector<Freedom>>>>;
  std::unordered_map<automata::Modes, Freedoms, automata::ModesHash> freedoms_;  ///< looked up, never iterated
  std::map<automata::Modes, std::vector<Nogood>> nogoods_;
};

}  // namespace rmpl::reference
