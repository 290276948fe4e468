// Scenarios as written (language.md "Scenarios").
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "grammar/ast/constraint.hpp"
#include "grammar/ast/requirement.hpp"
#include "grammar/ast/token.hpp"

namespace rmpl::grammar {

/// `program "mars_entry.rmpl" main EntrySequence;`
struct ProgramPart {
  Span span;
  String path;
  std::optional<Name> main;
};

/// `plant "mars_lander.tcca" rules only;` or, of a model program, `plant "camera.rmpl" main Camera;`
struct PlantPart {
  Span span;
  String path;
  std::optional<Name> main;
  bool rules_only = false;
};

/// `cycle 0.5 s;`
struct CyclePart {
  Span span;
  Duration period;
};

/// `duration 6 h;`
struct DurationPart {
  Span span;
  Duration duration;
};

/// `seed 7;`, a whole number below 2^64.
struct SeedPart {
  Span span;
  std::uint64_t seed = 0;
};

/// `truth engine = off, lander = connected;`
struct TruthPart {
  Span span;
  std::vector<AssignmentText> modes;
};

/// `at 16498 s fault lander = unsuccessful-attempt;`
struct FaultEvent {
  Span span;
  Duration at;
  AssignmentText mode;
};

/// `at 100 s observe engine.temp = low for 20 s;`
struct ObserveEvent {
  Span span;
  Duration at;
  AssignmentText reading;
  std::optional<Duration> duration;
};

/// `at 100 s command engine.cmd = off for 2 s;`
struct CommandEvent {
  Span span;
  Duration at;
  AssignmentText command;
  std::optional<Duration> duration;
};

/// `at 3 s channel "P1" = 2.7;`, `at 3 s channel "VALVE" = "OPEN";`
struct ChannelEvent {
  Span span;
  Duration at;
  String channel;
  std::variant<String, Number> sample;
};

/// `86 cycles`.
struct Cycles {
  Span span;
  std::uint64_t count = 0;
};

/// `when command engine.cmd = standby after 86 cycles observe engine.temp = nominal for 5 s;`
struct RuleText {
  enum class Stream { command, estimate };
  Span span;
  Stream stream = Stream::command;
  Constraint trigger;
  std::optional<std::variant<Cycles, Duration>> delay;  ///< none: at once
  AssignmentText reading;
  std::optional<Duration> duration;
};

/// `expect [truth] [never] φ [within T] [after ψ] [requirement "R"];`, `expect [never] finished [within T];`
struct ExpectText {
  enum class Kind { eventually, never, finished, never_finished, goal_conflict, no_plan };
  Span span;
  Kind kind = Kind::eventually;
  bool truth = false;
  std::optional<Constraint> condition;  ///< of `finished` and `never finished` perhaps none; of the last two none
  std::optional<Constraint> after;
  std::optional<Duration> within;
  std::optional<RequirementPart> requirement;
};

using ScenarioItem = std::variant<ProgramPart, PlantPart, CyclePart, DurationPart, SeedPart, TruthPart, FaultEvent,
                                  ObserveEvent, CommandEvent, ChannelEvent, RuleText, ExpectText, RequirementPart>;

/// `scenario "name" { … }`
struct ScenarioDefinition {
  Span span;
  String name;
  std::vector<ScenarioItem> items;
};

/// A whole `.scn` file.
struct ScenarioFile {
  std::vector<ScenarioDefinition> scenarios;
};

}  // namespace rmpl::grammar
