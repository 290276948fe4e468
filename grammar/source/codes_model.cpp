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
    CodeInfo{
        Code::too_much_software, "model program too large for a plant",
        "Each thread of a model program in a plant becomes a component, and each marking of the thread a mode. There "
        "are limits: 4,096 markings of a thread, 65,536 ways for its conditions to hold, and 16,384 combinations of "
        "modes and commands that decide one condition. What stands side by side in the outermost definition is a "
        "thread each; what stands side by side deeper inside is one thread, whose markings multiply.",
        R"(// software.rmpl
variable a, b, c, d, e, f, g, h, i, j, k, l, m : { no, yes };
model Bits() :: { do { Half(), Rest() } maintaining true }
model Half() :: { Bit(a), Bit(b), Bit(c), Bit(d), Bit(e), Bit(f) }
model Rest() :: { Bit(g), Bit(h), Bit(i), Bit(j), Bit(k), Bit(l), Bit(m) }
model Bit(x) :: {
  x = no,
  choose { next Bit(x) with 0.5, next always x = yes with 0.5 }
}
// computer.tcca
import "software.rmpl";
plant Computer { bits : model Bits; })",
        R"(// software.rmpl
variable a, b, c, d, e, f, g, h, i, j, k, l, m : { no, yes };
model Bits() :: {
  Bit(a), Bit(b), Bit(c), Bit(d), Bit(e), Bit(f), Bit(g),
  Bit(h), Bit(i), Bit(j), Bit(k), Bit(l), Bit(m)
}
model Bit(x) :: {
  x = no,
  choose { next Bit(x) with 0.5, next always x = yes with 0.5 }
}
// computer.tcca
import "software.rmpl";
plant Computer { bits : model Bits; })"},
};

}  // namespace

std::span<const CodeInfo> model_codes() { return model_table; }

}  // namespace rmpl::grammar
