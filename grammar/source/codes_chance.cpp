// Codes of the registry: time bounds and probabilities of plant models.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array chance_table = {
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
             "The probabilities of alternatives sum to more than 1. Alternatives are the branches of one transition, "
             "the faults that leave one mode, or the modes of an initial distribution.",
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
    CodeInfo{Code::reversed_bounds, "lower bound above upper bound",
             "In time bounds [l, u], the lower bound l is at most the upper bound u.",
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
             "A nominal transition with an infinite upper bound needs a density. The default is a uniform density, "
             "which needs a finite end. Give another one, such as an exponential density. A fault needs none: it is "
             "drawn in each step that ends within the bounds.",
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
    CodeInfo{Code::fault_without_probability, "fault transition without probability",
             "A transition into a fault mode is a fault transition. No command causes it, so it needs a probability "
             "per step or a rate per unit of time.",
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
             "Only fault transitions and repairs of faults have a rate. Other nominal transitions divide the "
             "probability that the faults leave, in proportion to their `with` weights. For an exponentially "
             "distributed time, write `in [0 s, inf] ~ exponential(mean)`.",
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
        "The mean of an exponential or Erlang density, the standard deviation of a normal one and the scale of a "
        "Weibull "
        "one are above 0. The shape of a Weibull density is from 0.01 to 100. An Erlang density has 1 to 100 stages, a "
        "whole number.",
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
    CodeInfo{Code::initial_distribution, "initial distribution",
             "The initial probabilities of a component sum to 1. If one of them is a whole number above 1, all of them "
             "are shares of their sum. A single initial mode is certain and needs no probability.",
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
    CodeInfo{Code::branch_distribution, "branches of a transition",
             "The probabilities of the branches of a transition sum to 1. If one of them is a whole number above 1, "
             "all of them are shares of their sum.",
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
    CodeInfo{
        Code::restart_not_allowed, "restart not allowed",
        "`a -> a restart when …` restarts the clock of a mode while the component stays in that mode, in each step in "
        "which the guard holds. A restart leads from one mode to itself, and has neither time bounds nor a rate.",
        R"(component Watchdog {
  input  ping  : { no, yes };
  output alive : { no, yes };
  initial running;
  mode running   { alive = yes };
  mode timed-out { alive = no };
  any     -> running restart when ping = yes;
  running -> timed-out after 10 s;
}
plant Monitor {
  dog : Watchdog;
  control dog.ping default no;
  observe dog.alive;
})",
        R"(component Watchdog {
  input  ping  : { no, yes };
  output alive : { no, yes };
  initial running;
  mode running   { alive = yes };
  mode timed-out { alive = no };
  running   -> running restart when ping = yes;
  timed-out -> running when ping = yes;
  running   -> timed-out after 10 s;
}
plant Monitor {
  dog : Watchdog;
  control dog.ping default no;
  observe dog.alive;
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

std::span<const CodeInfo> chance_codes() { return chance_table; }

}  // namespace rmpl::grammar
