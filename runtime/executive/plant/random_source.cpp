// SplitMix64.
// SPDX-License-Identifier: MIT
#include "runtime/executive/plant/random_source.hpp"

#include "base/check.hpp"

namespace rmpl::runtime {
namespace {

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

constexpr std::uint64_t golden_gamma = 0x9e3779b97f4a7c15U;

}  // namespace

RandomSource::RandomSource(std::uint64_t seed, std::uint64_t stream)
    : state_(mixed(seed + golden_gamma) ^ mixed(stream)) {}

std::uint64_t RandomSource::next() {
  state_ += golden_gamma;
  return mixed(state_);
}

double RandomSource::uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

std::size_t RandomSource::below(std::size_t count) { return position_below(count, uniform()); }

std::size_t position_below(std::size_t count, double at) {
  CHECK(count > 0);
  // The product is below count: `at` is at most 1 - 2^-53, and count is far below 2^53.
  return static_cast<std::size_t>(at * static_cast<double>(count));
}

}  // namespace rmpl::runtime
