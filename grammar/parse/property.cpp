// Whole `.props` files (grammar/props.ebnf).
// SPDX-License-Identifier: MIT
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

const Rule<struct NeverClaimId, NeverClaim> never_claim{"`never`"};
const Rule<struct ReachClaimId, ReachClaim> reach_claim{"`reach`"};
const Rule<struct ResponseClaimId, ResponseClaim> response_claim{"`after`"};
const Rule<struct EventuallyClaimId, EventuallyClaim> eventually_claim{"`program eventually`"};
const Rule<struct FinallyClaimId, FinallyClaim> finally_claim{"`program finally`"};
const Rule<struct ProbabilityClaimId, ProbabilityClaim> probability_claim{"`probability of`"};
const Rule<struct GeneralClaimId, GeneralClaim> general_claim{"`program`"};
const Rule<struct FaultsSettingId, FaultsSetting> faults_setting{"`faults`"};
const Rule<struct TimeSettingId, TimeSetting> time_setting{"`time`"};
const Rule<struct CommandsSettingId, CommandsSetting> commands_setting{"`commands`"};
const Rule<struct FromSettingId, FromSetting> from_setting{"`from`"};
const Rule<struct EntailedSettingId, EntailedSetting> entailed_setting{"`entailed`"};
const Rule<struct AllowStuckSettingId, AllowStuckSetting> allow_stuck_setting{"`allow-stuck`"};
const Rule<struct ExpectedVerdictId, ExpectedVerdict> expected_verdict{"`expect`"};
const Rule<struct SeveritySettingId, SeveritySetting> severity_setting{"`severity`"};
const Rule<struct PropertyId, PropertyDefinition> property{"a property"};
const Rule<struct HazardId, PropertyDefinition> hazard{"a hazard"};

const Keyword program{"program"};
const auto never_claim_def = record[-set<&NeverClaim::of_program, true>[program] >> Keyword("never") >
                                    field<&NeverClaim::constraint>[constraint] > semicolon];
const auto reach_claim_def = record[Keyword("reach") > field<&ReachClaim::constraint>[constraint] > semicolon];
const auto response_claim_def =
    record[-set<&ResponseClaim::of_program, true>[program] >> Keyword("after") >
           field<&ResponseClaim::after>[constraint] > Keyword("within") > field<&ResponseClaim::within>[bound] >
           field<&ResponseClaim::then>[constraint] > semicolon];
const auto eventually_claim_def =
    record[program >> Keyword("eventually") > field<&EventuallyClaim::constraint>[constraint] > Keyword("within") >
           field<&EventuallyClaim::within>[bound] > semicolon];

const auto probability_claim_def =
    record[-set<&ProbabilityClaim::of_program, true>[program] >> Keyword("probability") > Keyword("of") >
           field<&ProbabilityClaim::constraint>[constraint] >
           -(Keyword("within") > field<&ProbabilityClaim::within>[bound]) > named("`within` or `at`", Keyword("at")) >
           named("`most` or `least`", Keyword("most") | set<&ProbabilityClaim::at_least, true>[Keyword("least")]) >
           field<&ProbabilityClaim::bound>[signed_number] > semicolon];

constexpr auto kind = &GeneralClaim::kind;
using Kind = GeneralClaim::Kind;
const auto never_stuck = Keyword("never") >> set<kind, Kind::stuck>[Keyword("stuck")] >> semicolon;
const auto never_held_up = Keyword("never") >> (set<kind, Kind::goal_conflict>[Keyword("goal-conflict")] |
                                                set<kind, Kind::no_plan>[Keyword("no-plan")] |
                                                set<kind, Kind::endless_wait>[Keyword("endless-wait")] |
                                                set<kind, Kind::undone>[Keyword("undone")]) >>
                           semicolon;
const auto terminates = set<kind, Kind::termination>[Keyword("terminates")] > semicolon;
// A component may be called `stuck`.
const auto general_claim_def =
    record[never_stuck | (set<&GeneralClaim::of_program, true>[program] >> (never_stuck | never_held_up | terminates))];
// The last of the claims on a program: what begins like one and is none of the others ends here.
const auto finally_claim_def =
    record[program > named("`terminates`, `never`, `eventually`, `finally` or `after`", Keyword("finally")) >
           field<&FinallyClaim::constraint>[constraint] > semicolon];

