// Codes of the registry: monitors, and lint of them.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/monitor_codes.hpp"

// The plant of the examples.
#define TANK                                                                                                           \
  "// tank.tcca\ncomponent Tank {\n  output level : { low, fine, high };\n  initial filled;\n"                         \
  "  mode filled { level = fine };\n  fault leaking { level = low };\n  fault flooded { level = high };\n  filled -> " \
  "leaking with 0.01;\n  filled -> flooded with 0.01;\n}\n"                                                            \
  "plant Farm { tank : Tank; observe tank.level; }\n// tank.mon\n"

// A flight of it, with its monitors.
#define FLIGHT                                                                   \
  "$ rmplc check tank.mon test.scn\n" TANK                                       \
  "channel \"LEVEL\" : tank.level { low below 1; fine 1 to 3; high above 3; }\n" \
  "// main.rmpl\nMain() :: { tank = filled }\n// test.scn\n"

namespace rmpl::grammar {
namespace {

constexpr std::array monitor_table = {
    CodeInfo{no_monitor, "no monitor",
             "A file of monitors has at least one channel, and a channel says which numbers or texts mean which value.",
             TANK R"(channel "LEVEL" : tank.level { hysteresis 0.1; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; hysteresis 0.1; })"},
    CodeInfo{monitor_repeated_part, "monitor part given twice",
             "An attribute has one channel, and a channel each setting once; a text means one value.",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; persist 2; persist 3; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; persist 3; })"},
    CodeInfo{monitor_not_observed, "monitor of an unobserved attribute",
             "A monitor gives readings of an attribute, so the plant has to observe it. No sensor reads a mode.",
             R"(// tank.tcca
component Tank {
  output level : { low, fine };
  initial filled;
  mode filled { level = fine };
  fault leaking { level = low };
  filled -> leaking with 0.01;
}
plant Farm { tank : Tank; observe tank.level; }
// tank.mon
channel "LEVEL" : tank { filled below 1; leaking above 1; })",
             R"(// tank.tcca
component Tank {
  output level : { low, fine };
  initial filled;
  mode filled { level = fine };
  fault leaking { level = low };
  filled -> leaking with 0.01;
}
plant Farm { tank : Tank; observe tank.level; }
// tank.mon
channel "LEVEL" : tank.level { low below 1; fine 1 to 3; })"},
    CodeInfo{
        monitor_limits, "limits that no number meets",
        "The first of two limits is the lower one. A hysteresis is at least 0, `persist` is a number of samples from 1 "
        "or a duration, a rate is over more than 0 s. A difference or a rate is a number, never a text.",
        TANK R"(channel "LEVEL" : tank.level { low below 1; fine 3 to 1; high above 3; })",
        TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; })"},
    CodeInfo{monitor_overlap, "limits that overlap",
             "A number would mean two values. Limits may meet: what two values share belongs to the first of them.",
             TANK R"(channel "LEVEL" : tank.level { low below 1.5; fine 1 to 3; high above 3; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; })"},
    CodeInfo{channel_without_monitor, "channel without a monitor",
             "A scenario gives a sample of a channel, and monitors make a reading of it. They stand in a file of their "
             "own, which is given beside the scenario (`rmplc check tank.mon test.scn`, `rmpl-run scenario test.scn "
             "--monitors tank.mon`) or in the scenario's set of rmpl.toml.",
             FLIGHT R"(scenario "leak" {
  program "main.rmpl";
  plant "tank.tcca";
  at 3 s channel "LEVLE" = 0.7;
  expect tank = leaking;
})",
             FLIGHT R"(scenario "leak" {
  program "main.rmpl";
  plant "tank.tcca";
  at 3 s channel "LEVEL" = 0.7;
  expect tank = leaking;
})"},
    CodeInfo{monitor_gap, "gap between limits",
             "Numbers between the limits of two values give no reading: the estimate goes on without the sensor, "
             "unnoticed. If that is meant, as for a number that no sensor can give, allow the finding.",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1.5 to 3; high above 3; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1.5; fine 1.5 to 3; high above 3; })"},
    CodeInfo{monitor_hysteresis, "hysteresis wider than its band",
             "A value is left only once its limit is passed by the hysteresis. A hysteresis wider than the band of a "
             "value holds the neighbour's value over the whole band, so the value in between is skipped.",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; hysteresis 5; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; hysteresis 0.5; })"},
    CodeInfo{monitor_value_missing, "value that no limits give",
             "No number and no text of the channel means this value of the attribute. That is right if the channel "
             "cannot show it; else a line is missing.",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; })"},
    CodeInfo{
        sample_without_reading, "sample that gives no reading",
        "A number in a gap between limits, and a text that no monitor knows, give no reading: the sensor is silent "
        "from then on. If the scenario is to show that, allow the finding.",
        FLIGHT R"(scenario "leak" {
  program "main.rmpl";
  plant "tank.tcca";
  at 3 s channel "LEVEL" = "LOW";
  expect tank = leaking;
})",
        FLIGHT R"(scenario "leak" {
  program "main.rmpl";
  plant "tank.tcca";
  at 3 s channel "LEVEL" = 0.7;
  expect tank = leaking;
})"}};

}  // namespace

std::span<const CodeInfo> monitor_codes() { return monitor_table; }

}  // namespace rmpl::grammar

#undef FLIGHT
#undef TANK
