// How long a cycle takes: estimation and reconfiguration alone, and whole flights with the cycle that 99 % are under.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/check.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "tests/bench/example.hpp"
#include "tests/bench/processor_time.hpp"

using namespace rmpl;

namespace {

using automata::Ticks;

constexpr Ticks cycle{Ticks::per_second / 2};

void estimation_cycle(benchmark::State& state) {
  const automata::Document document = bench::example({"mars-entry/mars_lander.tcca"});
  automata::PlantStep step(document.plants.front());
  const auto estimator = runtime::make_k_best_estimator(step, {.live_clocks_only = true});
  const automata::ControlAction idle = automata::idle_action(step.plant());
  Ticks now;
  for (auto _ : state) CHECK(estimator->update(idle, {}, now += cycle).consistent);
}
BENCHMARK(estimation_cycle)->Unit(benchmark::kMicrosecond);

bool is_command(const runtime::Reconfiguration& answer) {
  return answer.outcome == runtime::Reconfiguration::Outcome::command;
}

/// The first command of the propulsion example, asked anew each time.
void reconfiguration_anew(benchmark::State& state) {
  const automata::Document document = bench::example({"propulsion/propulsion.tcca"});
  const automata::Plant& plant = document.plants.front();
  const automata::Formula goal = bench::formula("engine = firing", plant);
  const automata::Modes start(plant.components.size());
  for (auto _ : state) {
    state.PauseTiming();
    automata::PlantStep step(plant);
    const auto reconfigurer = runtime::make_reconfigurer(step);
    state.ResumeTiming();
    CHECK(is_command(reconfigurer->next(start, goal)));
  }
}
BENCHMARK(reconfiguration_anew)->Unit(benchmark::kMicrosecond);

/// The same question again, as the executive asks it each cycle.
void reconfiguration_again(benchmark::State& state) {
  const automata::Document document = bench::example({"propulsion/propulsion.tcca"});
  const automata::Plant& plant = document.plants.front();
  const automata::Formula goal = bench::formula("engine = firing", plant);
  const automata::Modes start(plant.components.size());
  automata::PlantStep step(plant);
  const auto reconfigurer = runtime::make_reconfigurer(step);
  for (auto _ : state) CHECK(is_command(reconfigurer->next(start, goal)));
}
BENCHMARK(reconfiguration_again)->Unit(benchmark::kMicrosecond);

/// Takes the processor time between one cycle and the next.
class Stopwatch : public runtime::CycleObserver {
 public:
  void observe(const runtime::CycleRecord&) override {
    const double now = bench::processor_seconds();
    if (last_) seconds_.push_back(now - *last_);
    last_ = now;
  }
  void start_again() { last_.reset(); }
  /// What 99 % of the cycles are under.
  double p99() {
    if (seconds_.empty()) return 0;
    const auto place = seconds_.begin() + static_cast<std::ptrdiff_t>(seconds_.size() * 99 / 100);
    std::nth_element(seconds_.begin(), place, seconds_.end());
    return *place;
  }
  [[nodiscard]] std::size_t cycles() const { return seconds_.size(); }

 private:
  std::optional<double> last_;
  std::vector<double> seconds_;
};

void fly(benchmark::State& state, const char* file) {
  const automata::Document document = bench::example({file});
  Stopwatch stopwatch;
  for (auto _ : state) {
    stopwatch.start_again();
    const auto flown = runtime::run_scenario(document, document.scenarios.front(), {}, {&stopwatch});
    CHECK(flown.verdict() == runtime::Judgement::Verdict::met);
  }
  state.counters["p99_us"] = 1e6 * stopwatch.p99();
  state.counters["cycles"] = static_cast<double>(stopwatch.cycles()) / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(fly, propulsion, "propulsion/burn.scn")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fly, mars_entry, "mars-entry/mars_entry.scn")->Unit(benchmark::kMillisecond);

}  // namespace
