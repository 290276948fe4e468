// Monitors of an input set, the plants that they fit, and the channels that scenarios give samples of.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "base/nearest.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lower/monitor.hpp"
#include "compiler/session/input_set.hpp"
#include "grammar/source/monitor_codes.hpp"

namespace rmpl::compiler {

using automata::Monitor;
using grammar::Code;
using grammar::Span;

namespace {

/// A file of monitors over one plant.
struct OverPlant {
  std::vector<Monitor> monitors;
  grammar::Diagnostics said;
};

/// The number that a text of telemetry reads as, as in a CSV file.
std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc{} && !text.empty() && end == text.data() + text.size();
  return whole ? std::optional(number) : std::nullopt;
}

/// Whether a sample of one of its channels may give a reading by this monitor.
bool reads(const Monitor& monitor, const std::optional<double>& number, const std::string& text) {
  if (monitor.minus || monitor.over) return number.has_value();
  const bool literal = std::any_of(monitor.literals.begin(), monitor.literals.end(), [&](const auto& one) {
    return one.number ? number == one.number : text == one.text;
  });
  return literal || (number && std::any_of(monitor.bands.begin(), monitor.bands.end(),
                                           [&](const automata::Band& band) { return band.contains(*number); }));
}

/// As it is written.
std::string channel_name(const std::string& channel) { return "\"" + channel + "\""; }

}  // namespace

/// The files of monitors, each over all plants.
class InputSet::Monitoring {
 public:
  Monitoring(const grammar::Sources& sources, grammar::Diagnostics& diagnostics,
             std::vector<const automata::Plant*> plants)
      : sources_(sources), diagnostics_(diagnostics), plants_(std::move(plants)) {}

  void read(const File& file) {
    if (!file.whole) {
      whole_ = false;
      return;
    }
    const Span start{file.index, 0, 0};
    if (plants_.empty()) {
      // A plant with errors has been told of.
      if (diagnostics_.has_errors()) return;
      diagnostics_.error(Code::no_plant, start, "monitors speak of a plant, and there is none among the inputs");
      return;
    }
    std::vector<OverPlant> over;
    for (const automata::Plant* plant : plants_) {
      OverPlant& one = over.emplace_back();
      one.monitors = lower_monitors(sources_, *file.monitors, start, *plant, one.said);
    }
    const auto first = std::find_if(over.begin(), over.end(), [](const auto& one) { return !one.said.has_errors(); });
    const auto nearest = std::min_element(over.begin(), over.end(), [](const OverPlant& a, const OverPlant& b) {
      return a.said.error_count() < b.said.error_count();
    });
    whole_ = whole_ && first != over.end();
    if (first == over.end() && over.size() > 1) {
      diagnostics_.error(Code::no_plant, start,
                         "these monitors fit none of the " + std::to_string(over.size()) +
                             " plants among the inputs; below, what is wrong for the one that they fit best");
    }
    for (const grammar::Diagnostic& told : (first == over.end() ? nearest : first)->said.all()) diagnostics_.add(told);
    for (std::size_t p = 0; p < plants_.size(); ++p) {
      if (!over[p].said.has_errors()) join(*plants_[p], over[p].monitors, *file.monitors);
    }
    for (const grammar::MonitorDefinition& monitor : file.monitors->monitors) {
      named_.push_back(monitor.channel.text);
      if (monitor.minus) named_.push_back(monitor.minus->text);
    }
  }

  [[nodiscard]] const std::vector<Monitor>& of(const automata::Plant& plant) { return by_plant_[&plant].monitors; }

  /// Reports a channel that no monitor reads, and a sample that gives no reading.
  void check(const automata::Plant& plant, const std::string& channel, const std::optional<double>& number,
             const std::string& text, Span channel_span, Span sample_span) {
    const std::vector<Monitor>& monitors = of(plant);
    const auto is_of = [&](const Monitor& monitor) { return monitor.channel == channel || monitor.minus == channel; };
    if (std::any_of(monitors.begin(), monitors.end(), is_of)) {
      const auto may_read = [&](const Monitor& monitor) { return is_of(monitor) && reads(monitor, number, text); };
      if (std::any_of(monitors.begin(), monitors.end(), may_read)) return;
      diagnostics_.warning(
          grammar::sample_without_reading, sample_span,
          "the sample gives no reading: " + std::string(number ? "no limits of channel " : "no monitor of channel ") +
              channel_name(channel) + (number ? " hold the number" : " knows the text"));
      return;
    }
    if (!whole_) return;  // what the files say is not all known
    const bool elsewhere = std::find(named_.begin(), named_.end(), channel) != named_.end();
    auto& error =
        diagnostics_.error(grammar::channel_without_monitor, channel_span,
                           elsewhere ? "channel " + channel_name(channel) + " is read for another plant: plant " +
                                           backquoted(plant.name) + " does not have what its monitors speak of"
                                     : "no monitor reads channel " + channel_name(channel));
    std::vector<std::string> known;
    for (const Monitor& monitor : monitors) {
      known.push_back(monitor.channel);
      if (monitor.minus) known.push_back(*monitor.minus);
    }
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    if (const auto near = base::nearest(channel, known)) {
      error.suggestion = "did you mean " + channel_name(*near) + "?";
      error.fix = {{channel_span, channel_name(*near)}};
    } else if (!known.empty()) {
      for (std::string& name : known) name = channel_name(name);
      error.suggestion = "channels that have a monitor: " + listed(known);
    }
  }

