// The steps that are possible in a state.
// SPDX-License-Identifier: MIT
#include "verifier/witness/steps_at.hpp"

#include <algorithm>

#include "base/product.hpp"
#include "verifier/witness/rules.hpp"

namespace rmpl::verifier {

using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Ticks;

bool StepsAt::at_bound() {
  if (held_ == nullptr) return false;
  const std::vector<automata::Enabled> enabled = rules_.enabled(state_.modes, *held_);
  for (std::size_t c = 0; c < state_.modes.size(); ++c) {
    const Ticks clock = now_ - state_.clock_starts[c];
    const Rules rules(rules_.plant().components[c], enabled[c], clock, clock, period_);
    if (!rules.may_rest(state_.modes[c])) return false;
  }
  return true;
}

/// Of each component the modes that it may be in next without a fault.
std::vector<std::vector<ModeId>> StepsAt::options(const ControlAction& action) {
  const automata::Plant& plant = rules_.plant();
  const bool bound = at_bound();
  const std::vector<automata::Enabled> enabled = rules_.enabled(state_.modes, action);
  std::vector<std::vector<ModeId>> result;
  for (std::size_t c = 0; c < state_.modes.size(); ++c) {
    const Ticks clock = now_ - state_.clock_starts[c];
    const Rules rules(plant.components[c], enabled[c], clock - period_.value_or(Ticks{0}), clock, period_);
    auto& own = result.emplace_back();
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      if (rules.allows_lastingly(state_.modes[c], ModeId(m), bound)) own.emplace_back(m);
    }
  }
  return result;
}

bool StepsAt::fault_is_certain(const ControlAction& action) {
  const auto all = options(action);
  return std::any_of(all.begin(), all.end(), [](const auto& own) { return own.empty(); });
}

/// Whether a restart changes what a clock that matters reads.
bool StepsAt::starts_anew(const ControlAction& action) {
  const std::vector<bool> restarted = rules_.restarted(state_.modes, action);
  for (std::size_t c = 0; c < restarted.size(); ++c) {
    if (!restarted[c] || state_.clock_starts[c] == now_) continue;
    if (rules_.plant().has_timed_exit(automata::ComponentId(c), state_.modes[c])) return true;
  }
  return false;
}

bool StepsAt::any(const ControlAction& action, base::FunctionRef<bool(const Modes&)> visit) {
  const auto options = this->options(action);
  const bool only_changes = !period_ && !starts_anew(action);
  Modes next;
  std::size_t changes = 0;
  const auto is_change = [&](std::size_t c, std::size_t i) { return options[c][i] != state_.modes[c] ? 1U : 0U; };
  return base::multiply_out(
      options,
      [&](std::size_t c, std::size_t i) {
        next.push_back(options[c][i]);
        changes += is_change(c, i);
        return true;
      },
      [&](std::size_t c, std::size_t i) {
        next.pop_back();
        changes -= is_change(c, i);
      },
      [&] {
        if (changes == 0 && only_changes) return false;
        if (rules_.possible(next)) return visit(next);
        if (refused_.empty() || changes < changes_) {
          refused_ = next;
          changes_ = changes;
        }
        return false;
      });
}

bool StepsAt::time_passes(const ControlAction& action) {
  const std::vector<automata::Enabled> enabled = rules_.enabled(state_.modes, action);
  for (std::size_t c = 0; c < state_.modes.size(); ++c) {
    const Ticks clock = now_ - state_.clock_starts[c];
    const Rules now(rules_.plant().components[c], enabled[c], clock, clock, std::nullopt);
    const Rules then(rules_.plant().components[c], enabled[c], clock, clock + Ticks{1}, std::nullopt);
    const ModeId mode = state_.modes[c];
    if (!now.allows_without_fault(mode, mode) || !then.allows_time(mode)) return false;
  }
  return true;
}

}  // namespace rmpl::verifier
