// The keys of a trace line, in the order of the contract.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/trace_writer.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.hpp"

namespace rmpl::runtime {

TraceWriter::TraceWriter(const automata::Plant& plant, std::string path)
    : plant_(plant), path_(std::move(path)), file_(path_, std::ios::binary | std::ios::trunc) {
  if (!file_) throw base::InputError(path_ + ": cannot be written");
  for (std::size_t c = 0; c < plant_.components.size(); ++c) {
    auto& live = live_clocks_.emplace_back();
    for (std::size_t m = 0; m < plant_.components[c].modes.size(); ++m) {
      live.push_back(plant_.has_timed_exit(automata::ComponentId(c), automata::ModeId(m)));
    }
  }
}

TraceWriter::~TraceWriter() {
  if (kept_) return;
  file_.close();
  // A device or a link that was given as a path is not ours to remove.
  std::error_code ignored;
  if (std::filesystem::is_regular_file(std::filesystem::symlink_status(path_, ignored))) {
    std::filesystem::remove(path_, ignored);
  }
}

void TraceWriter::observe(const CycleRecord& record) {
  line_.clear();
  line_.open('{').key("cycle").number(record.cycle).key("time").seconds(record.time);
  line_.key("marking").open('[');
  for (const automata::LocationId location : record.marking) line_.number(location.index() + 1);
  line_.close(']');
  line_.key("goal").assignments(record.goal, plant_.variables);
  line_.key("command").open('{');
  for (std::size_t i = 0; i < record.command.size(); ++i) {
    const automata::Control& control = plant_.controls[i];
    if (record.command[i] == control.idle) continue;
    line_.key(plant_.variables.name(control.variable));
    line_.string(plant_.variables.value({control.variable, record.command[i]}));
  }
  line_.close('}');
  line_.key("observations").assignments(record.observations, plant_.variables);
  line_.key("estimate").modes(record.estimate, plant_);
  line_.key("belief").belief(record.estimator->belief(), plant_, record.time, &live_clocks_);
  if (record.truth != nullptr) line_.key("truth").modes(*record.truth, plant_);
  line_.key("events");
  write_events(line_, record.events, &plant_);
  line_.close('}');
  file_ << line_.text() << '\n';
}

void TraceWriter::keep() {
  file_.close();
  if (!file_) throw base::InputError(path_ + ": could not be written in full");
  kept_ = true;
}

void write_events(JsonLine& line, const std::vector<Event>& events, const automata::Plant* plant) {
  line.open('[');
  for (const Event& event : events) {
    line.open('{').key("kind").string(name_of(event.kind));
    if (event.component && plant != nullptr) line.key("component").string((*plant)[*event.component].name);
    if (event.locations) {
      line.key("locations").open('[');
      line.number(event.locations->first.index() + 1).number(event.locations->second.index() + 1).close(']');
    }
    if (!event.message.empty()) line.key("message").string(event.message);
    line.close('}');
  }
  line.close(']');
}

}  // namespace rmpl::runtime
