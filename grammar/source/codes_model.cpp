// Codes of the registry: model programs.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array model_table = {
    CodeInfo{
        Code::mixed_program, "model and control definitions mixed",
        "A program either tells what a system does, and all its definitions begin with `model`, or asserts what it "
        "should do, and none does. Neither can call the other: keep them in files of their own.",
        R"(variable power : { off, on };
model Camera() :: { power = on }
Main() :: { Camera() })",
        R"(variable power : { off, on };
model Camera() :: { power = on }
model Main() :: { Camera() })"},
    CodeInfo{
        Code::told_at_once, "branch that tells at once",
        "A `choose` is drawn as its instant ends. What holds in that instant cannot depend on the draw, so no branch "
        "tells anything before its first `next`, `thennext`, `donext` or `;`. One that starts with the program, and "
        "never again, is drawn before the start, and may.",
        R"(variable lamp : { dark, lit };
model Main() :: {
  always choose { lamp = lit with 0.9, lamp = dark with 0.1 }
})",
        R"(variable lamp : { dark, lit };
model Main() :: {
  always choose { next lamp = lit with 0.9, next lamp = dark with 0.1 }
})"},
    CodeInfo{
        Code::choice_distribution, "branches of a `choose`",
        "The probabilities of the branches of a `choose` sum to 1. Where a whole number above 1 is among them, all "
        "are shares of their sum.",
        R"(variable lamp : { dark, lit };
model Main() :: {
  choose { lamp = lit with 0.9, lamp = dark with 0.05 }
})",
        R"(variable lamp : { dark, lit };
model Main() :: {
  choose { lamp = lit with 0.9, lamp = dark with 0.1 }
})"},
    CodeInfo{Code::clock_in_model, "clock in a model program",
             "A model program counts steps, and has no clocks. A wait is as many `next` as steps, or a `choose` that "
             "goes on with a probability.",
             R"(variable lamp : { dark, lit };
model Main() :: {
  t = 0;
  when t >= 2 s donext lamp = lit
})",
             R"(variable lamp : { dark, lit };
model Main() :: {
  next next lamp = lit
})"},
    CodeInfo{
        Code::not_in_steps, "component that does not move in steps",
        "A plant that holds a model program moves in steps, which have no length: no component of it has transitions "
        "that take time or faults with a rate, or modes with more than ten different guards. Say how likely the "
        "transition is in a step; or leave the model program out of this plant.",
        R"(// software.rmpl
variable power : { off, on };
model Software() :: { always power = on }
// lamp.tcca
import "software.rmpl";
component Lamp {
  input power : { off, on };
  initial dark;
  mode dark;
  mode lit;
  dark -> lit when power = on after 2 s;
}
plant House {
  software : model Software;
  lamp : Lamp;
  lamp.power = software.power;
})",
        R"(// software.rmpl
variable power : { off, on };
model Software() :: { always power = on }
// lamp.tcca
import "software.rmpl";
component Lamp {
  input power : { off, on };
  initial dark;
  mode dark;
  mode lit;
  dark -> { lit with 0.5, dark with 0.5 } when power = on;
}
plant House {
  software : model Software;
  lamp : Lamp;
  lamp.power = software.power;
})"},
};

}  // namespace

std::span<const CodeInfo> model_codes() { return model_table; }

}  // namespace rmpl::grammar
