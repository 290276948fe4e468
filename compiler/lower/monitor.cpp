// Monitors: names and values looked up, limits compared with each other.
// SPDX-License-Identifier: MIT
#include "compiler/lower/monitor.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/overloaded.hpp"
#include "compiler/check/resolve.hpp"
#include "compiler/lower/part.hpp"
#include "compiler/lower/timing.hpp"
#include "grammar/source/monitor_codes.hpp"

namespace rmpl::compiler {

using automata::Band;
using automata::Monitor;
using grammar::Code;
using grammar::Span;

namespace {

std::string number(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

/// `280 to 340`, `below 280`, `1`.
std::string text_of(const Band& band) {
  if (band.open_to) return "below " + number(band.to);
  if (band.open_from) return "above " + number(band.from);
  return band.from == band.to ? number(band.from) : number(band.from) + " to " + number(band.to);
}

/// Whether numbers belong to both, beyond a limit that they share.
bool overlap(const Band& one, const Band& other) {
  const double from = std::max(one.from, other.from);
  const double to = std::min(one.to, other.to);
  if (from < to) return true;
  const auto is_point = [](const Band& band) { return band.from == band.to; };
  return from == to && (is_point(one) || is_point(other)) && one.contains(from) && other.contains(from);
}

class MonitorLowering {
 public:
  MonitorLowering(const grammar::Sources& sources, const automata::Plant& plant, grammar::Diagnostics& diagnostics)
      : sources_(sources),
        plant_(plant),
        diagnostics_(diagnostics),
        resolver_({plant.variables, nullptr, "plant " + backquoted(plant.name), Code::not_in_plant}, diagnostics) {}

  std::vector<Monitor> run(const grammar::MonitorFile& file, Span start) {
    if (file.monitors.empty()) {
      auto& error = diagnostics_.error(grammar::no_monitor, start, "the file has no channel");
      error.suggestion = "add `channel \"P1\" : pump.pressure { low below 1; ok 1 to 3; }`";
    }
    std::vector<Monitor> result;
    std::map<automata::VariableId, Span> known;
    for (const grammar::MonitorDefinition& definition : file.monitors) {
      const auto attribute = observed(definition.attribute);
      if (attribute) {
        const auto [first, fresh] = known.emplace(*attribute, definition.attribute.span);
        if (!fresh) report_twice(definition.attribute.span, "a second channel of one attribute", first->second);
      }
      result.push_back(lower(definition, attribute));
    }
    return result;
  }

 private:
  void report_twice(Span span, const std::string& what, Span first) {
    diagnostics_.error(grammar::monitor_repeated_part, span, what).notes.push_back({first, "the first is here"});
  }
  void report_limits(Span span, const std::string& what) { diagnostics_.error(grammar::monitor_limits, span, what); }

  std::optional<automata::VariableId> observed(const grammar::Name& name) {
    const auto variable = resolver_.variable(name);
    const auto& all = plant_.observables;
    if (!variable || std::find(all.begin(), all.end(), *variable) != all.end()) return variable;
    const bool mode = plant_.component_of(*variable).has_value();
    auto& error = diagnostics_.error(
        grammar::monitor_not_observed, name.span,
        backquoted(name.text) + (mode ? " is a component, and no sensor reads its mode" : " is not observed"));
    if (!mode) error.suggestion = "declare it in the plant: `observe " + name.text + ";`";
    return std::nullopt;
  }

  std::optional<automata::ValueId> value_of(const grammar::Name& attribute, const grammar::Name& value,
                                            std::optional<automata::VariableId> variable) {
    if (!variable) return std::nullopt;
    const auto assignment = resolver_.assignment(attribute, value);
    return assignment ? std::optional(assignment->value) : std::nullopt;
  }

  Monitor lower(const grammar::MonitorDefinition& definition, std::optional<automata::VariableId> attribute) {
    const std::size_t errors = diagnostics_.error_count();
    monitor_ = {};
    places_.clear();
    monitor_.channel = definition.channel.text;
    monitor_.origin = origin_of(sources_, definition.span);
    if (attribute) monitor_.attribute = *attribute;
    if (definition.minus) monitor_.minus = definition.minus->text;
    if (definition.over) {
      monitor_.over = ticks_of(*definition.over, diagnostics_);
      if (monitor_.over == automata::Ticks{}) report_limits(definition.over->span, "a rate is over more than 0 s");
    }
    std::map<std::size_t, Span> seen;
    for (const grammar::MonitorItem& item : definition.items) {
      const Span span = std::visit([](const auto& part) { return part.span; }, item);
      if (!std::holds_alternative<grammar::BandText>(item) && !std::holds_alternative<grammar::LiteralsText>(item)) {
        const auto [first, fresh] = seen.emplace(item.index(), span);
        if (!fresh) report_twice(span, "a second setting of this kind", first->second);
      }
      std::visit(base::Overloaded{[&](const grammar::BandText& part) { add(definition, part, attribute); },
                                  [&](const grammar::LiteralsText& part) { add(definition, part, attribute); },
                                  [&](const auto& part) { add(part); }},
                 item);
    }
    if (places_.empty()) {
      diagnostics_.error(grammar::no_monitor, definition.channel.span,
                         "the channel gives no value: expected limits, as in `low below 1;`, or `on = \"ON\";`");
    }
    report_overlaps();
    if (attribute && diagnostics_.error_count() == errors) {
      report_gaps();
      report_hysteresis();
      report_missing(definition, plant_.variables[*attribute]);
    }
    bands_.clear();
    texts_.clear();
    return std::move(monitor_);
  }

  void add(const grammar::MonitorDefinition& definition, const grammar::BandText& text,
           std::optional<automata::VariableId> attribute) {
    Band band;
    band.origin = origin_of(sources_, text.span);
    switch (text.kind) {
      case grammar::BandText::Kind::below:
        band.to = text.limit.value;
        band.open_to = true;
        break;
      case grammar::BandText::Kind::above:
        band.from = text.limit.value;
        band.open_from = true;
        break;
      case grammar::BandText::Kind::between:
        band.from = text.limit.value;
        band.to = text.upper ? text.upper->value : band.from;
        if (band.from > band.to) report_limits(text.span, "the first limit is above the second");
        break;
    }
    if (const auto value = value_of(definition.attribute, text.value, attribute)) band.value = *value;
    keep(std::move(band), text.span);
    monitor_.bands.push_back(bands_.back());
  }

  void add(const grammar::MonitorDefinition& definition, const grammar::LiteralsText& text,
           std::optional<automata::VariableId> attribute) {
    if (definition.minus || definition.over) {
      report_limits(text.span, "a difference or a rate is a number: expected limits");
    }
    const auto value = value_of(definition.attribute, text.value, attribute);
    for (const grammar::LiteralText& one : text.literals) {
      automata::ChannelLiteral literal;
      if (value) literal.value = *value;
      Span span{};
      std::visit(base::Overloaded{[&](const grammar::String& said) {
                                    literal.text = said.text;
                                    span = said.span;
                                  },
                                  [&](const grammar::Number& said) {
                                    literal.number = said.value;
                                    span = said.span;
                                  }},
                 one);
      if (literal.number) {
        Band point;
        point.value = literal.value;
        point.from = point.to = *literal.number;
        keep(std::move(point), span);
      } else {
        const auto [first, fresh] = texts_.emplace(literal.text, span);
        if (!fresh) report_twice(span, "the channel says this for two values", first->second);
        places_.push_back(span);
        bands_.emplace_back().from = 1;  // nothing, so that places and bands go together
        bands_.back().to = 0;
      }
      monitor_.literals.push_back(std::move(literal));
    }
  }

  void add(const grammar::HysteresisText& text) {
    monitor_.hysteresis = text.by.value;
    if (text.by.value < 0) report_limits(text.by.span, "a hysteresis is at least 0");
  }

  void add(const grammar::PersistText& text) {
    if (!text.amount.unit.empty()) {
      if (const auto time = ticks_of(text.amount, diagnostics_)) monitor_.persist_time = *time;
      return;
    }
    const std::string& number = text.amount.number;
    std::uint64_t samples = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), samples);
    if (error != std::errc{} || end != number.data() + number.size() || samples == 0) {
      report_limits(text.amount.span, "expected a number of samples from 1, or a duration with its unit");
      return;
    }
    monitor_.persist_samples = samples;
  }

