// Codes of the registry: lint of properties and scenarios.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array lint_flight_table = {
    CodeInfo{Code::vacuous_property, "property that says nothing",
             "The verdict on the property does not depend on what the plant does. The message gives the reason, which "
             "is one of these:\n\n- No state satisfies the formula.\n- Every state satisfies the formula.\n- The plant "
             "never reaches the trigger of a response.\n- `never` or `reach` asks for a state that needs a fault, and "
             "`faults` permits none.\n\nIf only the constraints of the model exclude the formula of a `never`, the "
             "finding is a note, because such a property checks the constraints.",
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
  faults 1;
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
             "The condition of the rule can never hold, or the rule would take effect after the end of the scenario.",
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
             "The outcome of the expectation does not depend on the flight: no state satisfies its condition, every "
             "state does, or the condition after `after` never holds. If only the constraints of the model exclude the "
             "condition of a `never`, the finding is a note, because such an expectation checks the constraints.",
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
    CodeInfo{
        Code::restarted_wait, "wait that starts anew while it lasts",
        "`whenever c donext A` starts A in every cycle in which c holds, even if A has not ended yet. `always A` "
        "starts A in every cycle. A local clock starts with each call of its definition. So while c holds, the clock "
        "never exceeds one cycle, and a wait for the clock ends only after c has been false for that long. If that is "
        "intended, as for a light that goes off five minutes after the last movement, allow the finding. `repeat when "
        "c donext A` runs A to its end each time, and reads c again only then. If a wait without a local clock is "
        "restarted, the steps before the wait run again in parallel to it, and the finding is a note.",
        R"(Main() :: {
  whenever wheel = hung donext Recover()
}
Recover() :: {
  clock t;
  t = 0;
  when t >= 5 s donext wheel = on
})",
        R"(Main() :: {
  repeat when wheel = hung donext Recover()
}
Recover() :: {
  clock t;
  t = 0;
  when t >= 5 s donext wheel = on
})"},
    CodeInfo{Code::knowledge_out_of_reach, "knowledge condition that never holds",
             "`likely` and `possible` ask how probable a formula is. No state that the plant can reach satisfies this "
             "one, so its probability is 0 whatever is observed. The condition never holds.",
             R"($ rmplc lint main.rmpl tap.tcca
// main.rmpl
Main() :: { when likely(valve = opened & valve.flow = no, 0.9) donext valve = closed }
// tap.tcca
component Valve {
  input cmd : { none, open, close };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  opened -> closed when cmd = close;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
})",
             R"($ rmplc lint main.rmpl tap.tcca
// main.rmpl
Main() :: { when likely(valve = opened & valve.flow = yes, 0.9) donext valve = closed }
// tap.tcca
component Valve {
  input cmd : { none, open, close };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  opened -> closed when cmd = close;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
})"},
    CodeInfo{Code::unanswered_surprise, "surprise without a reaction",
             "The program reacts to surprises, but not to this one. Either the step after the condition is empty, or "
             "the program asks about some components only, although readings of other components may be set aside too. "
             "A reading that is set aside does not influence the estimate.",
             R"(Main() :: {
  whenever surprise donext { }
})",
             R"(Main() :: {
  whenever surprise donext valve = closed
})"},
};

}  // namespace

std::span<const CodeInfo> lint_flight_codes() { return lint_flight_table; }

}  // namespace rmpl::grammar
