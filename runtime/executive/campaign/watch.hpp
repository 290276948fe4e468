// Observes one run of a campaign: estimate against truth, and what became of each injected fault.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/scenario.hpp"
#include "runtime/executive/campaign/counterfactual.hpp"
#include "runtime/executive/trace/cycle_record.hpp"

namespace rmpl::runtime {

/// One injected fault.
struct Injected {
  automata::ForcedMode fault;
  std::optional<automata::Ticks> forced;   ///< the end of the cycle in which it happened; none where it never did
  std::optional<automata::Ticks> symptom;  ///< the first readings that the flight without it could not have had
  std::optional<automata::Ticks> named;    ///< the first estimate from `forced` on that has it
};

class CampaignWatch final : public CycleObserver {
 public:
  /// `faults` are those of the scenario that the campaign injected.
  CampaignWatch(const automata::Plant& plant, const std::vector<automata::ForcedMode>& faults);

  void observe(const CycleRecord& record) override;
  [[nodiscard]] const std::vector<Injected>& injected() const { return injected_; }
  /// Cycles whose estimate was the truth, in every component.
  [[nodiscard]] std::uint64_t right() const { return right_; }
  /// Transitions into a fault mode that were not injected.
  [[nodiscard]] std::uint64_t by_chance() const { return by_chance_; }

 private:
  void look_for_symptoms(const CycleRecord& record);
  void count_chance(const CycleRecord& record);

  const automata::Plant& plant_;
  automata::PlantStep step_;
  automata::SystemState before_;
  automata::Ticks from_;
  std::vector<Injected> injected_;
  std::vector<std::optional<Counterfactual>> twins_;  ///< by injected fault; from its step until it has a symptom
  std::uint64_t right_ = 0;
  std::uint64_t by_chance_ = 0;
};

}  // namespace rmpl::runtime
