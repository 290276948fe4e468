// Codes of the registry: lint of plants, what is not commanded, not observed, or not used.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array lint_sensing_table = {
    CodeInfo{Code::uncommanded_component, "component that no command reaches",
             "Transitions of the component wait for their guards, but no control variable has any influence "
             "on them, neither through the interconnections nor through components that commands do move. For "
             "what is only watched that is right; else a command or an interconnection is missing.",
             R"(component Lamp {
  input  power : { zero, nominal };
  output light : { dark, bright };
  initial off;
  mode off { light = dark };
  mode on  { light = bright };
  off -> on  when power = nominal;
  on  -> off when power = zero;
}
component Generator {
  output power : { zero, nominal };
  initial stopped;
  mode stopped { power = zero };
  mode running { power = nominal };
  stopped -> running in [5 s, 9 s];
}
component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant House {
  lamp : Lamp;
  valve : Valve;
  generator : Generator;
  generator.power = lamp.power;
  control valve.cmd default none;
  observe valve.position, lamp.light, generator.power;
})",
             R"(component Lamp {
  input  power : { zero, nominal };
  output light : { dark, bright };
  initial off;
  mode off { light = dark };
  mode on  { light = bright };
  off -> on  when power = nominal;
  on  -> off when power = zero;
}
component Generator {
  input  cmd   : { none, start };
  output power : { zero, nominal };
  initial stopped;
  mode stopped { power = zero };
  mode running { power = nominal };
  stopped -> running when cmd = start;
}
plant House {
  lamp : Lamp;
  generator : Generator;
  generator.power = lamp.power;
  control generator.cmd default none;
  observe lamp.light, generator.power;
})"},
    CodeInfo{Code::unobserved_plant, "plant without observations",
             "The plant has faults and no `observe`: no fault ever shows, and the estimate is what the model predicts. "
             "For a plant that is only verified that is right.",
             R"(component Tap {
  output flow : { low, high };
  initial open;
  mode  open  { flow = high };
  fault stuck { flow = low };
  open -> stuck with 1e-6;
}
plant Sink {
  tap : Tap;
})",
             R"(component Tap {
  output flow : { low, high };
  initial open;
  mode  open  { flow = high };
  fault stuck { flow = low };
  open -> stuck with 1e-6;
}
plant Sink {
  tap : Tap;
  observe tap.flow;
})"},
    CodeInfo{Code::undetectable_fault, "fault that no observation tells from nominal",
             "In the fault mode all that is observed reads as in every nominal mode of the component, "
             "whatever the other components do, and nothing that another component waits for differs. No "
             "diagnosis will ever have a reason to name it.",
             R"(component Tank {
  output level, flow : { low, high };
  initial full;
  mode  full    { level = high };
  fault empty   { level = low };
  full -> empty   with rate 1e-6 /h;
}
plant Supply {
  tank : Tank;
  observe tank.flow;
})",
             R"(component Tank {
  output level, flow : { low, high };
  initial full;
  mode  full    { level = high };
  fault empty   { level = low };
  full -> empty   with rate 1e-6 /h;
}
plant Supply {
  tank : Tank;
  observe tank.level, tank.flow;
})"},
    CodeInfo{Code::indistinguishable_faults, "faults that nothing tells from each other",
             "In both fault modes all that is observed reads the same, whatever the other components do; "
             "nothing that another component waits for differs, and the same transitions lead out of them. A "
             "diagnosis can weigh them by their probabilities only. Observe what differs, or make one fault "
             "of them.",
             R"(component Tank {
  output level, flow : { low, high };
  initial full;
  mode  full    { level = high & flow = high };
  fault empty   { level = low & flow = low };
  fault blocked { level = high & flow = low };
  full -> empty   with rate 1e-6 /h;
  full -> blocked with rate 1e-6 /h;
}
plant Supply {
  tank : Tank;
  observe tank.flow;
})",
             R"(component Tank {
  output level, flow : { low, high };
  initial full;
  mode  full    { level = high & flow = high };
  fault empty   { level = low & flow = low };
  fault blocked { level = high & flow = low };
  full -> empty   with rate 1e-6 /h;
  full -> blocked with rate 1e-6 /h;
}
plant Supply {
  tank : Tank;
  observe tank.level, tank.flow;
})"},
    CodeInfo{Code::indistinguishable_modes, "nominal modes that no sensor tells apart",
             "All that is observed reads the same in these nominal modes, wherever the other components are in "
             "the same modes. Which of them the component is in is known by dead reckoning only: a transition "
             "that fails to happen is not seen. This is told also where dead reckoning cannot fail in the model, "
             "as below, where no fault keeps the valve from moving: a sensor, or that fault, is what is missing. "
             "Nothing is told of modes that are never entered, nor of two that no modes of the other components "
             "go with both: what is seen of those may tell these apart.",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.cmd;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::unconnected_input, "input that is neither connected nor commanded",
             "No interconnection leads from a component's output, a mode or a control variable to this input, "
             "and it is not observed either: its value is open for ever, and a guard that reads it does not "
             "follow from anything. Where it gets its value from an input of the module that it is in, the "
             "outermost of these is told of: that one is to be connected.",
             R"(component Lamp {
  input  power : { zero, nominal };
  output light : { dark, bright };
  initial off;
  mode off { light = dark };
  mode on  { light = bright };
  off -> on  when power = nominal;
  on  -> off when power = zero;
}
component Generator {
  input  cmd   : { none, start };
  output power : { zero, nominal };
  initial stopped;
  mode stopped { power = zero };
  mode running { power = nominal };
  stopped -> running when cmd = start;
}
plant House {
  lamp : Lamp;
  generator : Generator;
  control generator.cmd default none;
  observe lamp.light, generator.power;
})",
             R"(component Lamp {
  input  power : { zero, nominal };
  output light : { dark, bright };
  initial off;
  mode off { light = dark };
  mode on  { light = bright };
  off -> on  when power = nominal;
  on  -> off when power = zero;
}
component Generator {
  input  cmd   : { none, start };
  output power : { zero, nominal };
  initial stopped;
  mode stopped { power = zero };
  mode running { power = nominal };
  stopped -> running when cmd = start;
}
plant House {
  lamp : Lamp;
  generator : Generator;
  generator.power = lamp.power;
  control generator.cmd default none;
  observe lamp.light, generator.power;
})"},
    CodeInfo{Code::unread_command, "command that nothing reads",
             "The value of the control variable has the same effect as its idle value: no guard and no "
             "observation differs between them, in whatever modes the components are. A transition that reads "
             "it is missing, or the value is one too many. Where another attribute with the same domain is "
             "asked for the value, it is no more than a note.",
             R"(component Valve {
  input  cmd      : { none, open, close, vent };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::unused_attribute, "attribute that nothing mentions",
             "No mode constraint, guard or interconnection mentions the attribute, and it is neither "
             "commanded nor observed; or it is an input of a component that none of its own guards and mode "
             "constraints reads; or it is a variable of a model program that no constraint and no condition speaks of.",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  output current : { zero, nominal };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{
        Code::unexplained_reading, "reading that no mode explains",
        "The sensor can read a value that no state of the plant has, in the modes that it comes to, faults among them. "
        "Sensors fail: such a reading contradicts every estimate, and what is not explained is set aside. A fault "
        "without "
        "a constraint explains every reading. Where the value is none that the sensor has, the domain is too wide.",
        R"(component Thermometer {
  output reading : { low, high };
  initial working;
  mode working { reading = low };
}
plant Tank {
  thermometer : Thermometer;
  observe thermometer.reading;
})",
        R"(component Thermometer {
  output reading : { low, high };
  initial working;
  mode  working { reading = low };
  fault unknown;
  working -> unknown with rate 1e-6 /h;
}
plant Tank {
  thermometer : Thermometer;
  observe thermometer.reading;
})"},
    CodeInfo{
        Code::fault_blocks_goal, "fault that blocks goals of others",
        "Once the fault has happened, nothing leads to goals of other components any more, whatever is commanded and "
        "whatever modes the others are in; where such a goal holds it may go on. The modes that can follow the fault "
        "by nominal transitions count. Proven by what implies the guards of the transitions that lead to the goal: a "
        "fault mode without a constraint implies nothing. Plants of more than 32 components are not asked. A program "
        "that is to survive the fault watches for it.",
        R"(// main.rmpl
P() :: {
  switch = closed;
  lamp = lit
}
// house.tcca
component Switch {
  input  cmd : { none, close, open };
  output out : { off, on };
  initial opened;
  mode  opened { out = off };
  mode  closed { out = on };
  fault broken { out = off };
  opened -> closed when cmd = close;
  closed -> opened when cmd = open;
  opened -> broken with rate 1e-6 /h;
}
component Lamp {
  input  power : { off, on };
  input  cmd   : { none, light, dim };
  output shine : { no, yes };
  initial dark;
  mode dark { shine = no };
  mode lit  { shine = yes };
  dark -> lit when cmd = light & power = on;
  lit -> dark when cmd = dim;
}
plant House {
  switch : Switch;
  lamp   : Lamp;
  lamp.power = switch.out;
  control switch.cmd default none;
  control lamp.cmd default none;
  observe switch.out, lamp.shine;
})",
        R"(// main.rmpl
P() :: {
  switch = closed;
  lamp = lit
}
// house.tcca
component Switch {
  input  cmd : { none, close, open };
  output out : { off, on };
  initial opened;
  mode  opened { out = off };
  mode  closed { out = on };
  fault broken { out = off };
  opened -> closed when cmd = close;
  closed -> opened when cmd = open;
  broken -> opened when cmd = open;
  opened -> broken with rate 1e-6 /h;
}
component Lamp {
  input  power : { off, on };
  input  cmd   : { none, light, dim };
  output shine : { no, yes };
  initial dark;
  mode dark { shine = no };
  mode lit  { shine = yes };
  dark -> lit when cmd = light & power = on;
  lit -> dark when cmd = dim;
}
plant House {
  switch : Switch;
  lamp   : Lamp;
  lamp.power = switch.out;
  control switch.cmd default none;
  control lamp.cmd default none;
  observe switch.out, lamp.shine;
})"},
};

}  // namespace

std::span<const CodeInfo> lint_sensing_codes() { return lint_sensing_table; }

}  // namespace rmpl::grammar
