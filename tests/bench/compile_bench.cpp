// How long compilation takes.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "base/check.hpp"
#include "tests/bench/example.hpp"

using namespace rmpl;

namespace {

void compile_mars_entry(benchmark::State& state) {
  const auto paths = bench::example_paths({"mars-entry/mars_entry.rmpl", "mars-entry/mars_lander.tcca"});
  for (auto _ : state) CHECK(compiler::compile(paths).ok());
}
BENCHMARK(compile_mars_entry)->Unit(benchmark::kMillisecond);

void compile_mars_edl(benchmark::State& state) {
  const auto paths = bench::example_paths({"mars-edl/mars_edl.rmpl", "mars-edl/edl_lander.tcca"});
  for (auto _ : state) CHECK(compiler::compile(paths).ok());
}
BENCHMARK(compile_mars_edl)->Unit(benchmark::kMillisecond);

}  // namespace
