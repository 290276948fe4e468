// Times one minimum-cardinality diagnosis of every observation of the diagnostic competition of 2009.
//
// usage: dxc09 DXC [CIRCUIT…]     DXC: the folder with models/ and dxc09/
//
// Circuits have weak faults. Set-up is what a circuit costs once: recognising it in the plant, and whatever is kept for
// all its observations. Encoding and solving are timed together, in processor time, the least of a few runs.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/reasoning/diagnose/minimal.hpp"
#include "tests/bench/netlist_plant.hpp"
#include "tests/bench/processor_time.hpp"
#include "tools/rmpl-run/competition.hpp"

using namespace rmpl;

namespace {

namespace fs = std::filesystem;

void measure(const fs::path& dxc, const std::string& name) {
  const automata::Document document = bench::imported(dxc / "models" / (name + ".xml"), compiler::FaultModel::weak);
  const automata::Plant& plant = document.plants.front();
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(dxc / "dxc09" / name)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::vector<automata::Assignment>> observations;
  for (const fs::path& file : files) observations.push_back(tools::competition_observation(file, plant));

  double start = bench::processor_seconds();
  const auto circuit = runtime::circuit_of(plant);
  runtime::CircuitDiagnosis diagnosis(*circuit);
  const auto nothing = [](const runtime::FaultSet&) {};
  diagnosis.solve(observations.front(), runtime::CircuitDiagnosis::Scope::first, nothing);
  const double set_up = bench::processor_seconds() - start;

  constexpr int runs = 3;
  std::vector<double> seconds;
  std::size_t greatest = 0;
  std::size_t calls = 0;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    double least = 1e9;
    for (int run = 0; run < runs; ++run) {
      start = bench::processor_seconds();
      const auto found = diagnosis.solve(observations[i], runtime::CircuitDiagnosis::Scope::first, nothing);
      least = std::min(least, bench::processor_seconds() - start);
      if (!found) {
        std::fprintf(stderr, "%s: no diagnosis\n", files[i].c_str());
        std::exit(EXIT_FAILURE);
      }
      if (run > 0) continue;
      greatest = std::max(greatest, found->cardinality);
      calls += found->checked;
    }
    seconds.push_back(least);
  }
  double sum = 0;
  for (const double s : seconds) sum += s;
  std::sort(seconds.begin(), seconds.end());
  const auto count = static_cast<double>(seconds.size());
  std::printf("| %s | %zu | %zu | %zu | %.1f | %.1f | %.3f | %.3f | %.3f |\n", name.c_str(), circuit->gates.size(),
              seconds.size(), greatest, static_cast<double>(calls) / count, 1e3 * set_up, 1e3 * sum / count,
              1e3 * seconds[seconds.size() / 2], 1e3 * seconds.back());
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("usage: dxc09 DXC [CIRCUIT...]\n", stderr);
    return 2;
  }
  const fs::path dxc = arguments[1];
  std::vector<std::string> circuits(arguments + 2, arguments + count);
  if (circuits.empty()) {
    for (const auto& entry : fs::directory_iterator(dxc / "dxc09")) circuits.push_back(entry.path().filename());
    std::sort(circuits.begin(), circuits.end());
  }
  std::puts(
      "| circuit | gates | observations | most faults | questions | set-up ms | mean ms | median ms | worst ms |");
  std::puts("|---|---|---|---|---|---|---|---|---|");
  for (const std::string& circuit : circuits) measure(dxc, circuit);
}
