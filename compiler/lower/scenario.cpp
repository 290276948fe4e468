// Scenarios: times, events, rules and expectations over a plant.
// SPDX-License-Identifier: MIT
#include "compiler/lower/scenario.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/overloaded.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lower/requirements.hpp"
#include "compiler/lower/scenario_names.hpp"
#include "compiler/lower/timing.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::Ticks;
using automata::VariableId;
using grammar::Code;

namespace {

class ScenarioLowering {
 public:
  ScenarioLowering(const grammar::Sources& sources, const Part* plant, grammar::Diagnostics& diagnostics)
      : sources_(sources), diagnostics_(diagnostics) {
    if (plant != nullptr) names_.emplace(*plant, diagnostics);
  }

  automata::Scenario run(const grammar::ScenarioDefinition& definition) {
    scenario_.name = definition.name.text;
    scenario_.origin = origin_of(sources_, definition.span);
    set_frame(definition);
    for (const grammar::ScenarioItem& item : definition.items) {
      std::visit([&](const auto& part) { add(part); }, item);
    }
    return std::move(scenario_);
  }

 private:
  /// Cycle, duration, seed and the kind of plant come first: other parts are judged by them.
  void set_frame(const grammar::ScenarioDefinition& definition) {
    const grammar::Span* cycle = nullptr;
    const grammar::Span* duration = nullptr;
    const grammar::Span* seed = nullptr;
    for (const grammar::ScenarioItem& item : definition.items) {
      std::visit(base::Overloaded{[&](const grammar::CyclePart& part) {
                                    const auto period = ticks_of(part.period, diagnostics_);
                                    if (!once(part.span, cycle, "cycle") || !period) return;
                                    if (*period == Ticks{0}) report_cycle(part.period.span);
                                    scenario_.cycle = *period;
                                  },
                                  [&](const grammar::DurationPart& part) {
                                    const auto length = ticks_of(part.duration, diagnostics_);
                                    if (once(part.span, duration, "duration") && length) scenario_.duration = *length;
                                  },
                                  [&](const grammar::PlantPart& part) { scenario_.rules_only = part.rules_only; },
                                  [&](const grammar::SeedPart& part) {
                                    if (once(part.span, seed, "seed")) scenario_.seed = part.seed;
                                  },
                                  [&](const grammar::RequirementPart& part) {
                                    for (std::string& tag : fresh_tags(part.tags, tagged_, diagnostics_)) {
                                      scenario_.requirements.push_back(std::move(tag));
                                    }
                                  },
                                  [](const auto&) {}},
                 item);
    }
  }

  bool once(const grammar::Span& span, const grammar::Span*& first, const char* what) {
    if (first == nullptr) {
      first = &span;
      return true;
    }
    auto& error = diagnostics_.error(Code::scenario_repeated_part, span, std::string("a second ") + what);
    error.notes.push_back({*first, "the first is here"});
    return false;
  }

  /// Where the plant follows the rules only, it has readings and nothing behind them.
  void report_no_truth(grammar::Span span, const std::string& what, const std::string& instead) {
    if (!scenario_.rules_only) return;
    diagnostics_
        .error(Code::scenario_without_truth, span, what + ", but this plant has no modes: it is declared `rules only`")
        .suggestion = instead;
  }

  void report_cycle(grammar::Span span) {
    diagnostics_.error(Code::scenario_finer_than_cycle, span, "the cycle is 0, expected a longer time");
  }

  void add(const grammar::ProgramPart&) {}
  void add(const grammar::CyclePart&) {}
  void add(const grammar::DurationPart&) {}
  void add(const grammar::SeedPart&) {}
  void add(const grammar::PlantPart&) {}
  void add(const grammar::RequirementPart&) {}

  void add(const grammar::TruthPart& part) {
    report_no_truth(part.span, "`truth` sets modes of the plant",
                    "leave it out: the estimate starts with the initial modes of the plant");
    for (const grammar::AssignmentText& text : part.modes) {
      const auto mode = names_ ? names_->start_mode(text) : std::nullopt;
      if (!mode) continue;
      const auto [first, fresh] = truths_.emplace(mode->variable, text.span);
      if (fresh) {
        scenario_.truth.push_back(*mode);
        continue;
      }
      auto& error = diagnostics_.error(Code::scenario_repeated_part, text.span,
                                       "the initial mode of " + backquoted(text.variable.text) + " is given twice");
      error.notes.push_back({first->second, "the first is here"});
    }
  }

