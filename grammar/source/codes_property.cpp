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
    CodeInfo{Code::property_repeated_part, "property part given twice",
             "Each property has a unique name and makes one claim. Each setting appears at most once in a property, "
             "and at most once for the whole file.",
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
    CodeInfo{Code::property_not_a_mode, "not a mode",
             "`from` gives initial modes: components, each at most once, and one of their modes.",
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
    CodeInfo{Code::property_period, "period out of range",
             "Steps happen at multiples of the period, so the period is longer than 0.",
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
        "A claim about a program is checked on the plant under that program. Give the program after the properties.",
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
             "Under a program, the executive chooses the commands. `commands` says which commands are free without a "
             "program.",
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
