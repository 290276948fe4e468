// Timed automata for TChecker, in its text format.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "verifier/export/write.hpp"

namespace rmpl::verifier {

namespace {

/// TChecker's constants are 32-bit integers; twice as much is computed with.
constexpr Units greatest = (Units{1} << 30) - 1;

std::string constant(Units units) {
  if (units <= greatest) return std::to_string(units);
  throw base::InputError("tchecker: a time bound of " + std::to_string(units) +
                         " units is beyond its integers; expected coarser or shorter bounds");
}

std::string clock(std::size_t number) { return "x" + std::to_string(number); }

/// Parts between a separator; nothing where there are none.
class Joined {
 public:
  explicit Joined(std::string separator) : separator_(std::move(separator)) {}
  void add(const std::string& part) { text_ += (text_.empty() ? "" : separator_) + part; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string separator_;
  std::string text_;
};

void add_bounds(Joined& conditions, const std::vector<ClockRange>& ranges) {
  for (const auto& [number, range] : ranges) {
    if (range.lower > 0) conditions.add(clock(number) + ">=" + constant(range.lower));
    if (range.upper != unbounded) conditions.add(clock(number) + "<=" + constant(range.upper));
  }
}

std::string attributes_of(const Location& location, bool initial) {
  Joined attributes(" : ");
  if (initial) attributes.add("initial:");
  if (location.urgent) attributes.add("urgent:");
  if (location.target) attributes.add("labels:target");
  Joined invariant("&&");
  add_bounds(invariant, location.invariant);
  if (!invariant.text().empty()) attributes.add("invariant:" + invariant.text());
  return attributes.text();
}

std::string attributes_of(const Edge& edge, unsigned faults) {
  Joined attributes(" : ");
  Joined provided("&&");
  add_bounds(provided, edge.guard);
  if (edge.faults > 0) provided.add("faults<=" + std::to_string(faults - edge.faults));
  if (!provided.text().empty()) attributes.add("provided:" + provided.text());
  Joined effect(";");
  for (const std::size_t reset : edge.resets) effect.add(clock(reset) + "=0");
  if (edge.faults > 0) effect.add("faults=faults+" + std::to_string(edge.faults));
  if (!effect.text().empty()) attributes.add("do:" + effect.text());
  return attributes.text();
}

}  // namespace

void write_tchecker(std::ostream& out, const automata::Plant& plant, const TimedAutomaton& automaton) {
  out << "# " << plant.name << ": is a location labelled `target` reachable?\n"
      << "# 1 unit of time is " << automata::format_seconds(automaton.time.unit()) << " s\n";
  for (std::size_t c = 0; c < automaton.clocks.size(); ++c) {
    out << "# " << clock(c) << ": time since " << plant[automaton.clocks[c]].name << " entered its mode\n";
  }
  out << "system:plant\n\nevent:tau\n\nprocess:P\n";
  for (std::size_t c = 0; c < automaton.clocks.size(); ++c) out << "clock:1:" << clock(c) << '\n';
  if (automaton.faults > 0) out << "int:1:0:" << automaton.faults << ":0:faults\n";
  for (std::size_t l = 0; l < automaton.locations.size(); ++l) {
    const auto& initial = automaton.initial;
    out << "# " << describe(plant, automaton.locations[l].modes) << "\nlocation:P:l" << l << '{'
        << attributes_of(automaton.locations[l], std::count(initial.begin(), initial.end(), l) > 0) << "}\n";
  }
  if (automaton.locations.empty()) out << "# no initial state is possible\nlocation:P:nowhere{initial:}\n";
  const auto is_target = [](const Location& location) { return location.target; };
  if (std::none_of(automaton.locations.begin(), automaton.locations.end(), is_target)) {
    out << "# no location is a target: one without edges makes the label known\nlocation:P:none{labels:target}\n";
  }
  for (const Edge& edge : automaton.edges) {
    out << "edge:P:l" << edge.from << ":l" << edge.to << ":tau{" << attributes_of(edge, automaton.faults) << "}\n";
  }
}

}  // namespace rmpl::verifier
