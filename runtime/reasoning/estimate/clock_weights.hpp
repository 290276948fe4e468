// What each clock of a source is worth into the modes of a target: the same for all targets that agree on the
// components whose moves rest on the clock. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "runtime/reasoning/estimate/source.hpp"

namespace rmpl::runtime {

/// A memory of one search. Its vectors serve the next one.
class ClockWeights {
 public:
  /// Forgets all; there are so many sources now.
  void begin(std::size_t sources);

  struct Weights {
    std::vector<automata::ModeId> to;  ///< of the varied components of the source
    std::vector<double> by_clock;      ///< `Source::weight_into`
    double sum = 0;
  };
  /// Of the source with this number, into a target. Valid until the next call.
  const Weights& into(std::size_t number, const Source& source, const automata::Modes& target);

 private:
  struct Known {
    std::vector<Weights> weights;  ///< the first `size` hold
    std::size_t size = 0;
  };
  std::vector<Known> known_;  ///< by source
};

}  // namespace rmpl::runtime
