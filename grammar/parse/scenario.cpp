// Whole `.scn` files (language.md "Scenarios").
// SPDX-License-Identifier: MIT
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

const Rule<struct ProgramPartId, ProgramPart> program_part{"`program`"};
const Rule<struct PlantPartId, PlantPart> plant_part{"`plant`"};
const Rule<struct CyclePartId, CyclePart> cycle_part{"`cycle`"};
const Rule<struct DurationPartId, DurationPart> duration_part{"`duration`"};
const Rule<struct SeedPartId, SeedPart> seed_part{"`seed`"};
const Rule<struct TruthPartId, TruthPart> truth_part{"`truth`"};
const Rule<struct FaultEventId, FaultEvent> fault_event{"`fault`"};
const Rule<struct ObserveEventId, ObserveEvent> observe_event{"`observe`"};
const Rule<struct CommandEventId, CommandEvent> command_event{"`command`"};
const Rule<struct ChannelEventId, ChannelEvent> channel_event{"`channel`"};
const Rule<struct CyclesId, Cycles> cycles{"a number of cycles"};
const Rule<struct RuleId, RuleText> rule{"a rule"};
const Rule<struct RequirementClauseId, RequirementPart> requirement_clause{"`requirement`"};
const Rule<struct ExpectId, ExpectText> expectation{"an expectation"};
const Rule<struct ScenarioId, ScenarioDefinition> scenario{"a scenario"};

const auto program_part_def =
    record[Keyword("program") > field<&ProgramPart::path>[string] >
           -(Keyword("main") > field<&ProgramPart::main>[name]) > named("`main` or `;`", semicolon)];

const auto plant_part_def =
    record[Keyword("plant") > field<&PlantPart::path>[string] > -(Keyword("main") > field<&PlantPart::main>[name]) >
           -(set<&PlantPart::rules_only, true>[Keyword("rules")] > Keyword("only")) >
           named("`main`, `rules only` or `;`", semicolon)];

const auto cycle_part_def = record[Keyword("cycle") > field<&CyclePart::period>[duration] > semicolon];
const auto duration_part_def = record[Keyword("duration") > field<&DurationPart::duration>[duration] > semicolon];
const auto seed_part_def = record[Keyword("seed") > field<&SeedPart::seed>[whole_number] > semicolon];
const auto truth_part_def =
    record[Keyword("truth") > comma_list(append<&TruthPart::modes>[assignment]) > named("`,` or `;`", semicolon)];

const auto fault_event_def = record[Keyword("at") >> field<&FaultEvent::at>[duration] >> Keyword("fault") >
                                    field<&FaultEvent::mode>[assignment] > semicolon];

const auto command_event_def =
    record[Keyword("at") >> field<&CommandEvent::at>[duration] >> Keyword("command") >
           field<&CommandEvent::command>[assignment] > -(Keyword("for") > field<&CommandEvent::duration>[duration]) >
           named("`for` or `;`", semicolon)];

const auto channel_event_def =
    record[Keyword("at") >> field<&ChannelEvent::at>[duration] >> Keyword("channel") >
           field<&ChannelEvent::channel>[string] > equals >
           named("a number or a text in double quotes",
                 field<&ChannelEvent::sample>[string] | field<&ChannelEvent::sample>[signed_number]) > semicolon];

const auto observe_event_def =
    record[Keyword("at") > field<&ObserveEvent::at>[duration] >
           named("`fault`, `observe`, `command` or `channel`", Keyword("observe")) >
           field<&ObserveEvent::reading>[assignment] > -(Keyword("for") > field<&ObserveEvent::duration>[duration]) >
           named("`for` or `;`", semicolon)];

const auto cycles_def = record[field<&Cycles::count>[whole_number] >> (Keyword("cycles") | Keyword("cycle"))];

constexpr auto stream = &RuleText::stream;
const auto rule_def =
    record[Keyword("when") >
           named("`command` or `estimate`", set<stream, RuleText::Stream::command>[Keyword("command")] |
                                                set<stream, RuleText::Stream::estimate>[Keyword("estimate")]) >
           field<&RuleText::trigger>[constraint] >
           -(Keyword("after") > named("a number of cycles or a duration",
                                      field<&RuleText::delay>[cycles] | field<&RuleText::delay>[duration])) >
           named("`after` or `observe`", Keyword("observe")) > field<&RuleText::reading>[assignment] >
           -(Keyword("for") > field<&RuleText::duration>[duration]) > named("`for` or `;`", semicolon)];

// `truth`, `never`, `finished` and what is never to come may also be variables: then a relation follows.
constexpr auto kind = &ExpectText::kind;
const auto requirement_clause_def = record[requirement_tags<&RequirementPart::tags>()];
const auto within = Keyword("within") > field<&ExpectText::within>[duration];
const auto after = Keyword("after") > field<&ExpectText::after>[constraint];
const auto condition = x3::expect[field<&ExpectText::condition>[constraint]] >>
                       -((within >> -after) | (after >> -within));
const auto tags = field<&ExpectText::requirement>[requirement_clause];
const auto expectation_def =
    record[Keyword("expect") >> -set<&ExpectText::truth, true>[Keyword("truth") >> !relation] >>
           (((set<kind, ExpectText::Kind::finished>[Keyword("finished") >> !relation] |
              set<kind, ExpectText::Kind::never_finished>[Keyword("never") >> Keyword("finished") >> !relation]) >>
             -(Keyword("with") > field<&ExpectText::condition>[constraint]) >> -within >> -tags >
             named("`with`, `within`, `requirement` or `;`", semicolon)) |
            ((set<kind, ExpectText::Kind::goal_conflict>[Keyword("never") >> Keyword("goal-conflict") >> !relation] |
              set<kind, ExpectText::Kind::no_plan>[Keyword("never") >> Keyword("no-plan") >> !relation]) >>
             -tags > named("`requirement` or `;`", semicolon)) |
            (((set<kind, ExpectText::Kind::never>[Keyword("never") >> !relation] >> condition) | condition) >> -tags >
             named("`within`, `after`, `requirement` or `;`", semicolon)))];

constexpr auto items = &ScenarioDefinition::items;
const auto scenario_def =
    record[Keyword("scenario") > field<&ScenarioDefinition::name>[string] >
           statements_in_braces(
               "`program`, `plant`, `cycle`, `duration`, `seed`, `truth`, `requirement`, `at`, `when` or `expect`",
               append<items>[program_part] | append<items>[plant_part] | append<items>[cycle_part] |
                   append<items>[duration_part] | append<items>[seed_part] | append<items>[truth_part] |
                   append<items>[fault_event] | append<items>[command_event] | append<items>[channel_event] |
                   append<items>[observe_event] | append<items>[rule] | append<items>[expectation] |
                   append<items>[requirement])];

const auto scenario_file_def = record[statements_of_file("`scenario`", append<&ScenarioFile::scenarios>[scenario])];

BOOST_SPIRIT_DEFINE(program_part, plant_part, cycle_part, duration_part, seed_part, truth_part)
BOOST_SPIRIT_DEFINE(fault_event, command_event, channel_event, observe_event, cycles, rule, requirement_clause,
                    expectation, scenario)

}  // namespace

BOOST_SPIRIT_DEFINE(scenario_file)
BOOST_SPIRIT_INSTANTIATE(decltype(scenario_file), Iterator, Context)

}  // namespace rmpl::grammar
