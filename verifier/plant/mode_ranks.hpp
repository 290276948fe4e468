// How far modes are from where a run starts.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::verifier {

/// By component, by mode: the most transitions that lead to the mode from where the component starts, without those
/// that lead back to a mode on the way. A search that explores what is nearer by the sum of these first mostly has all
/// that leads to a state before the state itself, and so its greatest zone: what smaller ones lead to need not be
/// explored (Herbreteau and Tran, "Improving search order for reachability testing in timed automata", FORMATS 2015).
class ModeRanks {
 public:
  ModeRanks(const automata::Plant& plant, const automata::Modes& start);

  [[nodiscard]] std::uint32_t sum(const automata::Modes& modes) const;

 private:
  std::vector<std::vector<std::uint32_t>> ranks_;
};

}  // namespace rmpl::verifier
