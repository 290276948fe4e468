// Backwards through the updates, component by component.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/window/window_prospects.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rmpl::runtime {
namespace {

constexpr double never = -std::numeric_limits<double>::infinity();

/// Of getting from one mode to another in a step, at most: guards may hold or not, and faults leave all to what is
/// nominal. `scaled`: that some outcomes cannot happen may make the others as likely as can be.
std::vector<std::vector<double>> chances(const automata::Component& component, automata::Ticks length, bool scaled) {
  const std::size_t modes = component.modes.size();
  std::vector<std::vector<double>> chance(modes, std::vector<double>(modes, 0.0));
  for (std::size_t m = 0; m < modes; ++m) chance[m][m] = 1;
  for (const automata::Transition& transition : component.transitions) {
    if (!automata::can_ever_be_taken(transition)) continue;
    double& way = chance[transition.from.index()][transition.to.index()];
    way += component.is_fault(transition) ? transition.weight.fault_probability(length) : 1.0;
  }
  for (auto& from : chance) {
    for (double& way : from) way = way > 0 ? std::log(scaled ? 1.0 : std::min(1.0, way)) : never;
  }
  return chance;
}

}  // namespace

WindowProspects::WindowProspects(const automata::Plant& plant, const std::vector<Update>& updates,
                                 const std::vector<bool>& scaled)
    : to_come_(updates.size() + 1, 0.0) {
  for (std::size_t t = updates.size(); t-- > 0;) to_come_[t] = to_come_[t + 1] + std::log(updates[t].factors->most);
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const auto gains = [&](const Update& update) -> const std::vector<double>* {
      const auto own = update.factors->gains.find(c);
      return own == update.factors->gains.end() ? nullptr : &own->second;
    };
    if (std::none_of(updates.begin(), updates.end(), gains)) continue;
    const std::size_t modes = plant.components[c].modes.size();
    Contested& own = contested_.emplace_back(Contested{c, {}});
    own.gain.assign(updates.size() + 1, std::vector<double>(modes, 0.0));
    for (std::size_t t = updates.size(); t-- > 0;) {
      const auto chance = chances(plant.components[c], updates[t].length, scaled[c]);
      const std::vector<double>* now = gains(updates[t]);
      for (std::size_t from = 0; from < modes; ++from) {
        double best = never;
        for (std::size_t to = 0; to < modes; ++to) {
          const double gain = now != nullptr ? std::log((*now)[to]) : 0.0;
          best = std::max(best, chance[from][to] + gain + own.gain[t + 1][to]);
        }
        own.gain[t][from] = best;
      }
    }
  }
}

double WindowProspects::of(std::size_t updates, const automata::Modes& modes) const {
  double result = to_come_[updates];
  for (const Contested& c : contested_) result += c.gain[updates][modes[c.component].index()];
  return result;
}

}  // namespace rmpl::runtime
