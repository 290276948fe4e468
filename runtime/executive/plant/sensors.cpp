// Readings drawn among those that the store allows.
// SPDX-License-Identifier: MIT
#include "runtime/executive/plant/sensors.hpp"

#include <algorithm>
#include <utility>

#include "base/check.hpp"

namespace rmpl::runtime {
namespace {

/// Beyond this many prefixes the tree is grown anew: many free sensors make it as wide as the run is long.
constexpr std::size_t memory_limit = 1U << 15U;

}  // namespace

Sensors::Sensors(automata::PlantStep& step, NumberSource numbers)
    : step_(step), numbers_(std::move(numbers)), observables_(step.plant().observables), prefixes_(1) {
  std::sort(observables_.begin(), observables_.end());
}

void Sensors::forget_all() {
  prefixes_.resize(1);
  roots_.clear();
}

/// One model shows one value to be possible, and mostly that it is the only one.
std::uint32_t Sensors::look(std::size_t depth) {
  const automata::VariableId variable = observables_[depth];
  automata::Theory& theory = step_.theory();
  [[maybe_unused]] const bool possible = theory.consistent(assumptions_);
  CHECK(possible && "so far every reading was possible");
  const automata::ValueId found = theory.value(variable);
  const bool entailed = theory.known_to_follow({variable, found});
  Prefix prefix;
  for (std::size_t v = 0; v < step_.plant().variables[variable].values.size(); ++v) {
    const automata::ValueId value(v);
    if (value != found && entailed) continue;
    assumptions_.push_back({variable, value});
    if (value == found || theory.consistent(assumptions_)) prefix.candidates.push_back(value);
    assumptions_.pop_back();
  }
  prefix.next.resize(prefix.candidates.size());
  prefixes_.push_back(std::move(prefix));
  return static_cast<std::uint32_t>(prefixes_.size() - 1);
}

const automata::Observation& Sensors::read(const automata::Modes& modes) {
  readings_.clear();
  if (observables_.empty()) return readings_;
  numbers_.begin_step();
  if (prefixes_.size() > memory_limit) forget_all();
  assumptions_.clear();
  for (std::size_t c = 0; c < modes.size(); ++c) {
    assumptions_.push_back({step_.plant().components[c].mode, automata::ValueId(modes[c].index())});
  }
  std::uint32_t& root = roots_[modes];
  if (root == 0) root = look(0);
  std::uint32_t at = root;
  for (std::size_t depth = 0; depth < observables_.size(); ++depth) {
    // An entailed value costs no draw, so that sensors which are sure do not shift those which are not.
    const std::size_t count = prefixes_[at].candidates.size();
    const std::size_t drawn = count == 1 ? 0 : position_below(count, numbers_.number(depth));
    const automata::Assignment reading{observables_[depth], prefixes_[at].candidates[drawn]};
    readings_.push_back(reading);
    assumptions_.push_back(reading);
    if (depth + 1 == observables_.size()) break;
    if (prefixes_[at].next[drawn] == 0) {
      const std::uint32_t longer = look(depth + 1);
      prefixes_[at].next[drawn] = longer;
    }
    at = prefixes_[at].next[drawn];
  }
  return readings_;
}

}  // namespace rmpl::runtime