  void add(const grammar::StaleText& text) { monitor_.stale = ticks_of(text.after, diagnostics_); }

  void keep(Band band, Span span) {
    bands_.push_back(std::move(band));
    places_.push_back(span);
  }

  // Lint: most likely meant otherwise.

  /// Numbers between two limits that mean nothing, as between 280 and 281 where whole degrees were thought of.
  void report_gaps() {
    std::vector<std::size_t> sorted;
    for (std::size_t b = 0; b < bands_.size(); ++b) {
      if (bands_[b].from < bands_[b].to) sorted.push_back(b);
    }
    std::stable_sort(sorted.begin(), sorted.end(), [&](auto a, auto b) { return bands_[a].from < bands_[b].from; });
    for (std::size_t s = 1; s < sorted.size(); ++s) {
      const Band& below = bands_[sorted[s - 1]];
      const Band& above = bands_[sorted[s]];
      if (below.to > above.from || (below.to == above.from && !(below.open_to && above.open_from))) continue;
      const std::string where = below.to == above.from
                                    ? "the number " + number(below.to)
                                    : "numbers between " + number(below.to) + " and " + number(above.from);
      auto& finding = diagnostics_.warning(grammar::monitor_gap, places_[sorted[s]], where + " give no reading");
      finding.notes.push_back({places_[sorted[s - 1]], "the limits below the gap are here"});
      finding.suggestion = "let the limits meet: a limit that two values share belongs to the first of them";
    }
  }

