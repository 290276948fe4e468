// Codes of the registry: properties.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array property_table = {
    CodeInfo{Code::no_property, "no property", "A file of properties states at least one.", R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
faults 1;)",
             R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
faults 1;
property "opens" {
  reach valve = opened;
})"},
    CodeInfo{Code::property_without_claim, "property claims nothing",
             "A property makes one claim: `never`, `reach` or `after … within …`, or one on a program.", R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "opens" {
  faults 1;
})",
             R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "opens" {
  reach valve = opened;
  faults 1;
})"},
    CodeInfo{
        Code::property_repeated_part, "property part given twice",
        "A property has a name of its own and makes one claim; a setting is made once, and so is one for the file.",
        R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "opens" {
  reach valve = opened;
  faults 1;
  faults 2;
})",
        R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "opens" {
  reach valve = opened;
  faults 2;
})"},
    CodeInfo{Code::property_not_a_mode, "not a mode", "`from` gives modes of components, each once, to start in.",
             R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "opens" {
  reach valve = opened;
  from valve.flow = no;
})",
             R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "opens" {
  reach valve = opened;
  from valve = closed;
})"},
    CodeInfo{Code::property_period, "period out of range", "Steps happen at multiples of a period longer than 0.",
             R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "opens" {
  reach valve = opened;
  time 0 s;
})",
             R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "opens" {
  reach valve = opened;
  time 0.5 s;
})"},
    CodeInfo{
        Code::property_without_program, "no program",
        "What is claimed of a program is asked of the plant under that program, which is given after the properties.",
        R"($ tcca-check check tap.tcca tap.props
// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// pour.rmpl
Pour() :: { valve = opened }
// tap.props
property "the pouring ends" {
  program terminates;
})",
        R"($ tcca-check check tap.tcca tap.props pour.rmpl
// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// pour.rmpl
Pour() :: { valve = opened }
// tap.props
property "the pouring ends" {
  program terminates;
})"},
    CodeInfo{Code::property_commands_of_program, "commands under a program",
             "Under a program the executive commands; `commands` says what is free without one.",
             R"($ tcca-check check tap.tcca tap.props pour.rmpl
// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// pour.rmpl
Pour() :: { valve = opened }
// tap.props
property "the pouring ends" {
  program terminates;
  commands any;
})",
             R"($ tcca-check check tap.tcca tap.props pour.rmpl
// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// pour.rmpl
Pour() :: { valve = opened }
// tap.props
property "the pouring ends" {
  program terminates;
})"},
};

}  // namespace

std::span<const CodeInfo> property_codes() { return property_table; }

}  // namespace rmpl::grammar
