// What a run costs: estimation and reconfiguration, each measured where the executive calls it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "runtime/estimate/estimator.hpp"
#include "runtime/reconfigure/reconfigurer.hpp"

namespace runtime {

/// The calls of one engine.
struct Measurement {
  std::vector<double> seconds;  ///< one a call
  std::size_t checked = 0;      ///< candidates, over all calls
  std::size_t most = 0;         ///< candidates, of one call

  void note(double seconds_taken, std::size_t candidates);

  /// Seconds that this share of the calls took at most; 0 without calls. `share` in (0, 1].
  [[nodiscard]] double quantile(double share) const;
};

struct Measurements {
  Measurement estimation, reconfiguration;
};

/// One line for each engine.
std::string text_of(const Measurements& measurements);

/// Passes on what it is asked, and notes how long the answer took.
class MeteredEstimator final : public Estimator {
 public:
  MeteredEstimator(Estimator& estimator, Measurement& measurement) : estimator_(estimator), measurement_(measurement) {}
  const Estimate& update(const automata::ControlAction& action, const automata::Observation& observation,
                         automata::Ticks now) override;
  [[nodiscard]] const Belief& belief() const override { return estimator_.belief(); }
  [[nodiscard]] const Estimate& estimate() const override { return estimator_.estimate(); }

 private:
  Estimator& estimator_;
  Measurement& measurement_;
};

class MeteredReconfigurer final : public Reconfigurer {
 public:
  MeteredReconfigurer(Reconfigurer& reconfigurer, Measurement& measurement)
      : reconfigurer_(reconfigurer), measurement_(measurement) {}
  Reconfiguration next(const automata::Modes& modes, const automata::Formula& goal) override;
  Reconfiguration next_of_all(std::span<const automata::Modes> tracked, const automata::Formula& goal) override;
  [[nodiscard]] bool looks_at_all() const override { return reconfigurer_.looks_at_all(); }

 private:
  Reconfigurer& reconfigurer_;
  Measurement& measurement_;
};

}  // namespace runtime