const auto faults_setting_def = record[Keyword("faults") > field<&FaultsSetting::count>[whole_number] > semicolon];
const auto time_setting_def =
    record[Keyword("time") > named("`dense` or a period", Keyword("dense") | field<&TimeSetting::period>[duration]) >
           semicolon];

constexpr auto freedom = &CommandsSetting::freedom;
using Freedom = CommandsSetting::Freedom;
const auto commands_setting_def =
    record[Keyword("commands") > named("`none`, `one` or `any`", set<freedom, Freedom::none>[Keyword("none")] |
                                                                     set<freedom, Freedom::one>[Keyword("one")] |
                                                                     set<freedom, Freedom::any>[Keyword("any")]) >
           semicolon];

const auto from_setting_def =
    record[Keyword("from") > comma_list(append<&FromSetting::modes>[assignment]) > named("`,` or `;`", semicolon)];
const auto entailed_setting_def = record[Keyword("entailed") > semicolon];
const auto allow_stuck_setting_def = record[Keyword("allow-stuck") > semicolon];

constexpr auto severity = &SeveritySetting::severity;
using Severity = SeveritySetting::Severity;
const auto severity_setting_def =
    record[Keyword("severity") > named("`catastrophic`, `critical`, `major` or `minor`",
                                       set<severity, Severity::catastrophic>[Keyword("catastrophic")] |
                                           set<severity, Severity::critical>[Keyword("critical")] |
                                           set<severity, Severity::major>[Keyword("major")] |
                                           set<severity, Severity::minor>[Keyword("minor")]) > semicolon];
const auto expected_verdict_def =
    record[Keyword("expect") > named("`holds` or `violated`",
                                     Keyword("holds") | set<&ExpectedVerdict::violated, true>[Keyword("violated")]) >
           semicolon];

constexpr auto items = &PropertyDefinition::items;
const auto in_braces = statements_in_braces(
    "`never`, `reach`, `after`, `probability`, `program`, `faults`, `time`, `commands`, `from`, `entailed`, "
    "`allow-stuck`, `severity`, `requirement` or `expect`",
    append<items>[general_claim] | append<items>[never_claim] | append<items>[reach_claim] |
        append<items>[response_claim] | append<items>[eventually_claim] | append<items>[probability_claim] |
        append<items>[finally_claim] | append<items>[faults_setting] | append<items>[time_setting] |
        append<items>[commands_setting] | append<items>[from_setting] | append<items>[entailed_setting] |
        append<items>[allow_stuck_setting] | append<items>[severity_setting] | append<items>[expected_verdict] |
        append<items>[requirement]);
const auto property_def = record[Keyword("property") > field<&PropertyDefinition::name>[string] > in_braces];
const auto hazard_def =
    record[set<&PropertyDefinition::hazard, true>[Keyword("hazard")] > field<&PropertyDefinition::name>[string] >
           named("`{`, `never` or `probability of`",
                 in_braces | (set<&PropertyDefinition::braces, false>[append<items>[never_claim] |
                                                                      append<items>[probability_claim]] >
                              -append<items>[severity_setting] >> -append<items>[requirement]))];

constexpr auto defaults = &PropertyFile::defaults;
const auto property_file_def = record[statements_of_file(
    "`property`, `hazard` or a setting for all (`faults`, `time`, `commands`, `from`, `entailed`, `allow-stuck`)",
    append<&PropertyFile::properties>[property] | append<&PropertyFile::properties>[hazard] |
        append<defaults>[faults_setting] | append<defaults>[time_setting] | append<defaults>[commands_setting] |
        append<defaults>[from_setting] | append<defaults>[entailed_setting] | append<defaults>[allow_stuck_setting])];

BOOST_SPIRIT_DEFINE(never_claim, reach_claim, response_claim, eventually_claim, finally_claim, general_claim)
BOOST_SPIRIT_DEFINE(probability_claim, severity_setting, hazard)
BOOST_SPIRIT_DEFINE(faults_setting, time_setting, commands_setting, from_setting, entailed_setting)
BOOST_SPIRIT_DEFINE(allow_stuck_setting, expected_verdict, property)

}  // namespace

BOOST_SPIRIT_DEFINE(property_file)
BOOST_SPIRIT_INSTANTIATE(decltype(property_file), Iterator, Context)

}  // namespace rmpl::grammar
