// Folds: timers that nobody asks are told by their clocks.
//
// A mode that time alone ends, after a fixed time, is the beginning of a chain of such modes. Which of them a component
// is in, its clock since the first of them tells. As long as nothing that could happen depends on it, states that
// differ in nothing else are one state, whose zone says how long ago the chain began; only where something depends on
// it, the zone is cut at the ends of modes. What has run out then multiplies no states, where nobody looks.
//
// This is exact. The step from one mode of the chain to the next needs no guard, costs no fault, is possible in every
// state, and can be taken in one step with whatever else happens at its instant, before it or after it. Where it
// changes nothing that any component may do, a run with it and the run without it have the same steps and the same
// times. SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "automata/store/memory.hpp"
#include "base/function_ref.hpp"
#include "verifier/behaviour/choices.hpp"
#include "verifier/behaviour/decisions.hpp"
#include "verifier/behaviour/modes_table.hpp"
#include "verifier/property/commands.hpp"

namespace rmpl::verifier {

/// Which components of a plant are folded where. Keeps a reference to the step function.
///
/// A chain is made of modes each of which has one timed exit, nominal, without a guard and at a fixed time after its
/// mode was entered; it ends in one without timed exits. No island of the store that can be inconsistent reads its
/// component, and no formula that is asked about.
class Folds {
 public:
  /// `visible` are the components whose modes a question reads, ascending.
  Folds(automata::PlantStep& step, const TimeModel& time, Commands commands,
        const std::vector<automata::ComponentId>& visible);

  /// Whether there is anything to fold.
  [[nodiscard]] bool any() const { return !timers_.empty(); }

  /// The components that are folded in the possible modes, ascending: none of what any component may do there, under
  /// any command, depends on how far these have come in their chains. The same at each call. Lasts as long as this
  /// does.
  const std::vector<automata::ComponentId>& in(const automata::Modes& modes);

  /// What the clock of a component in a mode is compared with, from there on and up to the end of its chain; nothing
  /// for a mode that begins no chain.
  [[nodiscard]] std::optional<ClockLimits> limits(automata::ComponentId component, automata::ModeId mode) const;

  using Visit = base::FunctionRef<void(const automata::Modes& modes, Zone&& zone)>;
  /// The parts of a state that a step leads to, from where the components `open` were folded: in each part, those of
  /// them that are not folded any more are in one mode of their chains. At the instant at which a mode ends that may be
  /// the one or the next. Clocks: `others`, then those of the components whose modes have timed exits.
  void unfold(const automata::Modes& modes, std::size_t others, const Zone& zone,
              const std::vector<automata::ComponentId>& open, const Visit& visit);
  /// Of a component that is folded at `from`, and in the same mode still: whether that has ended at some reading of the
  /// zone at `from`, and matters there. The first such component.
  [[nodiscard]] std::optional<automata::ComponentId> asked_of(const automata::Modes& there, const automata::Modes& from,
                                                              std::size_t others, const Zone& zone);
  /// The part in which the mode of the component has not ended, and, one mode on, the part in which it has.
  void cut(const automata::Modes& modes, std::size_t others, const Zone& zone, automata::ComponentId component,
           const Visit& visit) const;

 private:
  /// The step from a mode of a chain to the next.
  struct Link {
    automata::ModeId next;
    Units last;   ///< the greatest reading in the mode
    Units after;  ///< the reading at which the next one begins
  };
  /// What a component may do, whichever modes those are in that are not mentioned.
  struct Look {
    std::vector<automata::ComponentId> mentioned;  ///< ascending
    std::vector<Choice> exits;                     ///< of a timer, without its link; staying is `stay`
    auto operator<=>(const Look&) const = default;
  };
  struct Looks {
    Decisions decided;
    automata::Memory<std::uint32_t> rest;
  };
  static constexpr automata::ModeId stay{std::size_t{UINT32_MAX}};

  [[nodiscard]] std::optional<Link> link_of(automata::ComponentId component, automata::ModeId mode) const;
  [[nodiscard]] bool ends_in_time(automata::ComponentId component, automata::ModeId mode) const;
  [[nodiscard]] bool is_timer(automata::ComponentId component) const;
  [[nodiscard]] bool runs(automata::ComponentId timer, const automata::Modes& modes) const {
    return link(timer, modes[timer.index()]).has_value();
  }
  [[nodiscard]] const std::optional<Link>& link(automata::ComponentId component, automata::ModeId mode) const {
    return links_[component.index()][mode.index()];
  }
  std::vector<automata::ComponentId> work_out(const automata::Modes& modes);
  const Look& look(automata::ComponentId component, const automata::Modes& modes,
                   const automata::ControlAction& action);
  std::uint32_t look_anew(automata::ComponentId component, const automata::Modes& modes,
                          const automata::ControlAction& action, Decisions& decided);
  [[nodiscard]] bool leaves_alike(automata::ComponentId timer, automata::Modes& modes,
                                  const automata::ControlAction& action, std::vector<bool>& asked);
  /// The number of the component's clock.
  [[nodiscard]] std::size_t clock_of(automata::ComponentId component, const automata::Modes& modes,
                                     std::size_t others) const;
  /// The zone in which the clock began `by` later; without it, where it does not go on.
  static Zone moved_on(const Zone& zone, std::size_t clock, Units by, bool goes_on);

  automata::PlantStep& step_;
  TimeModel time_;
  Commands commands_;
  std::vector<automata::ComponentId> timers_;                           ///< those with a chain, ascending
  std::vector<std::vector<std::optional<Link>>> links_;                 ///< per component, per mode
  std::vector<std::vector<bool>> live_;                                 ///< whether the mode has timed exits
  std::vector<std::vector<std::vector<automata::ComponentId>>> reads_;  ///< per component, per mode: timers
  std::vector<std::vector<Looks>> looks_;                               ///< per component, per mode
  std::deque<Look> known_looks_;                                        ///< each once
  std::map<Look, std::uint32_t> look_positions_;
  bool in_vain_ = false;  ///< nothing was folded in many modes: nothing is from there on
  /// What was asked last and before: a step is often told by what is different elsewhere.
  struct Asked {
    automata::Modes modes;
    std::uint32_t set = 0;
  };
  std::array<Asked, 2> last_;
  ModesTable table_;                   ///< where it has been asked
  std::vector<std::uint32_t> folded_;  ///< by position there: a position in the next
  std::deque<std::vector<automata::ComponentId>> sets_;
  std::map<std::vector<automata::ComponentId>, std::uint32_t> set_positions_;
};

}  // namespace rmpl::verifier