  void add(const grammar::FaultEvent& event) {
    report_no_truth(event.span, "a fault sets a mode of the plant",
                    "give the readings that would show the fault: `at … observe x = v`");
    const auto at = time_of(event.at, event.span);
    auto forced = names_ ? names_->fault(event.mode) : std::nullopt;
    if (!at || !forced) return;
    forced->at = *at;
    forced->origin = origin_of(sources_, event.span);
    scenario_.forced.push_back(std::move(*forced));
  }

  void add(const grammar::ObserveEvent& event) {
    const auto at = time_of(event.at, event.span);
    const auto length = event.duration ? ticks_of(*event.duration, diagnostics_) : Ticks::infinite();
    const auto reading = names_ ? names_->reading(event.reading) : std::nullopt;
    if (!at || !length || !reading) return;
    scenario_.overrides.push_back({*at, *length, *reading, origin_of(sources_, event.span)});
  }

  void add(const grammar::CommandEvent& event) {
    const auto at = time_of(event.at, event.span);
    const auto length = event.duration ? ticks_of(*event.duration, diagnostics_) : scenario_.cycle;
    const auto command = names_ ? names_->command(event.command) : std::nullopt;
    if (!at || !length || !command) return;
    scenario_.commands.push_back({*at, *length, *command, origin_of(sources_, event.span)});
  }

  /// What the channel means is not known here: monitors are an input of their own.
  void add(const grammar::ChannelEvent& event) {
    const auto at = time_of(event.at, event.span);
    if (!at) return;
    const auto [first, fresh] = sampled_.emplace(std::pair(event.channel.text, *at), event.span);
    if (!fresh) {
      auto& error = diagnostics_.error(
          Code::scenario_repeated_part, event.span,
          "a second sample of channel \"" + event.channel.text + "\" at " + automata::format_seconds(*at) + " s");
      error.notes.push_back({first->second, "the first is here"});
      return;
    }
    automata::ChannelSample sample{*at, event.channel.text, std::nullopt, {}, origin_of(sources_, event.span)};
    std::visit(base::Overloaded{[&](const grammar::String& text) { sample.text = text.text; },
                                [&](const grammar::Number& number) {
                                  sample.number = number.value;
                                  sample.text = number.text;
                                }},
               event.sample);
    scenario_.samples.push_back(std::move(sample));
  }

  void add(const grammar::RuleText& text) {
    const bool command = text.stream == grammar::RuleText::Stream::command;
    automata::Rule rule;
    rule.stream = command ? automata::Rule::Stream::command : automata::Rule::Stream::estimate;
    rule.origin = origin_of(sources_, text.span);
    if (text.delay) {
      if (const auto* cycles = std::get_if<grammar::Cycles>(&*text.delay)) rule.delay_cycles = cycles->count;
      if (const auto* delay = std::get_if<grammar::Duration>(&*text.delay)) rule.delay = ticks_of(*delay, diagnostics_);
    }
    const auto length = text.duration ? ticks_of(*text.duration, diagnostics_) : Ticks::infinite();
    if (names_) names_->ask_of_knowledge("in a rule: a rule describes the plant");
    const auto trigger = condition(text.trigger);
    const auto reading = names_ ? names_->reading(text.reading) : std::nullopt;
    if (trigger) names_->check_trigger(*trigger, command, text.trigger);
    if (!length || !trigger || !reading) return;
    rule.trigger = *trigger;
    rule.reading = *reading;
    rule.duration = *length;
    scenario_.rules.push_back(std::move(rule));
  }

  void add(const grammar::ExpectText& text) {
    if (text.truth)
      report_no_truth(text.span, "`expect truth` reads modes of the plant", "expect the estimate: leave out `truth`");
    automata::Expectation expectation;
    switch (text.kind) {
      case grammar::ExpectText::Kind::eventually:
        expectation.kind = automata::Expectation::Kind::eventually;
        break;
      case grammar::ExpectText::Kind::never:
        expectation.kind = automata::Expectation::Kind::never;
        break;
      case grammar::ExpectText::Kind::finished:
        expectation.kind = automata::Expectation::Kind::finished;
        break;
      case grammar::ExpectText::Kind::never_finished:
        expectation.kind = automata::Expectation::Kind::never_finished;
        break;
      case grammar::ExpectText::Kind::goal_conflict:
        expectation.kind = automata::Expectation::Kind::goal_conflict;
        break;
      case grammar::ExpectText::Kind::no_plan:
        expectation.kind = automata::Expectation::Kind::no_plan;
        break;
    }
    expectation.truth = text.truth;
    expectation.origin = origin_of(sources_, text.span);
    expectation.text = written(text);
    if (text.requirement) {
      TagPlaces tagged = tagged_;
      expectation.requirements = fresh_tags(text.requirement->tags, tagged, diagnostics_);
    }
    if (text.within) expectation.within = deadline_of(*text.within, text.span);
    if (names_) {
      names_->ask_of_knowledge(text.truth ? std::optional<std::string>("in `expect truth`: it reads the plant")
                                          : std::nullopt);
    }
    if (text.condition) {
      if (auto formula = condition(*text.condition)) expectation.condition = std::move(*formula);
    }
    if (text.after) expectation.after = condition(*text.after);
    scenario_.expectations.push_back(std::move(expectation));
  }

