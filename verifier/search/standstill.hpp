// Standing still: where time cannot pass, and no steps at that instant lead to where it can.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "verifier/zone/zone.hpp"

namespace rmpl::verifier {

/// An interval for one clock of a zone, by its number there.
struct ZoneBound {
  std::size_t clock;
  Interval range;
};

/// All of them hold.
using ZoneBox = std::vector<ZoneBound>;

/// A step that may be taken at an instant.
struct Instant {
  std::uint64_t target;
  std::uint32_t move;                 ///< what its system calls it
  ZoneBox bounds;                     ///< where it can be taken
  std::vector<std::size_t> restarts;  ///< clocks that start anew with it
  bool leads_on = false;              ///< it leads to where it cannot come back from
};

/// What may happen at an instant. Clocks are those of the zone in which it began: what has started anew since then read
/// 0 there too.
class Instants {
 public:
  virtual ~Instants() = default;
  /// Where time can pass; in sampled time, where there is a step.
  virtual const std::vector<ZoneBox>& waits(std::uint64_t node) = 0;
  /// The steps one by one, from 0; null behind the last. In sampled time there are none. Both are kept as long as this
  /// object is: mostly few steps are asked for, as soon one leads on.
  virtual const Instant* step(std::uint64_t node, std::size_t number) = 0;
};

/// Readings from which on time never passes again.
struct Standstill {
  Zone zone;
  /// Steps lead round and round: those of one way, which comes back to where its step `repeats_from` sets out. None
  /// where no step can be taken: it is stuck.
  std::vector<Instant> round;
  std::size_t repeats_from = 0;
};

/// How runs have been seen to be cut off.
struct CutOff {
  bool stuck = false;  ///< nothing can follow
  bool still = false;  ///< time stands still: only what takes no time can
  bool spent = false;  ///< more faults are certain than there may be

  /// Whether the model has no future there, so that nothing can be said of it.
  [[nodiscard]] bool ends() const { return stuck || still; }
  /// Adds what was seen elsewhere.
  CutOff& operator|=(const CutOff& other) {
    stuck = stuck || other.stuck;
    still = still || other.still;
    spent = spent || other.spent;
    return *this;
  }
};

/// Readings of the zone at `node` in which it is stuck, or in which all steps of the instant lead round and round.
/// Where steps lead on to such readings, they are found there: a search that looks at all it comes to misses nothing.
/// What goes round for ever has started all of its clocks anew, so that a step of a clock that reads more than 0 is on
/// no such way. Where bounds tell readings apart the zone is split, one bound at a time.
std::optional<Standstill> find_standstill(const Zone& zone, std::uint64_t node, Instants& instants);

}  // namespace rmpl::verifier
