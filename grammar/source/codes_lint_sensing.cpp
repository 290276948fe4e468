// Codes of the registry: lint of plants, what is not commanded, not observed, or not used.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array lint_sensing_table = {
    CodeInfo{Code::uncommanded_component, "component that no command reaches",
             "Transitions of the component wait for their guards, but no control variable has any influence on them, "
             "neither through the interconnections nor through components that commands do move. This is right for a "
             "component that is only observed. Otherwise a command or an interconnection is missing.",
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
             "The plant has faults but no `observe`. No fault can be noticed, and the estimate only follows the "
             "predictions of the model. This is right for a plant that is only verified.",
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
             "In the fault mode, every observation has the same value as in each nominal mode of the component, "
             "whatever the other components do, and the guards of the other components do not change either. So no "
             "reading can ever make a diagnosis name this fault.",
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
    CodeInfo{
        Code::indistinguishable_faults, "faults that nothing tells from each other",
        "In both fault modes every observation has the same value, whatever the other components do. The guards of the "
        "other components do not differ, and the same transitions leave both modes. A diagnosis can only rank the two "
        "faults by their prior probabilities. Observe an attribute that differs, or merge the faults.",
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
             "Every observation has the same value in these nominal modes while the other components keep their modes. "
             "The estimate knows the mode by dead reckoning only, because no sensor shows that a transition failed to "
             "happen. Lint also reports this if dead reckoning cannot fail in the model, as below, where no fault "
             "keeps the valve from moving. Then a sensor is missing, or that fault.\n\nLint skips modes that are never "
             "entered. It also skips two modes if no modes of the other components go with both of them, because "
             "observations of those components may distinguish the two.",
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
    CodeInfo{
        Code::unconnected_input, "input that is neither connected nor commanded",
        "No output, mode or control variable is connected to this input, and the input is not observed either. Its "
        "value is never determined, so no guard that reads it ever follows from the model. If the input gets its value "
        "from an input of the enclosing module, the finding names the outermost such input: connect that one.",
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
             "The value of the control variable has the same effect as its idle value: no guard and no observation "
             "differs between the two values, in whatever modes the components are. Either a transition that reads the "
             "value is missing, or the value is superfluous. If a guard or constraint asks for the value of another "
             "attribute with the same domain, the finding is a note.",
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
             "Lint reports an attribute in three cases:\n\n- No mode constraint, guard or interconnection mentions the "
             "attribute, and it is neither commanded nor observed.\n- The attribute is an input of a component, and no "
             "guard or mode constraint of the component reads it.\n- The attribute is a variable of a model program, "
             "and no constraint or condition mentions it.",
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
    CodeInfo{Code::unexplained_reading, "reading that no mode explains",
             "The domain of the sensor has a value that no reachable state of the plant explains, not even with "
             "faults. Real sensors fail. Such a reading contradicts every estimate, so the executive sets it aside. A "
             "fault mode without a constraint explains every reading. If the sensor can never give the value, remove "
             "the value from the domain.",
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
        "Once the fault has happened, no transitions lead to these goals of other components, whatever is commanded "
        "and whatever modes the others are in. A goal that already holds may continue to hold. The analysis includes "
        "the modes that can follow the fault by nominal transitions. It checks whether these modes can imply the "
        "guards of the transitions to the goal; a fault mode without a constraint implies nothing. Lint skips plants "
        "of more than 32 components. A program that must survive the fault should watch for it.",
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
