// Codes of the registry: lint of properties and scenarios.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{
        Code::vacuous_property, "property that says nothing",
        "The property holds or fails whatever the plant does: no state satisfies its formula, every state does, or "
        "what it waits for never comes. Of `never`, what only the constraints exclude is a note: it checks these.",
        R"($ rmplc lint plant.tcca plant.props
// plant.props
property "p" {
  reach tap.flow = low | tap.flow = high;
}
// plant.tcca
component Tap {
  output flow : { low, high };
  initial closed;
  mode closed { flow = low };
  fault broken;
  any -> broken with 0.1;
}
plant Sink {
  tap : Tap;
})",
        R"($ rmplc lint plant.tcca plant.props
// plant.props
property "p" {
  reach tap.flow = high;
}
// plant.tcca
component Tap {
  output flow : { low, high };
  initial closed;
  mode closed { flow = low };
  fault broken;
  any -> broken with 0.1;
}
plant Sink {
  tap : Tap;
})"},
    CodeInfo{Code::rule_never_fires, "rule that never fires",
             "What the rule waits for cannot be, or what it dictates would only come after the end of the scenario.",
             R"(// test.scn
scenario "s" {
  program "main.rmpl";
  plant "plant.tcca" rules only;
  cycle 1 s;
  duration 10 s;
  when command tap.cmd = open after 20 s observe tap.flow = high;
}
// main.rmpl
P() :: {
  tap = open
}
// plant.tcca
component Tap {
  input cmd : { none, open };
  output flow : { low, high };
  initial closed;
  mode closed { flow = low };
  mode open { flow = high };
  closed -> open when cmd = open;
}
plant Sink {
  tap : Tap;
  control tap.cmd default none;
  observe tap.flow;
})",
             R"(// test.scn
scenario "s" {
  program "main.rmpl";
  plant "plant.tcca" rules only;
  cycle 1 s;
  duration 10 s;
  when command tap.cmd = open after 2 s observe tap.flow = high;
}
// main.rmpl
P() :: {
  tap = open
}
// plant.tcca
component Tap {
  input cmd : { none, open };
  output flow : { low, high };
  initial closed;
  mode closed { flow = low };
  mode open { flow = high };
  closed -> open when cmd = open;
}
plant Sink {
  tap : Tap;
  control tap.cmd default none;
  observe tap.flow;
})"},
    CodeInfo{Code::vacuous_expectation, "expectation that says nothing",
             "The expectation is met or fails whatever is flown: no state satisfies its condition, every state does, "
             "or what it "
             "comes after can never be. Of `never`, what only the constraints exclude is a note: it checks these.",
             R"(// test.scn
scenario "s" {
  program "main.rmpl";
  plant "plant.tcca";
  duration 10 s;
  expect never tap = stuck & tap.flow = high & tap = open;
}
// main.rmpl
P() :: {
  tap = open
}
// plant.tcca
component Tap {
  input cmd : { none, open };
  output flow : { low, high };
  initial closed;
  mode closed { flow = low };
  mode open { flow = high };
  fault stuck { flow = low };
  closed -> open when cmd = open;
  open -> stuck with 1e-6;
}
plant Sink {
  tap : Tap;
  control tap.cmd default none;
  observe tap.flow;
})",
             R"(// test.scn
scenario "s" {
  program "main.rmpl";
  plant "plant.tcca";
  duration 10 s;
  expect never tap = stuck;
}
// main.rmpl
P() :: {
  tap = open
}
// plant.tcca
component Tap {
  input cmd : { none, open };
  output flow : { low, high };
  initial closed;
  mode closed { flow = low };
  mode open { flow = high };
  fault stuck { flow = low };
  closed -> open when cmd = open;
  open -> stuck with 1e-6;
}
plant Sink {
  tap : Tap;
  control tap.cmd default none;
  observe tap.flow;
})"},
};

}  // namespace

std::span<const CodeInfo> lint_flight_codes() { return table; }

}  // namespace rmpl::grammar
