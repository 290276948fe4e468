// What is left to be gained on the way to the end of a window: an upper bound of the observation factors to come, which
// says how far a way through a plant may still go (window_search.hpp).
//
// Near likely modes, for each update, the readings that these leave open stay open until one of the components that
// this rests on is in another mode (open_readings.hpp). So all factors of a way are at most those near the likely
// modes, times what each component gains where it is elsewhere; and where it can be, its own transitions say, whatever
// their guards. Exact where all components are in the likely modes; never too low. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "runtime/reasoning/estimate/extensions.hpp"

namespace rmpl::runtime {

/// Logarithms of probabilities throughout.
class WindowProspects {
 public:
  /// One update, and how long it took.
  struct Update {
    const NearbyFactors* factors;
    automata::Ticks length;
  };
  /// A component that may gain.
  struct Contested {
    std::size_t component;
    std::vector<std::vector<double>> gain;  ///< after so many updates, by mode: what it may gain until the end
  };

  /// `scaled`, by component: whether outcomes with it may contradict the store.
  WindowProspects(const automata::Plant& plant, const std::vector<Update>& updates, const std::vector<bool>& scaled);

  [[nodiscard]] const std::vector<Contested>& contested() const { return contested_; }
  /// What all updates after the first `updates` make of any way, before the gains.
  [[nodiscard]] double to_come(std::size_t updates) const { return to_come_[updates]; }
  /// The same with the gains of these modes.
  [[nodiscard]] double of(std::size_t updates, const automata::Modes& modes) const;

 private:
  std::vector<double> to_come_;
  std::vector<Contested> contested_;
};

}  // namespace rmpl::runtime
