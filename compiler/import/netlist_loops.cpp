// Loops of gates. Gates that read nothing but what is settled are settled (Kahn 1962); where some are left, a walk
// against the wires ends in a loop, and a breadth-first search from its first gate finds a shortest one.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "base/check.hpp"
#include "base/enumerated.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/import/netlist.hpp"

namespace rmpl::compiler {
namespace {

constexpr std::size_t nobody = static_cast<std::size_t>(-1);

/// The gates that are not settled yet, and who reads whom among them.
class Unsettled {
 public:
  explicit Unsettled(const Netlist& netlist)
      : sources_(netlist.gates.size()), readers_(netlist.gates.size()), open_(netlist.gates.size()) {
    std::vector<std::size_t> driver(netlist.nets, nobody);
    for (std::size_t g = 0; g < netlist.gates.size(); ++g) driver[netlist.gates[g].output] = g;
    for (std::size_t g = 0; g < netlist.gates.size(); ++g) {
      for (const Net input : netlist.gates[g].inputs) {
        if (driver[input] == nobody) continue;
        sources_[g].push_back(driver[input]);
        readers_[driver[input]].push_back(g);
        ++open_[g];
      }
    }
    std::vector<std::size_t> ready;
    for (std::size_t g = 0; g < open_.size(); ++g) {
      if (open_[g] == 0) ready.push_back(g);
    }
    settle(std::move(ready));
  }

  /// A loop of gates, each reading the next and the last the first; empty where there is none. Its gates count as
  /// settled from then on, so that all loops that are found have no gate in common. O(gates and wires).
  std::vector<std::size_t> take_loop() {
    const auto left = std::find_if(open_.begin(), open_.end(), [](std::size_t open) { return open > 0; });
    if (left == open_.end()) return {};
    const std::vector<std::size_t> loop = shortest_through(first_of_some(std::size_t(left - open_.begin())));
    for (const std::size_t g : loop) open_[g] = 0;
    settle(loop);
    return loop;
  }

 private:
  void settle(std::vector<std::size_t> ready) {
    while (!ready.empty()) {
      const std::size_t g = ready.back();
      ready.pop_back();
      for (const std::size_t reader : readers_[g]) {
        if (open_[reader] > 0 && --open_[reader] == 0) ready.push_back(reader);
      }
    }
  }

  /// The first gate, in the order of the file, of the loop that a walk from `at` runs into.
  [[nodiscard]] std::size_t first_of_some(std::size_t at) const {
    std::vector<bool> seen(open_.size());
    for (; !seen[at]; at = source(at)) seen[at] = true;
    std::size_t first = at;
    for (std::size_t g = source(at); g != at; g = source(g)) first = std::min(first, g);
    return first;
  }

  /// A gate that an unsettled one waits for.
  [[nodiscard]] std::size_t source(std::size_t gate) const {
    const auto& all = sources_[gate];
    const auto found = std::find_if(all.begin(), all.end(), [&](std::size_t g) { return open_[g] > 0; });
    CHECK(found != all.end());
    return *found;
  }

  [[nodiscard]] std::vector<std::size_t> shortest_through(std::size_t first) const {
    std::vector<std::size_t> read_by(open_.size(), nobody);
    std::vector<std::size_t> queue{first};
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const std::size_t g : sources_[queue[i]]) {
        if (open_[g] == 0 || read_by[g] != nobody) continue;
        read_by[g] = queue[i];
        queue.push_back(g);
      }
    }
    std::vector<std::size_t> loop;
    for (std::size_t g = read_by[first]; g != first; g = read_by[g]) loop.push_back(g);
    loop.push_back(first);
    std::reverse(loop.begin(), loop.end());
    return loop;
  }

  std::vector<std::vector<std::size_t>> sources_, readers_;  ///< of each gate, once a wire
  std::vector<std::size_t> open_;  ///< of each gate, the wires from unsettled ones; 0: it is settled
};

}  // namespace

void report_loops(const Netlist& netlist, const std::vector<grammar::Span>& places, NetlistErrors& errors) {
  constexpr std::size_t shown = 8;
  const auto name = [&](std::size_t gate) { return backquoted(netlist.gates[gate].name); };
  Unsettled unsettled(netlist);
  for (std::vector<std::size_t> loop = unsettled.take_loop(); !loop.empty() && !errors.too_many();
       loop = unsettled.take_loop()) {
    std::string text = "a combinational loop: " + name(loop.front()) + " reads ";
    if (loop.size() == 1) text += "its own output";
    for (std::size_t i = 1; i < loop.size() && i < shown; ++i) text += name(loop[i]) + ", which reads ";
    if (loop.size() > shown) text += std::to_string(loop.size() - shown) + " more, the last of which reads ";
    if (loop.size() > 1) text += name(loop.front());
    auto* error = errors.report(grammar::Code::netlist_loop, places[loop.front()], text);
    for (std::size_t i = 1; error != nullptr && i < loop.size() && i < shown; ++i) {
      error->notes.push_back({places[loop[i]], name(loop[i]) + " is driven here"});
    }
  }
}

}  // namespace rmpl::compiler
