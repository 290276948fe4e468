// Situations: a mode for every component, with all that may happen there.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/explore/choices.hpp"
#include "verifier/explore/commands.hpp"
#include "verifier/explore/limits.hpp"

namespace verifier {

/// A position in `Situations`.
using SituationId = automata::Id<struct SituationTag>;

/// An interval for the clock of one component, which is live.
struct ClockBound {
  automata::ComponentId component;
  Interval clock;
  auto operator<=>(const ClockBound&) const = default;
};

/// A box: all of its bounds hold. Sorted by component, trivial bounds left out.
using Box = std::vector<ClockBound>;

/// One joint step of all components, or, in sampled time, a hold: periods in which a command keeps everything from
/// changing although it would under idle controls.
struct Move {
  SituationId target;
  std::uint32_t action;  ///< position in `Situations::action`; the first one that enables it
  unsigned faults = 0;
  bool hold = false;  ///< `bounds` is then like a wait's
  Box bounds;
};

/// What may happen in given modes. The clocks that matter are those of components whose mode has a timed exit.
struct Situation {
  automata::Modes modes;
  std::vector<automata::ComponentId> live;  ///< ascending
  std::vector<ClockLimits> limits;          ///< of the live clocks
  std::vector<Box> waits;                   ///< see `waits` in choices.hpp; within one of these boxes time may pass
};

/// All situations met so far, by number, in the order in which they were met. One table serves several searches.
class Situations {
 public:
  /// Keeps references to all but `reading`. The meter is polled while moves are worked out; it may throw.
  Situations(automata::PlantStep& step, const Reading& reading, Commands commands, unsigned faults, Meter& meter);

  [[nodiscard]] const automata::Plant& plant() const { return step_.plant(); }
  [[nodiscard]] unsigned faults() const { return faults_; }
  [[nodiscard]] const Reading& reading() const { return reading_; }
  [[nodiscard]] const automata::ControlAction& action(std::uint32_t position) const { return actions_[position]; }

  /// The number of a possible situation; nothing where the store of the modes is inconsistent.
  std::optional<SituationId> find(const automata::Modes& modes);
  [[nodiscard]] const Situation& operator[](SituationId id) const { return entries_[id.index()].situation; }
  /// Every joint step that changes a mode with no more faults than `faults`; holds first. Worked out when first asked.
  const std::vector<Move>& moves(SituationId id);

  /// The possible situations of the initial distribution, or with the given modes in its place for their components.
  std::vector<SituationId> initial(const std::vector<automata::Assignment>& from);

 private:
  struct Entry {
    Situation situation;
    std::vector<Move> moves;
    bool worked_out = false;
  };

  [[nodiscard]] Situation describe(const automata::Modes& modes);
  [[nodiscard]] std::vector<Box> waits(const automata::Modes& modes, const std::vector<automata::Enabled>& enabled);
  [[nodiscard]] std::vector<Move> work_out(SituationId id);

  automata::PlantStep& step_;
  Reading reading_;
  Commands commands_;
  unsigned faults_;
  Meter& meter_;
  std::deque<Entry> entries_;  ///< a deque: references stay good while it grows
  std::unordered_map<automata::Modes, std::optional<SituationId>, automata::ModesHash> numbers_;
  std::vector<automata::ControlAction> actions_;
};

}  // namespace verifier
