// Drawing faults.
// SPDX-License-Identifier: MIT
#include "runtime/executive/campaign/injection.hpp"

#include <algorithm>

#include "automata/fault_step.hpp"
#include "runtime/executive/plant/random_source.hpp"

namespace rmpl::runtime {
namespace {

constexpr std::uint64_t injection_stream = 3;  // apart from those of the plant and its sensors

}  // namespace

std::vector<Fault> faults_of(const automata::Plant& plant) {
  std::vector<Fault> faults;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const automata::Component& component = plant.components[c];
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      if (!component.modes[m].fault || automata::is_second_in_a_row(component, automata::ModeId(m))) continue;
      faults.push_back({automata::ComponentId(c), automata::ModeId(m)});
    }
  }
  return faults;
}

std::size_t fallible_components(const automata::Plant& plant) {
  return static_cast<std::size_t>(
      std::count_if(plant.components.begin(), plant.components.end(), [](const automata::Component& component) {
        return std::any_of(component.modes.begin(), component.modes.end(), [](const auto& mode) { return mode.fault; });
      }));
}

std::uint64_t seed_of_run(const CampaignPlan& plan, std::uint64_t run) {
  return RandomSource(plan.seed, run).next() >> 1U;
}

std::vector<automata::ForcedMode> injections(const CampaignPlan& plan, const automata::Plant& plant,
                                             automata::Ticks cycle, std::uint64_t run) {
  std::vector<Fault> faults = faults_of(plant);
  std::vector<automata::ForcedMode> result;
  if (!plan.times.empty() && !faults.empty()) {
    const Fault& fault = faults[run % faults.size()];
    result.push_back({plan.times[run / faults.size() % plan.times.size()], fault.component, fault.mode, {}});
    return result;
  }
  RandomSource random(seed_of_run(plan, run), injection_stream);
  for (std::size_t f = 0; f < plan.faults && !faults.empty(); ++f) {
    const Fault drawn = faults[random.below(faults.size())];
    const auto ends = static_cast<std::int64_t>(1 + random.below(plan.cycles));
    result.push_back({{cycle.count * ends}, drawn.component, drawn.mode, {}});
    std::erase_if(faults, [&](const Fault& fault) { return fault.component == drawn.component; });
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  return result;
}

}  // namespace rmpl::runtime
