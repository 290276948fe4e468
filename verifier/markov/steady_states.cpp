// States of a closed loop that an outlook tells all about.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "verifier/markov/loop_process.hpp"

namespace rmpl::verifier {

std::optional<Enclosure> LoopProcess::steady_hazard(const std::vector<LoopStateId>& places) {
  std::optional<Enclosure> result;
  for (const LoopStateId place : places) {
    const auto& own = cycles_.told(place).steady_hazard;
    if (!own || (result && *result != *own)) return std::nullopt;
    result = own;
  }
  return result;
}

/// Clocks of components that do not matter read nothing.
void LoopProcess::stop_idle_clocks(const std::vector<LoopStateId>& places, std::vector<Units>& ages) {
  for (std::size_t c = 0; c < ages.size(); ++c) {
    const bool idle = std::all_of(places.begin(), places.end(), [&](LoopStateId place) {
      const Outlook::Told& told = cycles_.told(place);
      return !told.idle.empty() && told.idle[c] && told.modes[c] == loop_[place].modes[c];
    });
    if (idle) ages[c] = 0;
  }
}

/// Adds a state of which all is known without the loop.
StateNumber LoopProcess::add_known(const Prospect& prospect, const Enclosure& hazard) {
  const auto fresh = static_cast<StateNumber>(states_.size());
  State state{{}, 0, {}, {}, {}, {}, prospect, hazard};
  states_.push_back(std::move(state));
  // States and lists are numbered alike.
  numbers_.number({0, fresh});
  meter_.count_state();
  return fresh;
}

StateNumber LoopProcess::enter_steady(const Enclosure& hazard) {
  const auto known = steady_.find({hazard.lower, hazard.upper});
  if (known != steady_.end()) return known->second;
  const StateNumber fresh = add_known({0, hazard.upper}, hazard);
  steady_.emplace(std::pair(hazard.lower, hazard.upper), fresh);
  return fresh;
}

StateNumber LoopProcess::enter_end() {
  if (!end_) end_ = add_known({}, {});
  return *end_;
}

void LoopProcess::leave_steady(StateNumber number_of_state) {
  const Enclosure hazard = states_[number_of_state].hazard;
  Row& row = rows_.emplace_back();
  const Enclosure stays = outward({1 - hazard.upper, 1 - hazard.lower}, 1);
  row.edges.push_back({number_of_state, as_probability(stays), 0});
  if (hazard.upper > 0) row.edges.push_back({enter_end(), hazard, 0});
}

}  // namespace rmpl::verifier
