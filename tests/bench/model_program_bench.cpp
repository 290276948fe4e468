// Estimation of model programs: components in parallel, five locations and one reading each; the median of an update.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"
#include "tests/bench/processor_time.hpp"

using namespace rmpl;

namespace {

using automata::LocationId;
using automata::ModelProgram;
using automata::ValueId;

constexpr std::size_t locations_each = 5;
constexpr int updates = 200;

/// A pump that starts, runs and rests; 1 % of the steps out of `runs` lead to `stuck` or `unknown`.
ModelProgram pumps(std::size_t count) {
  ModelProgram program;
  program.name = "Pumps";
  program.locations.emplace_back().composite = true;
  for (std::size_t i = 0; i < count; ++i) {
    const auto flow = program.variables.add({"flow" + std::to_string(i), {"none", "low", "high"}});
    program.observables.push_back(flow);
    const std::size_t first = program.locations.size();
    const auto location = [&](const char* label, int value, std::vector<std::pair<double, std::size_t>> ways) {
      automata::ModelLocation& own = program.locations.emplace_back();
      own.label = label;
      own.parent = LocationId(0);
      own.start = program.locations.size() == first + 1;
      if (value >= 0) own.told = automata::is(flow, ValueId(static_cast<std::size_t>(value)));
      for (const auto& [p, to] : ways) own.functions.push_back({p, {}, {{{}, LocationId(first + to)}}});
    };
    location("starts", 1, {{0.99, 1}, {0.01, 3}});
    location("runs", 2, {{0.79, 1}, {0.2, 2}, {0.005, 3}, {0.005, 4}});
    location("rests", 0, {{0.79, 2}, {0.2, 0}, {0.01, 4}});
    location("stuck", 0, {{1, 3}});
    location("unknown", -1, {{1, 4}});
  }
  return program;
}

/// What a drawn run of the pumps shows.
std::vector<automata::Observation> readings(const ModelProgram& program, std::size_t count) {
  std::mt19937_64 draw(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < count; ++i) at.push_back(1 + i * locations_each);
  std::vector<automata::Observation> result;
  for (int u = 0; u < updates; ++u) {
    automata::Observation& seen = result.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
      double left = unit(draw);
      for (const automata::TransitionFunction& function : program.locations[at[i]].functions) {
        left -= function.probability;
        if (left > 0) continue;
        at[i] = function.arcs.front().target.index();
        break;
      }
      const automata::Formula& told = program.locations[at[i]].told;
      seen.push_back({automata::VariableId(i), told.is_true() ? ValueId(draw() % 3) : told.values.front()});
    }
  }
  return result;
}

void run(benchmark::State& state, const runtime::MarkingOptions& options, bool listed = false) {
  const std::size_t count = static_cast<std::size_t>(state.range(0)) / locations_each;
  const ModelProgram program = pumps(count);
  const auto seen = readings(program, count);
  std::vector<double> seconds;
  for (auto _ : state) {
    const auto estimator = runtime::make_marking_estimator(program, options);
    for (const automata::Observation& observation : seen) {
      const double begin = bench::processor_seconds();
      estimator->update({}, observation);
      if (listed) CHECK(!estimator->belief().empty());
      if (options.window > 0) CHECK(!estimator->history().empty());
      seconds.push_back(bench::processor_seconds() - begin);
    }
    CHECK(!estimator->belief().empty());
  }
  std::nth_element(seconds.begin(), seconds.begin() + std::ssize(seconds) / 2, seconds.end());
  state.counters["median_us"] = 1e6 * seconds[seconds.size() / 2];
}

/// An update with k = 16; the argument is the number of locations.
void model_update(benchmark::State& state) { run(state, {.k = 16}); }
BENCHMARK(model_update)->ArgsProduct({{10, 20, 50, 100, 200, 500, 1000}})->Unit(benchmark::kMillisecond);

/// The same, and the 16 best markings of the product are listed with what they entail.
void model_belief(benchmark::State& state) { run(state, {.k = 16}, true); }
BENCHMARK(model_belief)->ArgsProduct({{10, 20, 50, 100, 200, 500, 1000}})->Unit(benchmark::kMillisecond);

/// The 16 most likely histories of the last 20 updates, at every update.
void model_window(benchmark::State& state) { run(state, {.k = 16, .window = 20}); }
BENCHMARK(model_window)->ArgsProduct({{10, 20, 50, 100, 200}})->Unit(benchmark::kMillisecond);

}  // namespace
