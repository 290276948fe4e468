// Distributions of the time a timed transition takes (6.2.2; language.md "Timing").
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/time/time.hpp"

namespace rmpl::automata {

/// A density over the clock of the source mode, truncated to the bounds of the transition. Parameters are in seconds.
struct Density {
  enum class Kind { uniform, exponential, normal, weibull, erlang };
  Kind kind = Kind::uniform;
  double mean = 0;                ///< exponential, normal, erlang
  double standard_deviation = 0;  ///< normal
  double shape = 0;               ///< weibull; of erlang the number of stages, from 1 to 100
  double scale = 0;               ///< weibull
  bool operator==(const Density&) const = default;
};

/// The time bounds [lower, upper] of a transition, and how probability is spread between them.
/// lower <= upper; lower = upper is a point mass whatever the density. An infinite upper bound excludes `uniform`, but
/// for a fault: that is drawn in each step within the bounds, and its density has no meaning.
struct Timing {
  Ticks lower;
  Ticks upper;
  Density density;
  bool operator==(const Timing&) const = default;

  /// Whether it is uniform without end, which only a fault may be.
  [[nodiscard]] bool lacks_density() const { return upper.is_infinite() && density.kind == Density::Kind::uniform; }
  /// Whether the time that is left never depends on the time that has passed: an exponential density from 0 on without
  /// end, or a fault that is possible from 0 on without end. Nobody needs to know its clock.
  [[nodiscard]] bool memoryless() const {
    using enum Density::Kind;
    return lower == Ticks{} && upper.is_infinite() && (density.kind == exponential || density.kind == uniform);
  }
  /// 1 - G(at): the probability that the transition takes longer than `at`. In [0, 1], falling, 0 from `upper` on.
  [[nodiscard]] double survival(Ticks at) const;
  /// The probability of not firing in the step that takes the clock from `from` to `to`, given that it has not fired
  /// before: (1 - G(to)) / (1 - G(from)), and 0 where G(from) = 1 (semantics 3).
  [[nodiscard]] double step_survival(Ticks from, Ticks to) const;
  /// -ln of `step_survival`, kept exact where the survival is close to 1; +infinity where it is 0.
  [[nodiscard]] double step_hazard(Ticks from, Ticks to) const;
};

}  // namespace rmpl::automata
