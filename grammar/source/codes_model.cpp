// Codes of the registry: model programs.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array model_table = {
    CodeInfo{Code::mixed_program, "model and control definitions mixed",
             "A program is of one of two kinds. A model program tells what a system does, and each of its definitions "
             "begins with `model`. A control program asserts what the system should do, and none of its definitions "
             "begins with `model`. Neither can call the other, so keep them in separate files.",
             R"(variable power : { off, on };
model Camera() :: { power = on }
Main() :: { Camera() })",
             R"(variable power : { off, on };
model Camera() :: { power = on }
model Main() :: { Camera() })"},
    CodeInfo{Code::told_at_once, "branch that tells at once",
             "A `choose` is drawn at the end of its instant, so the constraints of that instant cannot depend on the "
             "draw. A branch must not tell a constraint before its first `next`, `thennext`, `donext` or `;`. One "
             "exception: a `choose` that runs only at the start of the program is drawn before the start, and its "
             "branches may tell constraints at once.",
             R"(variable lamp : { dark, lit };
model Main() :: {
  always choose { lamp = lit with 0.9, lamp = dark with 0.1 }
})",
             R"(variable lamp : { dark, lit };
model Main() :: {
  always choose { next lamp = lit with 0.9, next lamp = dark with 0.1 }
})"},
    CodeInfo{Code::choice_distribution, "branches of a `choose`",
             "The probabilities of the branches of a `choose` sum to 1. If one of them is a whole number above 1, all "
             "of them are shares of their sum.",
             R"(variable lamp : { dark, lit };
model Main() :: {
  choose { lamp = lit with 0.9, lamp = dark with 0.05 }
})",
             R"(variable lamp : { dark, lit };
model Main() :: {
  choose { lamp = lit with 0.9, lamp = dark with 0.1 }
})"},
    CodeInfo{Code::clock_in_model, "clock in a model program",
             "A model program counts steps and has no clocks. To wait for n steps, write `next` n times. To wait for a "
             "random time, write a `choose` that continues with a probability.",
             R"(variable lamp : { dark, lit };
model Main() :: {
  t = 0;
  when t >= 2 s donext lamp = lit
})",
             R"(variable lamp : { dark, lit };
model Main() :: {
  next next lamp = lit
})"},
    CodeInfo{Code::not_in_steps, "component that does not move in steps",
             "A plant that contains a model program moves in steps, and steps have no duration. Its components may not "
             "have:\n\n- transitions with time bounds,\n- faults with a rate,\n- modes with more than ten different "
             "guards.\n\nGive the transition a probability per step, or leave the model program out of this plant.",
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
