// Random numbers of a flight, looked up by step and by component or sensor.
// SPDX-License-Identifier: MIT
#include "runtime/executive/plant/luck.hpp"

#include <algorithm>
#include <iterator>

namespace rmpl::runtime {

std::optional<double> DrawnNumbers::at(std::size_t step, std::size_t who) const {
  if (step >= steps_.size()) return std::nullopt;
  const auto& drawn = steps_[step];
  const auto found = std::find_if(drawn.begin(), drawn.end(), [&](const auto& one) { return one.first == who; });
  if (found == drawn.end()) return std::nullopt;
  return found->second;
}

NumberSource::NumberSource(std::uint64_t seed, std::uint64_t stream, DrawnNumbers* noted, const DrawnNumbers* followed)
    : random_(seed, stream), noted_(noted), followed_(followed), own_seed_(RandomSource(seed, stream).next()) {}

void NumberSource::begin_step() {
  ++steps_;
  own_.clear();
  if (noted_ != nullptr) noted_->begin_step();
}

void NumberSource::begin_again() {
  if (noted_ != nullptr) noted_->begin_again();
}

double NumberSource::number(std::size_t who) {
  if (followed_ == nullptr) {
    const double drawn = random_.uniform();
    if (noted_ != nullptr) noted_->note(who, drawn);
    return drawn;
  }
  auto own = std::find_if(own_.begin(), own_.end(), [&](const auto& one) { return one.first == who; });
  if (own == own_.end()) {
    own_.emplace_back(who, RandomSource(own_seed_ + steps_, who));
    own = std::prev(own_.end());
    if (const auto drawn = followed_->at(steps_ - 1, who)) return *drawn;
  }
  return own->second.uniform();
}

}  // namespace rmpl::runtime
