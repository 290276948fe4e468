// Samples against what they mean by themselves, and against what is read.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/sample_story.hpp"

#include <algorithm>

#include "automata/assignment_text.hpp"
#include "automata/owner.hpp"
#include "runtime/telemetry/monitors.hpp"

namespace rmpl::runtime {
namespace {

using automata::Monitor;

constexpr std::size_t nothing = static_cast<std::size_t>(-1);  ///< no position of a value

bool is_plain(const Monitor& monitor) { return !monitor.minus && !monitor.over; }
bool is_of_channel(const Monitor& monitor, const std::string& channel) {
  return monitor.channel == channel || monitor.minus == channel;
}

std::optional<automata::ValueId> reading_of(const CycleRecord& record, automata::VariableId attribute) {
  const auto seen = std::find_if(record.observations.begin(), record.observations.end(),
                                 [&](const automata::Assignment& one) { return one.variable == attribute; });
  return seen == record.observations.end() ? std::nullopt : std::optional(seen->value);
}

}  // namespace

/// Takes down what each monitor's attribute reads, from the first sample of the monitor on.
void SampleStory::read(const CycleRecord& record) {
  const std::vector<Monitor>& monitors = *record.monitors;
  read_.resize(monitors.size());
  for (std::size_t m = 0; m < monitors.size(); ++m) {
    Read& one = read_[m];
    one.told = false;
    const bool sampled = std::any_of(record.samples.begin(), record.samples.end(), [&](const Sample& sample) {
      return is_of_channel(monitors[m], (*record.channels)[sample.channel]);
    });
    const bool first = !one.heard && sampled;
    one.heard = one.heard || sampled;
    const Reading reading = reading_of(record, monitors[m].attribute);
    one.changed = one.heard && (first || reading != one.reading);
    one.reading = reading;
  }
}

SampleStory::Line SampleStory::line_of(const std::string& channel, const Sample& sample, const CycleRecord& record,
                                       bool& news) {
  Line line{'"' + channel + "\" = " + sample.told(), std::nullopt};
  bool first = true;
  std::string meant = record.monitors == nullptr ? sample.told() : std::string();
  for (std::size_t m = 0; record.monitors != nullptr && m < record.monitors->size(); ++m) {
    const Monitor& monitor = (*record.monitors)[m];
    if (!is_of_channel(monitor, channel)) continue;
    Read& one = read_[m];
    std::size_t says = nothing;
    if (is_plain(monitor)) {
      if (const Reading value = value_of(monitor, sample)) says = value->index();
      meant += std::to_string(says) + ' ';
    }
    news = news || one.changed;
    one.told = true;
    const std::string& name = plant_.variables.name(monitor.attribute);
    line.text += first ? ": " : ", ";
    first = false;
    if (!one.reading) {
      line.text += "no reading of " + name;
    } else if (is_plain(monitor) && says != one.reading->index()) {
      line.text += name + " stays " + plant_.variables.value({monitor.attribute, *one.reading});
    } else {
      line.text += to_text(plant_.variables, automata::Assignment{monitor.attribute, *one.reading});
    }
    if (!line.about) line.about = automata::owner_of(plant_, monitor.attribute);
  }
  std::string& before = meant_[channel];
  news = news || before != meant;
  before = std::move(meant);
  return line;
}

std::vector<SampleStory::Line> SampleStory::lines(const CycleRecord& record) {
  std::vector<Line> lines;
  if (record.channels == nullptr) return lines;
  if (record.monitors != nullptr) read(record);
  std::map<std::string, const Sample*> last;
  for (const Sample& sample : record.samples) last[(*record.channels)[sample.channel]] = &sample;
  for (const auto& [channel, sample] : last) {
    bool news = false;
    Line line = line_of(channel, *sample, record, news);
    if (news) lines.push_back(std::move(line));
  }
  for (std::size_t m = 0; m < read_.size(); ++m) {
    const Read& one = read_[m];
    if (!one.changed || one.told || one.reading) continue;
    const Monitor& monitor = (*record.monitors)[m];
    lines.push_back({"no reading of " + plant_.variables.name(monitor.attribute) + ": no sample of \"" +
                         monitor.channel + "\" any more",
                     automata::owner_of(plant_, monitor.attribute)});
  }
  return lines;
}

}  // namespace rmpl::runtime