  /// What stands between `expect` and `;`, or the requirements.
  std::string written(const grammar::ExpectText& expectation) {
    constexpr std::string_view keyword = "expect";
    constexpr std::string_view space = " \t\r\n";
    grammar::Span span = expectation.span;
    if (expectation.requirement) span.end = expectation.requirement->span.begin;
    std::string_view text = sources_.text(span);
    if (text.substr(0, keyword.size()) == keyword) text.remove_prefix(keyword.size());
    if (!text.empty() && text.back() == ';') text.remove_suffix(1);
    const auto first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(space) - first + 1));
  }

  std::optional<Formula> condition(const grammar::Constraint& constraint) {
    return names_ ? names_->condition(constraint) : std::nullopt;
  }

  /// A time of an event; one behind the end of the scenario gets a warning, since the event never comes.
  std::optional<Ticks> time_of(const grammar::Duration& at, grammar::Span event) {
    const auto ticks = ticks_of(at, diagnostics_);
    if (ticks) warn_behind_end(*ticks, event, "this happens");
    return ticks;
  }

  /// A deadline; one behind the end of the scenario gets a warning, since it is judged before.
  std::optional<Ticks> deadline_of(const grammar::Duration& within, grammar::Span expectation) {
    const auto ticks = ticks_of(within, diagnostics_);
    if (ticks)
      warn_behind_end(*ticks, expectation,
                      "the " + automata::format_seconds(*ticks) + " s of this expectation have passed");
    return ticks;
  }

  void warn_behind_end(Ticks time, grammar::Span span, const std::string& what) {
    if (time <= scenario_.duration) return;
    diagnostics_.warning(
        Code::scenario_after_end, span,
        "the scenario ends after " + automata::format_seconds(scenario_.duration) + " s, before " + what);
  }

  const grammar::Sources& sources_;
  grammar::Diagnostics& diagnostics_;
  std::optional<ScenarioNames> names_;  ///< none where there is no plant
  automata::Scenario scenario_;
  std::unordered_map<VariableId, grammar::Span> truths_;  ///< initial modes that are given, and where
  TagPlaces tagged_;                                      ///< requirements of the scenario as a whole
  std::map<std::pair<std::string, Ticks>, grammar::Span> sampled_;
};

}  // namespace

ScenarioFiles files_of(const grammar::ScenarioDefinition& definition, grammar::Diagnostics& diagnostics) {
  ScenarioFiles files;
  const auto take = [&](const auto& part, auto& place, const char* what) {
    if (place == nullptr) {
      place = &part;
      return;
    }
    auto& error = diagnostics.error(Code::scenario_repeated_part, part.span, std::string("a second ") + what);
    error.notes.push_back({place->span, "the first is here"});
  };
  for (const grammar::ScenarioItem& item : definition.items) {
    if (const auto* program = std::get_if<grammar::ProgramPart>(&item)) take(*program, files.program, "program");
    if (const auto* plant = std::get_if<grammar::PlantPart>(&item)) take(*plant, files.plant, "plant");
  }
  const auto require = [&](const void* part, const std::string& what, const std::string& fix) {
    if (part != nullptr) return;
    auto& error = diagnostics.error(Code::scenario_missing_part, definition.name.span,
                                    "scenario \"" + definition.name.text + "\" names no " + what);
    error.suggestion = "add " + fix;
  };
  require(files.program, "program", "`program \"….rmpl\";`");
  require(files.plant, "plant", "`plant \"….tcca\";`");
  return files;
}

automata::Scenario lower_scenario(const grammar::Sources& sources, const grammar::ScenarioDefinition& definition,
                                  const Part* plant, grammar::Diagnostics& diagnostics) {
  return ScenarioLowering(sources, plant, diagnostics).run(definition);
}

}  // namespace rmpl::compiler
