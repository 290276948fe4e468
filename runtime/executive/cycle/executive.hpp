// The timed model-based executive: sequencer, ME and MR around one plant (thesis 7.1, Fig. 7-1; semantics 6).
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/program.hpp"
#include "automata/step/program_step.hpp"
#include "runtime/executive/cycle/clock.hpp"
#include "runtime/executive/cycle/control_adapter.hpp"
#include "runtime/executive/cycle/estimation_dispatcher.hpp"
#include "runtime/executive/cycle/message.hpp"
#include "runtime/executive/cycle/message_queue.hpp"
#include "runtime/executive/cycle/monitor_adapter.hpp"
#include "runtime/executive/cycle/reconfiguration_dispatcher.hpp"
#include "runtime/executive/plant/plant_interface.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/insight.hpp"
#include "runtime/reasoning/explain/explainer.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// Executes a control program on a plant, cycle by cycle. Cycle i (from 1) starts at (i - 1) * `cycle`: the sequencer
/// asserts goals, MR commands the plant, time advances to i * `cycle`, observations arrive, ME estimates, and the
/// sequencer advances its marking. Keeps references to all that it is made of.
class Executive {
 public:
  /// `program` is bound to `model`. `cycle` is above 0.
  Executive(const automata::Program& program, const automata::Plant& model, Estimator& estimator,
            Reconfigurer& reconfigurer, PlantInterface& plant, Clock& clock, automata::Ticks cycle);

  /// The state in which the run starts, as cycle 0; then what the last `run_cycle` did.
  [[nodiscard]] const CycleRecord& record() const { return record_; }
  /// Runs one cycle. After the end of the program cycles go on, with no goal. Throws base::InputError where it would
  /// last beyond the end of time, some 292 years.
  const CycleRecord& run_cycle();
  // The same in two parts.
  /// Begins a cycle: asserts goals, and puts MR's command in force. The record then has the number, marking, goals and
  /// command of the cycle that has begun; the rest of it is still what was read back in the cycle before.
  const CycleRecord& decide();
  /// Goes on to the end of that cycle, and reads back. Throws as `run_cycle` does.
  const CycleRecord& carry_out();
  /// From now on what a scenario commands takes the place of MR's command. Before the first cycle; keeps a reference.
  void obey(const CommandScript& script) { reconfiguration_.obey(script); }
  /// From now on records tell what each engine takes; reading the processor's time costs a sixth of a quick cycle.
  void measure() { measured_ = true; }
  /// Whether the program has ended: no location is marked.
  [[nodiscard]] bool ended() const { return sequencer_.ended(); }

 private:
  /// Does `work`; in seconds of processor time, 0 where nobody measures.
  template <class Work>
  double timed(const Work& work) const;
  [[nodiscard]] automata::Ticks end_of(std::uint64_t cycle) const;
  void assert_goals();
  void note_reconfiguration();
  void note_commanded(const Reconfiguration& answer);
  void read_back(const automata::Observation& observations);
  void know_itself(const automata::Observation& counted);

  const automata::Plant& model_;
  const automata::Program& program_;
  PlantInterface& plant_;
  Clock& clock_;
  const automata::Ticks cycle_;
  Estimator& estimator_;
  automata::ProgramStep sequencer_;
  MessageQueue<EstimationMessage> to_estimation_;
  MessageQueue<ReconfigurationMessage> to_reconfiguration_;
  ControlAdapter control_;
  MonitorAdapter monitor_;
  ReconfigurationDispatcher reconfiguration_;
  EstimationDispatcher estimation_;
  Explainer explainer_;
  Insight insight_;
  automata::Knowledge knowledge_;  ///< of the sequencer: the last estimate, and the observations that it explains
  std::vector<automata::Goals> asserted_;  ///< of the cycle at hand
  CycleRecord record_;
  bool measured_ = false;
};

}  // namespace rmpl::runtime
