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
             "A monitor file has at least one channel. A channel says which numbers or texts mean which value of its "
             "attribute.",
             TANK R"(channel "LEVEL" : tank.level { hysteresis 0.1; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; hysteresis 0.1; })"},
    CodeInfo{monitor_repeated_part, "monitor part given twice",
             "Each attribute has one channel. A channel has each setting at most once. A text means one value only.",
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
    CodeInfo{monitor_limits, "limits that no number meets",
             "The settings of a channel have these ranges:\n\n- The first of two limits is the lower one.\n- A "
             "hysteresis is at least 0.\n- `persist` is a number of samples from 1, or a duration.\n- A rate is "
             "measured over more than 0 s.\n- A difference or a rate is a number, never a text.",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 3 to 1; high above 3; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; })"},
    CodeInfo{monitor_overlap, "limits that overlap",
             "Some numbers would mean two values. Limits of two values may meet: a number on the shared limit means "
             "the value that is listed first.",
             TANK R"(channel "LEVEL" : tank.level { low below 1.5; fine 1 to 3; high above 3; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; })"},
    CodeInfo{channel_without_monitor, "channel without a monitor",
             "The scenario samples a channel that no monitor reads. Monitors turn samples into readings. Give the "
             "monitor file together with the scenario (`rmplc check tank.mon test.scn`, `rmpl-run scenario test.scn "
             "--monitors tank.mon`) or name it in the scenario's set in rmpl.toml.",
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
             "A number between the limits of two values gives no reading. The estimate then continues without the "
             "sensor, and nothing shows it. If that is intended, for example because the sensor cannot give such a "
             "number, allow the finding.",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1.5 to 3; high above 3; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1.5; fine 1.5 to 3; high above 3; })"},
    CodeInfo{monitor_hysteresis, "hysteresis wider than its band",
             "The monitor leaves a value only when a sample passes the limit of the value by the hysteresis. If the "
             "hysteresis is wider than the band of a value, the neighbouring value persists across the whole band, and "
             "the value in between is skipped.",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; hysteresis 5; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; hysteresis 0.5; })"},
    CodeInfo{monitor_value_missing, "value that no limits give",
             "No number and no text of the channel means this value of the attribute. This is right if the channel "
             "cannot show the value. Otherwise a line is missing.",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; })",
             TANK R"(channel "LEVEL" : tank.level { low below 1; fine 1 to 3; high above 3; })"},
    CodeInfo{sample_without_reading, "sample that gives no reading",
             "A number in a gap between limits gives no reading, and neither does a text that no monitor knows. From "
             "then on the sensor is silent. If the scenario tests that, allow the finding.",
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
