// Codes of the registry: names, domains and values.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array name_table = {
    CodeInfo{Code::unknown_name, "unknown name",
             "No declaration has this name. The message says what the place needs: a variable, mode, value, domain, "
             "type, definition or instance. If a declared name is similar, the message suggests it.",
             R"(component Engine {
  output thrust : { zero, full };
  initial off;
  mode off { thurst = zero };
}
plant Lander { engine : Engine; })",
             R"(component Engine {
  output thrust : { zero, full };
  initial off;
  mode off { thrust = zero };
}
plant Lander { engine : Engine; })"},
    CodeInfo{Code::duplicate_name, "name defined twice",
             "Two things of one kind have the same name in the same scope. The note shows the first one.",
             R"(component Engine {
  initial off;
  mode off;
  mode off;
}
plant Lander { engine : Engine; })",
             R"(component Engine {
  initial off;
  mode off;
  mode standby;
}
plant Lander { engine : Engine; })"},
    CodeInfo{Code::value_outside_domain, "value outside the domain",
             "The variable never has this value: it is not in its domain.",
             R"(component Engine {
  output thrust : { zero, full };
  initial idle;
  mode idle { thrust = half };
}
plant Lander { engine : Engine; })",
             R"(component Engine {
  output thrust : { zero, half, full };
  initial idle;
  mode idle { thrust = half };
}
plant Lander { engine : Engine; })"},
    CodeInfo{Code::different_domains, "variables of different domains",
             "Two variables can be equal only where their domains list the same values in the same order.",
             R"(component Relay {
  input coil : { on, off };
  output contact : { off, on };
  initial ok;
  mode ok { contact = coil };
}
plant Board { relay : Relay; })",
             R"(domain Switch = { on, off };
component Relay {
  input coil : Switch;
  output contact : Switch;
  initial ok;
  mode ok { contact = coil };
}
plant Board { relay : Relay; })"},
    CodeInfo{Code::ambiguous_name, "both a value and a variable",
             "The name on the right is a value of the variable on the left, and also a variable of the same domain. "
             "The constraint is ambiguous. Rename the value or the variable.",
             R"(component Gauge {
  input level, low : { low, high };
  initial ok;
  mode ok { level = low };
}
plant Tank { gauge : Gauge; })",
             R"(component Gauge {
  input level, bound : { low, high };
  initial ok;
  mode ok { level = low };
}
plant Tank { gauge : Gauge; })"},
    CodeInfo{
        Code::wrong_kind_of_name, "name of another kind",
        "The name is declared, but it names another kind of thing than this place needs. Examples: a component where "
        "an attribute is expected, the plant where a module is expected, a lone name where a constraint is expected.",
        R"(component Gauge {
  output level : { low, high };
  initial ok;
  mode ok;
}
plant Tank {
  gauge : Gauge;
  observe gauge;
})",
        R"(component Gauge {
  output level : { low, high };
  initial ok;
  mode ok;
}
plant Tank {
  gauge : Gauge;
  observe gauge.level;
})"},
    CodeInfo{
        Code::requirement_without_name, "requirement without a name",
        "A scenario, an expectation or a property names the requirements that it verifies, as the list of requirements "
        "has them: `requirement \"FDIR-12\"`. A name is not empty, and does not begin or end with a blank.",
        R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { zero, full };
  initial closed;
  mode closed { flow = zero };
  mode opened { flow = full };
  fault stuck { flow = zero };
  closed -> opened when cmd = open;
  any nominal -> stuck with 0.001;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "the valve can open" {
  reach valve = opened;
  requirement " ";
})",
        R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { zero, full };
  initial closed;
  mode closed { flow = zero };
  mode opened { flow = full };
  fault stuck { flow = zero };
  closed -> opened when cmd = open;
  any nominal -> stuck with 0.001;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "the valve can open" {
  reach valve = opened;
  requirement "VALVE-1";
})"},
    CodeInfo{Code::requirement_twice, "requirement named twice",
             "A scenario or a property names each requirement once. All expectations of a scenario verify the "
             "requirements that the scenario names, so an expectation does not repeat them.",
             R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { zero, full };
  initial closed;
  mode closed { flow = zero };
  mode opened { flow = full };
  fault stuck { flow = zero };
  closed -> opened when cmd = open;
  any nominal -> stuck with 0.001;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "the valve can open" {
  reach valve = opened;
  requirement "VALVE-1", "VALVE-1";
})",
             R"(// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { zero, full };
  initial closed;
  mode closed { flow = zero };
  mode opened { flow = full };
  fault stuck { flow = zero };
  closed -> opened when cmd = open;
  any nominal -> stuck with 0.001;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
}
// tap.props
property "the valve can open" {
  reach valve = opened;
  requirement "VALVE-1", "VALVE-2";
})"},
};

}  // namespace

std::span<const CodeInfo> name_codes() { return name_table; }

}  // namespace rmpl::grammar