 private:
  struct OfPlant {
    std::vector<Monitor> monitors;
    std::map<automata::VariableId, Span> attributes;  ///< and where a monitor of it stands
  };

  /// The first few of some names.
  static std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most = 5;
    std::string text;
    for (std::size_t n = 0; n < names.size() && n < most; ++n) text += (n == 0 ? "" : ", ") + names[n];
    return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more" : text;
  }

  /// Adds the monitors of one more file; an attribute has one of them.
  void join(const automata::Plant& plant, const std::vector<Monitor>& more, const grammar::MonitorFile& file) {
    OfPlant& all = by_plant_[&plant];
    for (std::size_t m = 0; m < more.size(); ++m) {
      const Span span = file.monitors[m].attribute.span;
      const auto [first, fresh] = all.attributes.emplace(more[m].attribute, span);
      if (!fresh) {
        diagnostics_.error(grammar::monitor_repeated_part, span, "a second channel of one attribute")
            .notes.push_back({first->second, "the first is here"});
        continue;
      }
      all.monitors.push_back(more[m]);
    }
  }

  const grammar::Sources& sources_;
  grammar::Diagnostics& diagnostics_;
  std::vector<const automata::Plant*> plants_;
  std::map<const automata::Plant*, OfPlant> by_plant_;
  std::vector<std::string> named_;  ///< channels of all files
  bool whole_ = true;               ///< every file is right for a plant
};

std::vector<const automata::Plant*> InputSet::all_plants() const {
  std::vector<const automata::Plant*> plants;
  for (const Part& part : parts_) plants.push_back(&part.plant);
  for (std::size_t p = 0; p < document_.plants.size(); ++p) {
    const bool lent = std::any_of(lent_.begin(), lent_.end(), [p](const auto& one) { return one.first == p; });
    if (!lent) plants.push_back(&document_.plants[p]);
  }
  return plants;
}

const automata::Plant* InputSet::plant_of(const automata::Scenario& scenario) const {
  for (const auto& [position, part] : lent_) {
    if (position == scenario.plant) return &part->plant;
  }
  return &document_.plants[scenario.plant];
}

void InputSet::monitors(const Roots& files, bool flown) {
  if (files.empty() && !flown) return;
  std::vector<const automata::Plant*> plants = all_plants();
  for (Sampled& one : sampled_) {
    if (one.definition == nullptr) one.plant = plant_of(document_.scenarios[*one.scenario]);
    if (one.plant != nullptr && std::find(plants.begin(), plants.end(), one.plant) == plants.end())
      plants.push_back(one.plant);
  }
  Monitoring monitoring(sources_, diagnostics_, std::move(plants));
  for (const File* file : files) monitoring.read(*file);
  const auto check = [&](const Sampled& one, const std::string& channel, const std::optional<double>& number,
                         const std::string& text, Span channel_span, Span sample_span) {
    if (!files.empty()) return monitoring.check(*one.plant, channel, number, text, channel_span, sample_span);
    diagnostics_
        .error(grammar::channel_without_monitor, channel_span,
               "no file of monitors is given, and nothing reads channel " + channel_name(channel))
        .suggestion = "name it on the command line, `--monitors FILE.mon`, or in the set of rmpl.toml";
  };
  for (const Sampled& one : sampled_) {
    if (one.plant == nullptr) continue;  // reported
    if (one.scenario) document_.scenarios[*one.scenario].monitors = monitoring.of(*one.plant);
    if (one.definition == nullptr) {
      for (const automata::ChannelSample& sample : document_.scenarios[*one.scenario].samples)
        check(one, sample.channel, sample.number ? sample.number : number_in(sample.text), sample.text, one.blame,
              one.blame);
      continue;
    }
    for (const grammar::ScenarioItem& item : one.definition->items) {
      const auto* event = std::get_if<grammar::ChannelEvent>(&item);
      if (event == nullptr) continue;
      const auto* number = std::get_if<grammar::Number>(&event->sample);
      const auto* text = std::get_if<grammar::String>(&event->sample);
      check(one, event->channel.text, number != nullptr ? std::optional(number->value) : number_in(text->text),
            number != nullptr ? number->text : text->text, event->channel.span,
            number != nullptr ? number->span : text->span);
    }
  }
}

}  // namespace rmpl::compiler
