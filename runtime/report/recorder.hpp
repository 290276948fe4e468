// Makes the data of a flight while the executive flies it.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/scenario.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/report/flight.hpp"

namespace rmpl::runtime {

/// Memory grows with what changes, not with the cycles. The belief is looked at in the cycles only in which the
/// estimate has less than all but a half percent of it.
class Recorder final : public CycleObserver {
 public:
  /// Keeps references; so does the flight.
  Recorder(const automata::Document& document, const automata::Scenario& scenario);

  void observe(const CycleRecord& record) override;
  /// The flight is over.
  Flight finish(const ScenarioResult& result);
  /// The flight up to now, as if it were over; costs a copy.
  [[nodiscard]] Flight so_far(const ScenarioResult& result) const { return Recorder(*this).finish(result); }
  /// What was observed and not forgotten, as it is.
  [[nodiscard]] const Flight& flight() const { return flight_; }
  /// Keeps what holds now, and of what happened what goes on: a flight without end can be followed.
  void forget();

 private:
  void note_action(const CycleRecord& record);
  void note_samples(const CycleRecord& record);
  void note_state(const CycleRecord& record);
  void note_belief(const CycleRecord& record);
  void note_events(const CycleRecord& record);

  const automata::Scenario& scenario_;
  const automata::Plant& plant_;
  Flight flight_;
  // As of the cycle before; a cycle in which nothing changes costs comparisons only.
  automata::Goals goals_;
  std::string set_aside_;
  automata::ControlAction command_;
  automata::Marking marking_;
  automata::Observation observations_;
  automata::Modes estimate_;
  automata::Modes truth_;
  Reconfiguration::Outcome outcome_ = Reconfiguration::Outcome::nothing_to_do;
  Reason why_;
  bool certain_ = true;
  std::vector<std::pair<Event, std::size_t>> open_;  ///< events that go on, with their happenings
};

}  // namespace rmpl::runtime
