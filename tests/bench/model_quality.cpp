// How often an estimator knows what happened: random runs of optical navigation in which something fails, told by late
// symptoms. Prints the table of docs/benchmarks.md.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "automata/step/marking_step.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"
#include "tests/bench/example.hpp"

using namespace rmpl;

namespace {

using automata::Marking;
using automata::MarkingStep;
using automata::ModelProgram;
using runtime::MarkingOptions;

constexpr std::size_t steps = 16;

struct Run {
  std::vector<Marking> markings;                    ///< from the start
  std::vector<automata::Observation> observations;  ///< after each step: what is entailed of what is observed
};

bool failed(MarkingStep& step, MarkingStep::Number marking) {
  const automata::Variables& variables = step.program().variables;
  for (const automata::Assignment& a : step.values(marking)) {
    const std::string& value = variables.value(a);
    if (value == "stuck" || value == "dead" || value == "corrupted") return true;
  }
  return false;
}

std::size_t drawn(const std::vector<MarkingStep::Way>& ways, double at) {
  std::size_t way = 0;
  for (double left = at - ways[0].probability; left > 0 && way + 1 < ways.size(); left -= ways[way].probability) ++way;
  return way;
}

/// A run in which something fails.
Run draw(MarkingStep& step, std::mt19937_64& engine) {
  std::uniform_real_distribution<double> unit(0, 1);
  const std::vector<automata::VariableId>& seen = step.program().observables;
  while (true) {
    Run run;
    const auto starts = *step.initial();
    auto at = starts[drawn(starts, unit(engine))].target;
    run.markings.push_back(step.whole(at));
    for (std::size_t i = 0; i < steps; ++i) {
      const auto& ways = *step.ways(at);
      at = ways[drawn(ways, unit(engine))].target;
      run.markings.push_back(step.whole(at));
      auto& observation = run.observations.emplace_back();
      for (const automata::Assignment& a : step.values(at)) {
        if (std::find(seen.begin(), seen.end(), a.variable) != seen.end()) observation.push_back(a);
      }
    }
    if (failed(step, at)) return run;
  }
}

struct Score {
  std::size_t end = 0, history = 0;
};

/// Whether the last marking, and all of the history, came first.
void judge(const ModelProgram& program, const MarkingOptions& options, const Run& run, Score& score) {
  const auto estimator = runtime::make_marking_estimator(program, options);
  std::vector<Marking> filtered{estimator->belief().front().marking};
  for (const automata::Observation& observation : run.observations) {
    estimator->update({}, observation);
    filtered.push_back(estimator->belief().front().marking);
  }
  if (filtered.back() == run.markings.back()) ++score.end;
  if (options.window == 0) {
    if (filtered == run.markings) ++score.history;
    return;
  }
  // What is older than the window stays as it was thought when it left the window: here, as the filter had it.
  const std::vector<Marking> best = estimator->history().front().markings;
  std::copy(best.begin(), best.end(), filtered.end() - std::ssize(best));
  if (filtered == run.markings) ++score.history;
}

}  // namespace

/// The number of runs is the argument; 1000 without.
int main(int count, char** arguments) {
  const std::size_t runs = count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 1000;
  const automata::Document document = bench::example({"optical-navigation/optical_navigation.rmpl"});
  const ModelProgram& program = document.models.front();
  MarkingStep step(program);
  std::mt19937_64 engine(2001);
  std::vector<Run> all;
  for (std::size_t i = 0; i < runs; ++i) all.push_back(draw(step, engine));
  using Kind = MarkingOptions::Kind;
  const std::vector<std::pair<const char*, MarkingOptions>> estimators{
      {"beam of 1", {.kind = Kind::beam, .k = 1}},
      {"beam of 4", {.kind = Kind::beam, .k = 4}},
      {"beam of 16", {.kind = Kind::beam, .k = 16}},
      {"k-best, 16", {.kind = Kind::k_best, .k = 16}},
      {"exact", {.kind = Kind::exact, .listed = 16}},
      {"k-best, 16, window 10", {.kind = Kind::k_best, .window = 10}},
      {"k-best, 16, window 20", {.kind = Kind::k_best, .window = 20}}};
  std::printf("| estimator | the last marking is right | the history is right |\n|---|---|---|\n");
  for (const auto& [name, options] : estimators) {
    Score score;
    for (const Run& run : all) judge(program, options, run, score);
    const double percent = 100.0 / static_cast<double>(runs);
    std::printf("| %s | %.1f %% | %.1f %% |\n", name, percent * static_cast<double>(score.end),
                percent * static_cast<double>(score.history));
    std::fflush(stdout);
  }
  return EXIT_SUCCESS;
}
