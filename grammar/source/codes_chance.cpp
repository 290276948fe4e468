// Codes of the registry: time bounds and probabilities of plant models.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{Code::probability_out_of_range, "probability outside [0, 1]", "A probability is a number from 0 to 1.",
             R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  any -> failed with 1.5;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})",
             R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  any -> failed with 0.015;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})"},
    CodeInfo{Code::probabilities_exceed_one, "probabilities sum above 1",
             "The probabilities of what excludes each other sum to more than 1: the branches of one transition, the "
             "faults that leave one mode, or an initial distribution.",
             R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  fault stuck;
  any -> failed with 0.7;
  any -> stuck with 0.6;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})",
             R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  fault stuck;
  any -> failed with 0.07;
  any -> stuck with 0.06;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})"},
    CodeInfo{Code::reversed_bounds, "lower bound above upper bound", "Time bounds are [l, u] with l at most u.",
             R"(component Heater {
  initial heating;
  mode heating;
  mode warm;
  heating -> warm in [60 s, 30 s];
}
plant Cabin { heater : Heater; })",
             R"(component Heater {
  initial heating;
  mode heating;
  mode warm;
  heating -> warm in [30 s, 60 s];
}
plant Cabin { heater : Heater; })"},
    CodeInfo{Code::density_required, "unbounded transition without a density",
             "Where the upper bound is infinite, nothing says how the time is spread: a uniform density needs an end. "
             "Give an exponential or a normal one.",
             R"(component Heater {
  initial heating;
  mode heating;
  mode warm;
  heating -> warm in [30 s, inf];
}
plant Cabin { heater : Heater; })",
             R"(component Heater {
  initial heating;
  mode heating;
  mode warm;
  heating -> warm in [30 s, inf] ~ exponential(60 s);
}
plant Cabin { heater : Heater; })"},
    CodeInfo{
        Code::fault_without_probability, "fault transition without probability",
        "A transition into a fault mode is a fault transition. Nobody commands it: it needs a probability per step, "
        "or a rate per unit of time.",
        R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  any -> failed;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})",
        R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  any -> failed with rate 1e-6 / h;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})"},
    CodeInfo{Code::weight_not_allowed, "weight not allowed",
             "A rate belongs to fault transitions: nominal ones share what the faults leave, by `with` weights.",
             R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  off -> on when cmd = fire with rate 1 / h;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})",
             R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  off -> on when cmd = fire;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})"},
    CodeInfo{
        Code::density_out_of_range, "density out of range",
        "The mean of an exponential density and the standard deviation of a normal one are above 0, and the density "
        "has some of its mass between the time bounds.",
        R"(component Heater {
  initial heating;
  mode heating;
  mode warm;
  heating -> warm in [0, inf] ~ exponential(0 s);
}
plant Cabin { heater : Heater; })",
        R"(component Heater {
  initial heating;
  mode heating;
  mode warm;
  heating -> warm in [0, inf] ~ exponential(60 s);
}
plant Cabin { heater : Heater; })"},
    CodeInfo{
        Code::initial_distribution, "initial distribution",
        "The initial probabilities of a component sum to 1, or are shares, where a whole number above 1 is among them. "
        "One mode alone is certain.",
        R"(component Engine {
  initial off 0.9, on 0.05;
  mode off;
  mode on;
}
plant Lander { engine : Engine; })",
        R"(component Engine {
  initial off 0.9, on 0.1;
  mode off;
  mode on;
}
plant Lander { engine : Engine; })"},
    CodeInfo{
        Code::branch_distribution, "branches of a transition",
        "The probabilities of the branches of a transition sum to 1. Where a whole number above 1 is among them, all "
        "are shares of their sum.",
        R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  off -> when cmd = fire { on with 0.9, failed with 0.05 };
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})",
        R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  off -> when cmd = fire { on with 0.9, failed with 0.1 };
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})"},
    CodeInfo{Code::negative_rate, "negative rate", "A rate is at least 0 per unit of time.", R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  any -> failed with rate -1 / h;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})",
             R"(component Engine {
  input cmd : { none, fire };
  initial off;
  mode off;
  mode on;
  fault failed;
  any -> failed with rate 1e-6 / h;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})"},
};

}  // namespace

std::span<const CodeInfo> chance_codes() { return table; }

}  // namespace rmpl::grammar
