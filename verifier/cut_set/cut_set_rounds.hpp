// Cut sets round by round, each with one fault more, so that a limit leaves what the rounds before have settled.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "verifier/property/fault.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// A round finds every minimal set of the runs with so many faults: the states that more faults lead to, by far the
/// most, are not even entered before all runs with fewer have been followed. The last round has all faults that there
/// may be, and alone decides (M. Bozzano, A. Cimatti, A. Griggio, C. Mattarei: Efficient Anytime Techniques for
/// Model-Based Safety Analysis, 2015).
class CutSetRounds {
 public:
  /// Keeps a reference.
  CutSetRounds(const automata::Plant& plant, unsigned most) : plant_(plant), most_(most) {}

  /// How many faults there may be in the round at hand.
  [[nodiscard]] unsigned faults() const { return faults_; }
  /// The round has come to its end with these sets, and explored states with up to `used` faults: whether another round
  /// is to follow. Where no state needs as many faults as there may be, or none at all are needed, the last one is
  /// next, or this was it.
  bool next(const std::vector<CutSet>& sets, unsigned used);
  /// A limit has ended the round, in which the answer's cut sets are minimal. Those of them are left, and those of
  /// earlier rounds added, that are minimal whatever further rounds would find; and how far these are all.
  void settle(Answer& answer) const;

 private:
  [[nodiscard]] bool may_come_twice(const Fault& fault) const;
  [[nodiscard]] bool is_settled(const CutSet& cut) const;

  const automata::Plant& plant_;
  unsigned most_;
  unsigned faults_ = 0;
  std::vector<CutSet> before_;             ///< of the round before
  std::optional<unsigned> before_faults_;  ///< which had so many
};

}  // namespace rmpl::verifier
