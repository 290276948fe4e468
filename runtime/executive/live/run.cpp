// The executive's cycles around a live plant.
// SPDX-License-Identifier: MIT
#include "runtime/executive/live/run.hpp"

#include <array>

#include "runtime/executive/cycle/executive.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::runtime {

LiveResult run_live(const automata::Program& program, Engines& engines, Channel& channel, const LiveRun& options,
                    const std::vector<CycleObserver*>& observers) {
  LivePlant plant(engines.plant(), channel, options.cycle, options.plant);
  Executive executive(program, engines.plant(), engines.estimator(), engines.reconfigurer(), plant, plant,
                      options.cycle);
  const auto look = [&](const CycleRecord& record) {
    for (CycleObserver* observer : observers) observer->observe(record);
  };
  const auto cycles_until = [&](automata::Ticks time) {  // rounded up
    return static_cast<std::uint64_t>((time.count - 1) / options.cycle.count + 1);
  };
  const std::uint64_t most = cycles_until(options.duration);
  const std::uint64_t alone = cycles_until(options.give_up);

  LiveResult result;
  look(executive.record());
  while (true) {
    if (executive.ended()) break;
    if (executive.record().cycle >= most) result.end = LiveResult::End::duration;
    if (plant.cycles_without() >= alone) result.end = LiveResult::End::abandoned;
    if (options.plant.interrupted()) result.end = LiveResult::End::interrupted;
    if (result.end != LiveResult::End::program) break;
    look(executive.run_cycle());
  }
  result.cycles = executive.record().cycle;
  result.acknowledged = plant.acknowledged();
  result.time = executive.record().time;
  return result;
}

std::string summary(const LiveResult& result, automata::Ticks give_up) {
  std::string text;
  switch (result.end) {
    case LiveResult::End::program:
      text = "the program ended at ";
      break;
    case LiveResult::End::duration:
      text = "the duration ended at ";
      break;
    case LiveResult::End::interrupted:
      text = "interrupted at ";
      break;
    case LiveResult::End::abandoned:
      text = "given up, because no plant was connected for " + automata::format_seconds(give_up) + " s, at ";
      break;
  }
  return text + moment(result.time) + "; " + std::to_string(result.acknowledged) + " of " +
         std::to_string(result.cycles) + " commands acknowledged\n";
}

std::string to_json(const LiveResult& result) {
  static constexpr std::array<const char*, 4> ends{"program", "duration", "interrupted", "abandoned"};
  JsonLine json;
  json.open('{').key("end").string(ends.at(static_cast<std::size_t>(result.end)));
  json.key("cycles").number(result.cycles).key("acknowledged").number(result.acknowledged);
  json.key("time").seconds(result.time).close('}');
  return json.text() + "\n";
}

}  // namespace rmpl::runtime