  void report_hysteresis() {
    for (std::size_t b = 0; b < bands_.size(); ++b) {
      const double width = bands_[b].to - bands_[b].from;
      if (!(width > 0) || !(monitor_.hysteresis > width)) continue;
      diagnostics_.warning(grammar::monitor_hysteresis, places_[b],
                           "the hysteresis of " + number(monitor_.hysteresis) +
                               " is wider than these limits, which are " + number(width) + " apart");
    }
  }

  void report_missing(const grammar::MonitorDefinition& definition, const automata::Variable& attribute) {
    std::vector<bool> given(attribute.values.size(), false);
    for (const Band& band : monitor_.bands) given[band.value.index()] = true;
    for (const automata::ChannelLiteral& literal : monitor_.literals) given[literal.value.index()] = true;
    std::vector<std::string> missing;
    for (std::size_t v = 0; v < given.size(); ++v) {
      if (!given[v]) missing.push_back(attribute.values[v]);
    }
    if (missing.empty()) return;
    diagnostics_.note(grammar::monitor_value_missing, definition.attribute.span,
                      "the channel never gives " + backquoted(attribute.name) + " the value " + one_of(missing));
  }

  /// Of n bands the n that overlap their neighbours are told, not all pairs: sorted by their lower ends.
  void report_overlaps() {
    std::vector<std::size_t> order;
    for (std::size_t b = 0; b < bands_.size(); ++b) {
      if (bands_[b].from <= bands_[b].to) order.push_back(b);
    }
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return bands_[a].from < bands_[b].from; });
    std::optional<std::size_t> widest;  // of those before, the one that reaches furthest up
    for (const std::size_t b : order) {
      if (widest && overlap(bands_[*widest], bands_[b])) {
        const auto [early, late] = std::minmax(*widest, b);
        diagnostics_
            .error(grammar::monitor_overlap, places_[late],
                   "the limits " + text_of(bands_[late]) + " overlap with others: a number would mean two values")
            .notes.push_back({places_[early], "the others are " + text_of(bands_[early])});
      }
      if (!widest || bands_[b].to >= bands_[*widest].to) widest = b;
    }
  }

  const grammar::Sources& sources_;
  const automata::Plant& plant_;
  grammar::Diagnostics& diagnostics_;
  Resolver resolver_;
  Monitor monitor_;
  std::vector<Band> bands_;   ///< of the monitor, numbers that are said among them
  std::vector<Span> places_;  ///< of each
  std::map<std::string, Span> texts_;
};

}  // namespace

std::vector<Monitor> lower_monitors(const grammar::Sources& sources, const grammar::MonitorFile& file, Span start,
                                    const automata::Plant& plant, grammar::Diagnostics& diagnostics) {
  return MonitorLowering(sources, plant, diagnostics).run(file, start);
}

}  // namespace rmpl::compiler
