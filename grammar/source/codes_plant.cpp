// Codes of the registry: the structure of plant models.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array plant_table = {
    CodeInfo{Code::foreign_guard, "guard or mode constraint of another component",
             "Guards and mode constraints of a component read only its own attributes. Components influence each other "
             "through the interconnections of the module that holds them.",
             R"(component Battery {
  output power : { no, yes };
  initial charged;
  mode charged { power = yes };
}
component Radio {
  initial off;
  mode off;
  mode on;
  off -> on when battery.power = yes;
}
plant Probe {
  battery : Battery;
  radio : Radio;
})",
             R"(component Battery {
  output power : { no, yes };
  initial charged;
  mode charged { power = yes };
}
component Radio {
  input power : { no, yes };
  initial off;
  mode off;
  mode on;
  off -> on when power = yes;
}
plant Probe {
  battery : Battery;
  radio : Radio;
  radio.power = battery.power;
})"},
    CodeInfo{Code::clock_in_plant, "clock in a plant model",
             "Clocks belong to control programs. A component has one clock, which starts when the component enters a "
             "mode. Time bounds on transitions refer to this clock.",
             R"(component Heater {
  initial heating;
  mode heating;
  mode warm;
  heating -> warm when t > 30 s;
}
plant Cabin { heater : Heater; })",
             R"(component Heater {
  initial heating;
  mode heating;
  mode warm;
  heating -> warm in [30 s, 60 s];
}
plant Cabin { heater : Heater; })"},
    CodeInfo{Code::no_plant, "no plant", "A model has exactly one `plant`, the root module. This model has none.",
             R"(component Valve {
  input cmd : { none, open };
  initial closed;
  mode closed;
  mode opened;
  closed -> opened when cmd = open;
}
module Tap {
  valve : Valve;
  control valve.cmd default none;
})",
             R"(component Valve {
  input cmd : { none, open };
  initial closed;
  mode closed;
  mode opened;
  closed -> opened when cmd = open;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
})"},
    CodeInfo{Code::several_plants, "several plants",
             "A model has exactly one `plant`, the root module. Make the others modules.", R"(component Gauge {
  output reading : { low, high };
  initial ok;
  mode ok;
}
plant Lander { gauge : Gauge; }
plant Orbiter { gauge : Gauge; })",
             R"(component Gauge {
  output reading : { low, high };
  initial ok;
  mode ok;
}
module Lander { gauge : Gauge; }
module Orbiter { gauge : Gauge; }
plant Mission {
  lander : Lander;
  orbiter : Orbiter;
})"},
    CodeInfo{Code::no_instances, "plant without instances",
             "The plant contains no component, neither directly nor through a module, so it has no modes.",
             R"(component Gauge {
  output reading : { low, high };
  initial ok;
  mode ok;
}
plant Tank { })",
             R"(component Gauge {
  output reading : { low, high };
  initial ok;
  mode ok;
}
plant Tank { gauge : Gauge; })"},
    CodeInfo{Code::instance_cycle, "module that contains itself",
             "A module has an instance of itself, directly or through others: the plant would be infinite.",
             R"(component Gauge {
  output reading : { low, high };
  initial ok;
  mode ok;
}
module Stage {
  gauge : Gauge;
  upper : Stage;
}
plant Rocket { stage : Stage; })",
             R"(component Gauge {
  output reading : { low, high };
  initial ok;
  mode ok;
}
module Stage { gauge : Gauge; }
plant Rocket {
  stage : Stage;
  upper : Stage;
})"},
    CodeInfo{Code::no_modes, "component without modes", "A component is always in one mode, so it needs at least one.",
             R"(component Wire { input level : { low, high }; }
plant Board { wire : Wire; })",
             R"(component Wire {
  input level : { low, high };
  initial ok;
  mode ok;
}
plant Board { wire : Wire; })"},
    CodeInfo{Code::no_default, "control variable without an idle value",
             "`default` names the idle value of a control variable: the value that it has while the executive commands "
             "nothing.",
             R"(component Valve {
  input cmd : { none, open };
  initial closed;
  mode closed;
  mode opened;
  closed -> opened when cmd = open;
}
plant Tap {
  valve : Valve;
  control valve.cmd;
})",
             R"(component Valve {
  input cmd : { none, open };
  initial closed;
  mode closed;
  mode opened;
  closed -> opened when cmd = open;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
})"},
};

}  // namespace

std::span<const CodeInfo> plant_codes() { return plant_table; }

}  // namespace rmpl::grammar
