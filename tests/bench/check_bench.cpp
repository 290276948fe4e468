// How long properties of the examples take to check, with no, one and two faults.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "base/check.hpp"
#include "tests/bench/example.hpp"
#include "verifier/check/check.hpp"

using namespace rmpl;

namespace {

void check(benchmark::State& state, const char* file, const char* target, std::optional<automata::Ticks> period) {
  const automata::Document document = bench::example({file});
  const automata::Plant& plant = document.plants.front();
  const verifier::Property property = verifier::Reachability{.target = bench::formula(target, plant), .window = {}};
  verifier::CheckOptions options;
  options.period = period;
  options.faults = static_cast<unsigned>(state.range(0));
  std::size_t states = 0;
  for (auto _ : state) {
    verifier::Slices slices(plant);
    const verifier::Answer answer = verifier::check(slices, property, options, {});
    CHECK(answer.verdict == verifier::Verdict::holds && answer.witness);
    states = answer.progress.states;
  }
  state.counters["states"] = static_cast<double>(states);
}

constexpr std::optional<automata::Ticks> dense;
constexpr std::optional<automata::Ticks> half_second = automata::Ticks{automata::Ticks::per_second / 2};
constexpr const char* propulsion = "propulsion/propulsion.tcca";
constexpr const char* lander = "mars-entry/mars_lander.tcca";
BENCHMARK_CAPTURE(check, firing_dense, propulsion, "engine = firing", dense)
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check, firing_sampled, propulsion, "engine = firing", half_second)
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check, separated_dense, lander, "lander = separated", dense)
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check, standby_sampled, lander, "engine = standby", half_second)
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);

}  // namespace
