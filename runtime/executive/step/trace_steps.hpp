// A run that is over, stepped through as it was written: a trace of `rmpl-run`, or a witness of `tcca-check`.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "runtime/executive/step/stepped_run.hpp"
#include "runtime/executive/step/trace_moments.hpp"

namespace rmpl::runtime {

class ToldEstimator;

/// A position is a line of the trace, or an event of the witness: cycles in which nothing changed are passed over.
class TraceSteps final : public SteppedRun {
 public:
  /// Reads the text as `read_moments` does. Keeps references to plant and program.
  TraceSteps(const automata::Plant& plant, const automata::Program& program, const std::string& text,
             const std::string& name);
  ~TraceSteps() override;

  [[nodiscard]] const automata::Plant& plant() const override { return plant_; }
  [[nodiscard]] const automata::Program& program() const override { return program_; }
  [[nodiscard]] automata::Theory& theory() override { return theory_; }
  [[nodiscard]] std::uint64_t position() const override { return at_; }
  [[nodiscard]] automata::Ticks time() const override { return moments_[at_].stop.time; }
  [[nodiscard]] Stop stop() override { return moments_[at_].stop; }
  [[nodiscard]] std::vector<Prospect> ahead() override { return {}; }
  [[nodiscard]] automata::Ticks next_time() const override {
    return moments_[std::min(at_ + 1, moments_.size() - 1)].stop.time;
  }
  bool advance(const Look& look) override;
  void go_back_to(std::uint64_t position) override { at_ = position; }
  [[nodiscard]] std::string cannot_answer(const automata::Formula& formula) const override;
  std::vector<std::string> take_story() override;

 private:
  void tell_changes();

  const automata::Plant& plant_;
  const automata::Program& program_;
  automata::Theory theory_;
  std::vector<TraceMoment> moments_;
  std::size_t at_ = 0;
  std::vector<std::string> story_;
  std::unique_ptr<ToldEstimator> estimator_;
  CycleRecord record_;
};

}  // namespace rmpl::runtime
