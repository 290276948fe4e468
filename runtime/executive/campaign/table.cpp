// Writes runs as CSV and as JSON, with one order of columns.
// SPDX-License-Identifier: MIT
#include "runtime/executive/campaign/table.hpp"

#include <optional>
#include <vector>

namespace rmpl::runtime {
namespace {

using automata::Ticks;

std::string seconds(const std::optional<Ticks>& time) { return time ? automata::format_seconds(*time) : ""; }

template <class Text>
std::string joined(const std::vector<Injected>& faults, const Text& text_of) {
  std::string text;
  for (std::size_t f = 0; f < faults.size(); ++f) text += (f > 0 ? ";" : "") + text_of(faults[f]);
  return text;
}

void put(JsonLine& json, std::string_view key, const std::optional<Ticks>& time) {
  json.key(key);
  if (time) {
    json.seconds(*time);
  } else {
    json.null();
  }
}

}  // namespace

std::string csv_head() {
  return "run,seed,verdict,ended,time,cycles,right,chance_faults,faults,at,forced,symptom,named\n";
}

std::string csv_line(const CampaignRun& run, const automata::Plant& plant) {
  std::string line = std::to_string(run.run) + "," + std::to_string(run.seed) + "," +
                     std::string(name_of(run.verdict)) + "," + seconds(run.ended) + "," + seconds(run.time) + "," +
                     std::to_string(run.cycles) + "," + std::to_string(run.right) + "," + std::to_string(run.by_chance);
  line += "," + joined(run.injected, [&](const Injected& injected) {
            const automata::Component& component = plant[injected.fault.component];
            return component.name + "=" + component.modes[injected.fault.mode.index()].name;
          });
  line += "," + joined(run.injected, [](const Injected& injected) { return seconds(injected.fault.at); });
  line += "," + joined(run.injected, [](const Injected& injected) { return seconds(injected.forced); });
  line += "," + joined(run.injected, [](const Injected& injected) { return seconds(injected.symptom); });
  line += "," + joined(run.injected, [](const Injected& injected) { return seconds(injected.named); });
  return line + "\n";
}

void write(JsonLine& json, const CampaignRun& run, const automata::Plant& plant) {
  json.open('{').key("run").number(run.run).key("seed").number(run.seed).key("verdict").string(name_of(run.verdict));
  put(json, "ended", run.ended);
  put(json, "time", run.time);
  json.key("cycles").number(run.cycles).key("right").number(run.right).key("chance_faults").number(run.by_chance);
  json.key("faults").open('[');
  for (const Injected& injected : run.injected) {
    const automata::Component& component = plant[injected.fault.component];
    json.open('{').key("component").string(component.name);
    json.key("mode").string(component.modes[injected.fault.mode.index()].name);
    put(json, "at", injected.fault.at);
    put(json, "forced", injected.forced);
    put(json, "symptom", injected.symptom);
    put(json, "named", injected.named);
    json.close('}');
  }
  json.close(']').close('}');
}

}  // namespace rmpl::runtime
