// What happened in one cycle of the executive: the source of traces, stories and verdicts.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "automata/monitor.hpp"
#include "automata/state.hpp"
#include "automata/step/program_step.hpp"
#include "runtime/executive/trace/event.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/explain/evidence.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "runtime/reasoning/reconfigure/several_goals.hpp"
#include "runtime/telemetry/sample.hpp"

namespace rmpl::runtime {

/// One cycle. Its buffers are reused from cycle to cycle, so a reader copies what it wants to keep.
struct CycleRecord {
  std::uint64_t cycle = 0;    ///< from 1; 0 is the state in which the run starts, with no command or observations yet
  automata::Ticks start;      ///< when the sequencer asserted the goal and the command was issued
  automata::Ticks time;       ///< when the observations were read and the estimate was made; the next cycle's start
  automata::Marking marking;  ///< at `start`
  automata::Goals goals;      ///< that are pursued; none where goals contradict each other
  std::vector<LeftOut> left_out;    ///< other goals, which have no plan together with these
  automata::ControlAction command;  ///< in force from `start` to `time`
  Reconfiguration::Outcome outcome = Reconfiguration::Outcome::nothing_to_do;  ///< what reconfiguration answered
  Reason why;                                                                  ///< it answered that
  automata::Observation observations;                                          ///< at `time`
  std::vector<Sample> samples;  ///< of channels, that came since the cycle before, in order of time
  const std::vector<std::string>* channels = nullptr;        ///< the names of theirs; null where there are none
  const std::vector<automata::Monitor>* monitors = nullptr;  ///< what made readings of them; null where nobody knows
  automata::Modes estimate;                                  ///< at `time`
  double probability = 0;                                    ///< of the estimate
  bool consistent = true;                                    ///< whether the estimate explains the observations
  automata::Observation set_aside;         ///< of the observations: what did not count, as of `Estimate`
  const Estimator* estimator = nullptr;    ///< whose belief is that at `time`; never null while an observer looks
  const automata::Modes* truth = nullptr;  ///< at `time`; null where the plant is not simulated
  std::vector<std::string> known;          ///< at `time`, of what the program asks of the executive's knowledge
  std::vector<Event> events;
  std::vector<Evidence> evidence;      ///< of the diagnoses that are new in this cycle, by component
  std::size_t checked = 0;             ///< candidates that estimation checked
  std::size_t considered = 0;          ///< candidates that reconfiguration checked; 0 where it was not asked anew
  double estimation_seconds = 0;       ///< processor time, where it is measured
  double reconfiguration_seconds = 0;  ///< likewise
};

/// Looks on while the executive runs.
class CycleObserver {
 public:
  virtual ~CycleObserver() = default;
  virtual void observe(const CycleRecord& record) = 0;
};

}  // namespace rmpl::runtime
