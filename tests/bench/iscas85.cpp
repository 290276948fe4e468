// Livingstone's experiment on the ISCAS-85 circuits (Williams and Nayak 1996, Table 3).
//
// usage: iscas85 FOLDER [SEED [CIRCUIT…]]     FOLDER holds the .bench netlists; the seed is 1 where none is given
//
// A gate is ok, stuck-at-0, stuck-at-1 or unknown (0.8, 0.099, 0.099, 0.002). Twenty times a circuit one random gate
// sticks at one random value, under a random input vector for which that shows at an output; what the faulty circuit
// shows is diagnosed: the ten leading diagnoses, or those down to 100 times less likely than the best. Times are
// processor time: set-up is reading and compiling the netlist, once a circuit; each diagnosis includes building its
// constraint store.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "runtime/reasoning/diagnose/circuit.hpp"
#include "runtime/reasoning/diagnose/diagnose.hpp"
#include "runtime/reasoning/diagnose/simulate.hpp"
#include "tests/bench/netlist_plant.hpp"
#include "tests/bench/processor_time.hpp"

using namespace rmpl;

namespace {

namespace fs = std::filesystem;

constexpr int experiments = 20;

/// Candidates checked in the paper, a mean over its twenty experiments.
const std::map<std::string, int> published{{"c17", 18},   {"c432", 58},  {"c499", 43},   {"c880", 36},  {"c1355", 52},
                                           {"c1908", 64}, {"c2670", 93}, {"c3540", 140}, {"c5315", 84}, {"c7552", 71}};

/// What one stuck gate shows, by simulating the same netlist without faults of its own.
class FaultyCircuit {
 public:
  explicit FaultyCircuit(const fs::path& netlist)
      : document_(bench::imported(netlist, compiler::FaultModel::weak)),
        plant_(document_.plants.front()),
        circuit_(*runtime::circuit_of(plant_)),
        works_(circuit_.nets),
        sticks_(circuit_.nets) {}

  /// Draws a fault and a vector under which it shows, and gives the readings by name.
  std::vector<std::pair<std::string, bool>> draw(std::mt19937_64& random) {
    constexpr int vectors = 100;  // 64 at a time; a fault that none of them shows is drawn again
    while (true) {
      const std::size_t gate = random() % circuit_.gates.size();
      const runtime::Word stuck = random() % 2 == 0 ? 0 : ~runtime::Word{0};
      for (int i = 0; i < vectors; ++i) {
        for (std::size_t n = 0; n < circuit_.nets; ++n) {
          if (!circuit_.driver[n]) works_[n] = sticks_[n] = random();
        }
        runtime::Word shows = 0;
        for (std::size_t g = 0; g < circuit_.gates.size(); ++g) {
          const runtime::CircuitGate& at = circuit_.gates[g];
          works_[at.output] = evaluate_(at, [&](runtime::NetId net) { return works_[net]; });
          sticks_[at.output] = g == gate ? stuck : evaluate_(at, [&](runtime::NetId net) { return sticks_[net]; });
        }
        for (const automata::VariableId seen : plant_.observables) {
          shows |= works_[circuit_.net_of[seen.index()]] ^ sticks_[circuit_.net_of[seen.index()]];
        }
        if (shows != 0) return readings(static_cast<unsigned>(__builtin_ctzll(shows)));
      }
    }
  }

 private:
  std::vector<std::pair<std::string, bool>> readings(unsigned bit) const {
    std::vector<std::pair<std::string, bool>> all;
    for (const automata::VariableId seen : plant_.observables) {
      all.emplace_back(plant_.variables.name(seen), ((sticks_[circuit_.net_of[seen.index()]] >> bit) & 1) != 0);
    }
    return all;
  }

  automata::Document document_;
  const automata::Plant& plant_;
  runtime::Circuit circuit_;
  std::vector<runtime::Word> works_, sticks_;
  runtime::GateEvaluator evaluate_;
};

void measure(const fs::path& netlist, std::uint64_t seed) {
  const std::string name = netlist.stem();
  double start = bench::processor_seconds();
  const automata::Document document = bench::imported(netlist, compiler::FaultModel::strong);
  const double set_up = bench::processor_seconds() - start;
  const automata::Plant& plant = document.plants.front();
  FaultyCircuit faulty(netlist);
  std::mt19937_64 random(seed);

  double checked = 0;
  double found = 0;
  std::size_t most = 0;
  std::vector<double> seconds;
  for (int i = 0; i < experiments; ++i) {
    automata::Observation observation;
    for (const auto& [variable, value] : faulty.draw(random)) {
      const auto id = plant.variables.find(variable);
      observation.push_back({*id, *plant.variables[*id].find(value ? "true" : "false")});
    }
    std::sort(observation.begin(), observation.end());
    start = bench::processor_seconds();
    const runtime::Diagnoses result = runtime::diagnose(plant, observation, {.k = 10, .ratio = 100});
    seconds.push_back(bench::processor_seconds() - start);
    checked += static_cast<double>(result.checked);
    found += static_cast<double>(result.diagnoses.size());
    most = std::max(most, result.checked);
  }
  std::sort(seconds.begin(), seconds.end());
  const auto in_paper = published.find(name);
  std::printf("| %s | %zu | %s | %.1f | %zu | %.1f | %.0f | %.1f | %.1f |\n", name.c_str(), plant.components.size(),
              in_paper == published.end() ? "" : std::to_string(in_paper->second).c_str(), checked / experiments, most,
              found / experiments, 1e3 * set_up, 1e3 * (seconds[experiments / 2 - 1] + seconds[experiments / 2]) / 2,
              1e3 * seconds.back());
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("usage: iscas85 FOLDER [SEED [CIRCUIT...]]\n", stderr);
    return 2;
  }
  const fs::path folder = arguments[1];
  const std::uint64_t seed = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  std::vector<fs::path> netlists;
  for (int i = 3; i < count; ++i) netlists.push_back(folder / (std::string(arguments[i]) + ".bench"));
  if (netlists.empty()) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".bench") netlists.push_back(entry.path());
    }
    const auto number = [](const fs::path& path) { return std::atoi(path.stem().c_str() + 1); };
    std::sort(netlists.begin(), netlists.end(),
              [&](const fs::path& a, const fs::path& b) { return number(a) < number(b); });
  }
  std::puts(
      "| circuit | gates | checked in the paper | checked | most | diagnoses | set-up ms | median ms | worst ms |");
  std::puts("|---|---|---|---|---|---|---|---|---|");
  for (const fs::path& netlist : netlists) measure(netlist, seed);
}
