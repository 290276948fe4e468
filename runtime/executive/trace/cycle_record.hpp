// What happened in one cycle of the executive: the source of traces, stories and verdicts.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/program_step.hpp"
#include "runtime/executive/trace/event.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/explain/evidence.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// One cycle. Its buffers are reused from cycle to cycle, so a reader copies what it wants to keep.
struct CycleRecord {
  std::uint64_t cycle = 0;    ///< from 1; 0 is the state in which the run starts, with no command or observations yet
  automata::Ticks start;      ///< when the sequencer asserted the goal and the command was issued
  automata::Ticks time;       ///< when the observations were read and the estimate was made; the next cycle's start
  automata::Marking marking;  ///< at `start`
  std::vector<automata::Assignment> goal;         ///< empty where nothing is asserted, or goals contradict each other
  std::vector<automata::LocationId> asserted_by;  ///< for each of the goal, the first location that asserts it
  automata::ControlAction command;                ///< in force from `start` to `time`
  Reconfiguration::Outcome outcome = Reconfiguration::Outcome::nothing_to_do;  ///< what reconfiguration answered
  Reason why;                                                                  ///< it answered that
  automata::Observation observations;                                          ///< at `time`
  automata::Modes estimate;                                                    ///< at `time`
  double probability = 0;                                                      ///< of the estimate
  bool consistent = true;                  ///< whether the estimate explains the observations
  const Estimator* estimator = nullptr;    ///< whose belief is that at `time`; never null while an observer looks
  const automata::Modes* truth = nullptr;  ///< at `time`; null where the plant is not simulated
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
