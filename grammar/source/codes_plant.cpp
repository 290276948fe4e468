// Codes of the registry: plant models.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{Code::probability_out_of_range, "probability outside [0, 1]", "A probability is a number from 0 to 1.",
             "any -> failed with 1.5;", "any -> failed with 0.015;"},
    CodeInfo{Code::probabilities_exceed_one, "probabilities sum above 1",
             "The probabilities of what excludes each other sum to more than 1: the branches of one transition, the "
             "faults that leave one mode, or an initial distribution.",
             "off -> { on with 0.9, failed with 0.2 };", "off -> { on with 0.9, failed with 0.1 };"},
    CodeInfo{Code::reversed_bounds, "lower bound above upper bound", "Time bounds are [l, u] with l at most u.",
             "heating -> standby in [60 s, 30 s];", "heating -> standby in [30 s, 60 s];"},
    CodeInfo{Code::density_required, "unbounded transition without a density",
             "Where the upper bound is infinite, nothing says how the time is spread: a uniform density needs an end. "
             "Give an exponential or a normal one.",
             "heating -> standby in [30 s, inf];", "heating -> standby in [30 s, inf] ~ exponential(60 s);"},
    CodeInfo{
        Code::fault_without_probability, "fault transition without probability",
        "A transition into a fault mode is a fault transition. Nobody commands it: it needs a probability per step, "
        "or a rate per unit of time.",
        "any -> failed;", "any -> failed with rate 1e-6 /h;"},
    CodeInfo{Code::foreign_guard, "guard or mode constraint of another component",
             "Guards and mode constraints of a component speak of its own attributes only. Components influence each "
             "other through the interconnections of the module that holds them.",
             "off -> on when battery.power = yes;", "input power : { no, yes };\noff -> on when power = yes;"},
    CodeInfo{
        Code::clock_in_plant, "clock in a plant model",
        "Clocks belong to control programs. A component has one clock, which starts when its mode does; time bounds "
        "on transitions speak of it.",
        "heating -> standby when t > 30 s;", "heating -> standby in [30 s, 60 s];"},
    CodeInfo{Code::no_plant, "no plant", "A model has exactly one `plant`, the root module; here is none.",
             "module Lander { … }", "plant Lander { … }"},
    CodeInfo{Code::several_plants, "several plants",
             "A model has exactly one `plant`, the root module. Make the others modules.",
             "plant Lander { … }\nplant Orbiter { … }", "module Lander { … }\nplant Mission { lander : Lander; }"},
    CodeInfo{Code::no_instances, "plant without instances",
             "The plant holds no component, neither itself nor through a module: there is nothing to be in a mode.",
             "plant Lander { }", "plant Lander { engine : Engine; }"},
    CodeInfo{Code::instance_cycle, "module that contains itself",
             "A module has an instance of itself, directly or through others: the plant would be infinite.",
             "module A { a : A; }", "module A { b : B; }"},
    CodeInfo{Code::no_modes, "component without modes", "A component is always in one mode, so it needs at least one.",
             "component Wire { input a : Level; }", "component Wire { input a : Level; initial ok; mode ok; }"},
    CodeInfo{Code::weight_not_allowed, "weight not allowed",
             "A rate belongs to fault transitions: nominal ones share what the faults leave, by `with` weights.",
             "off -> on with rate 1 /h;", "off -> on with 0.5;"},
    CodeInfo{
        Code::density_out_of_range, "density out of range",
        "The mean of an exponential density and the standard deviation of a normal one are above 0, and the density "
        "has some of its mass between the time bounds.",
        "heating -> on in [0, inf] ~ exponential(0 s);", "heating -> on in [0, inf] ~ exponential(60 s);"},
    CodeInfo{
        Code::initial_distribution, "initial distribution",
        "The initial probabilities of a component sum to 1, or are shares, where a whole number above 1 is among them. "
        "One mode alone is certain.",
        "initial off 0.9, on 0.05;", "initial off 0.9, on 0.1;"},
    CodeInfo{
        Code::branch_distribution, "branches of a transition",
        "The probabilities of the branches of a transition sum to 1. Where a whole number above 1 is among them, all "
        "are shares of their sum.",
        "off -> { on with 0.9, stuck with 0.05 };", "off -> { on with 0.9, stuck with 0.1 };"},
    CodeInfo{Code::no_default, "control variable without an idle value",
             "A control variable has a value while nothing is commanded; `default` names it.", "control engine.cmd;",
             "control engine.cmd default none;"},
    CodeInfo{Code::direction, "against the direction of an attribute",
             "Control variables are inputs that nothing else drives; observations are attributes that the plant has.",
             "control engine.thrust default zero;  // an output", "control engine.cmd default none;"},
    CodeInfo{Code::negative_rate, "negative rate", "A rate is at least 0 per unit of time.",
             "any -> failed with rate -1 /h;", "any -> failed with rate 1e-6 /h;"},
};

}  // namespace

std::span<const CodeInfo> plant_codes() { return table; }

}  // namespace rmpl::grammar
