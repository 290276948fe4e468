// The Mars entry program of thesis Fig. 3-2, and a plant for it, built by hand: the tests need no compiler.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "automata/scenario.hpp"

namespace rmpl::runtime::mars_entry {

using namespace rmpl::automata;

/// Adds primitive and composite locations; positions are the thesis's numbers.
class ProgramBuilder {
 public:
  explicit ProgramBuilder(Program& program) : program_(program) {}

  Assignment assignment(const std::string& variable, const std::string& value) {
    const auto known = program_.variables.find(variable);
    const VariableId id = known ? *known : program_.variables.add({variable, {}});
    return {id, program_.variables.add_value(id, value)};
  }
  Formula says(const std::string& variable, const std::string& value) {
    const Assignment a = assignment(variable, value);
    return is(a.variable, a.value);
  }
  Location& location(std::size_t number, std::size_t parent, bool start) {
    if (program_.locations.size() < number) program_.locations.resize(number);
    Location& made = program_.locations[number - 1];
    if (parent > 0) made.parent = LocationId(parent - 1);
    made.start = start;
    made.origin = {"entry.rmpl", static_cast<std::uint32_t>(number), 1};
    return made;
  }
  void arc(std::size_t from, std::size_t to, Condition guard = {}) {
    program_.locations[from - 1].arcs.push_back({std::move(guard), LocationId(to - 1)});
  }
  /// `when c donext`: waits at `at`, goes on to `to`.
  void wait(std::size_t at, std::size_t to, const Formula& condition) {
    arc(at, at, {false, condition});
    arc(at, to, {true, condition});
  }

 private:
  Program& program_;
};

/// The twelve locations of Fig. 3-4 with the numbers that 5.4 uses.
inline Program program() {
  Program program;
  program.name = "EntrySequence";
  program.clocks = {"t1", "t2"};
  ProgramBuilder build(program);
  program.locations.resize(12);
  build.location(1, 0, true).composite = true;
  build.location(2, 1, true).goal = {build.assignment("engine", "standby")};
  build.location(3, 1, false).clock_start = ClockId(0);
  build.location(4, 1, false);
  build.location(5, 1, false).goal = {build.assignment("nav", "inertial")};
  build.location(6, 1, false).clock_start = ClockId(1);
  build.location(7, 1, false);
  build.location(8, 1, false).composite = true;
  program.locations[7].maintenance = {false, build.says("entry", "initiated")};
  build.location(9, 8, true);
  build.location(10, 8, true).goal = {build.assignment("att", "entry-orient")};
  build.location(11, 8, true);
  build.location(12, 8, false).goal = {build.assignment("lander", "separated")};
  build.arc(2, 3);
  build.arc(3, 4);
  build.wait(4, 5, clock_bound(ClockId(0), Comparison::at_least, Ticks::of_seconds(16200)));
  build.arc(5, 6);
  build.arc(6, 7);
  build.wait(7, 8, clock_bound(ClockId(1), Comparison::at_least, Ticks::of_seconds(240)));
  build.arc(9, 9);
  build.arc(9, 10);
  build.wait(11, 12, build.says("att", "entry-orient"));
  return program;
}

}  // namespace rmpl::runtime::mars_entry
