// Collects the result of one run of a campaign.
// SPDX-License-Identifier: MIT
#include "runtime/executive/campaign/watch.hpp"

#include <algorithm>

#include "automata/fault_step.hpp"

namespace rmpl::runtime {

namespace {

bool is_forced(const CycleRecord& record, automata::ComponentId component) {
  return std::any_of(record.events.begin(), record.events.end(), [&](const Event& event) {
    return event.kind == Event::Kind::forced && event.component == component;
  });
}

}  // namespace

CampaignWatch::CampaignWatch(const automata::Plant& plant, const std::vector<automata::ForcedMode>& faults)
    : plant_(plant), step_(plant), twins_(faults.size()) {
  for (const automata::ForcedMode& fault : faults) injected_.push_back({fault, {}, {}, {}});
}

void CampaignWatch::observe(const CycleRecord& record) {
  if (record.cycle == 0) {
    before_ = {*record.truth, std::vector<automata::Ticks>(record.truth->size())};
    return;
  }
  for (std::size_t i = 0; i < injected_.size(); ++i) {
    Injected& injected = injected_[i];
    const automata::ForcedMode& fault = injected.fault;
    const bool there = (*record.truth)[fault.component.index()] == fault.mode && is_forced(record, fault.component);
    if (injected.forced || fault.at > record.time || !there) continue;
    injected.forced = record.time;
    twins_[i].emplace(step_, before_, injected.fault.component);
  }
  look_for_symptoms(record);
  count_chance(record);
  if (record.estimate == *record.truth) ++right_;
  for (Injected& injected : injected_) {
    const bool named = record.estimate[injected.fault.component.index()] == injected.fault.mode;
    if (injected.forced && !injected.named && named) injected.named = record.time;
  }
  before_ = step_.advance(before_, record.command, *record.truth, record.time);
  from_ = record.time;
}

void CampaignWatch::look_for_symptoms(const CycleRecord& record) {
  const FlownStep flown{before_.modes, *record.truth, record.command, record.observations,
                        record.events, from_,         record.time};
  for (std::size_t i = 0; i < twins_.size(); ++i) {
    if (!twins_[i] || !twins_[i]->contradicted_by(flown)) continue;
    injected_[i].symptom = record.time;
    twins_[i].reset();
  }
}

void CampaignWatch::count_chance(const CycleRecord& record) {
  for (std::size_t c = 0; c < record.truth->size(); ++c) {
    if (!automata::is_fault_step(plant_.components[c], before_.modes[c], (*record.truth)[c])) continue;
    if (!is_forced(record, automata::ComponentId(c))) ++by_chance_;
  }
}

}  // namespace rmpl::runtime
