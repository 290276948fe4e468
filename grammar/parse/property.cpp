// Whole `.props` files (grammar/props.ebnf).
// SPDX-License-Identifier: MIT
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

const Rule<struct NeverClaimId, NeverClaim> never_claim{"`never`"};
const Rule<struct ReachClaimId, ReachClaim> reach_claim{"`reach`"};
const Rule<struct ResponseClaimId, ResponseClaim> response_claim{"`after`"};
const Rule<struct FaultsSettingId, FaultsSetting> faults_setting{"`faults`"};
const Rule<struct TimeSettingId, TimeSetting> time_setting{"`time`"};
const Rule<struct CommandsSettingId, CommandsSetting> commands_setting{"`commands`"};
const Rule<struct FromSettingId, FromSetting> from_setting{"`from`"};
const Rule<struct EntailedSettingId, EntailedSetting> entailed_setting{"`entailed`"};
const Rule<struct ExpectedVerdictId, ExpectedVerdict> expected_verdict{"`expect`"};
const Rule<struct PropertyId, PropertyDefinition> property{"a property"};

const auto never_claim_def = record[Keyword("never") > field<&NeverClaim::constraint>[constraint] > semicolon];
const auto reach_claim_def = record[Keyword("reach") > field<&ReachClaim::constraint>[constraint] > semicolon];
const auto response_claim_def =
    record[Keyword("after") > field<&ResponseClaim::after>[constraint] > Keyword("within") >
           field<&ResponseClaim::within>[duration] > field<&ResponseClaim::then>[constraint] > semicolon];

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
const auto expected_verdict_def =
    record[Keyword("expect") > named("`holds` or `violated`",
                                     Keyword("holds") | set<&ExpectedVerdict::violated, true>[Keyword("violated")]) >
           semicolon];

constexpr auto items = &PropertyDefinition::items;
const auto property_def =
    record[Keyword("property") > field<&PropertyDefinition::name>[string] >
           statements_in_braces(
               "`never`, `reach`, `after`, `faults`, `time`, `commands`, `from`, `entailed` or `expect`",
               append<items>[never_claim] | append<items>[reach_claim] | append<items>[response_claim] |
                   append<items>[faults_setting] | append<items>[time_setting] | append<items>[commands_setting] |
                   append<items>[from_setting] | append<items>[entailed_setting] | append<items>[expected_verdict])];

constexpr auto defaults = &PropertyFile::defaults;
const auto property_file_def = record[statements_of_file(
    "`property` or a setting for all (`faults`, `time`, `commands`, `from`, `entailed`)",
    append<&PropertyFile::properties>[property] | append<defaults>[faults_setting] | append<defaults>[time_setting] |
        append<defaults>[commands_setting] | append<defaults>[from_setting] | append<defaults>[entailed_setting])];

BOOST_SPIRIT_DEFINE(never_claim, reach_claim, response_claim, faults_setting, time_setting, commands_setting)
BOOST_SPIRIT_DEFINE(from_setting, entailed_setting, expected_verdict, property)

}  // namespace

BOOST_SPIRIT_DEFINE(property_file)
BOOST_SPIRIT_INSTANTIATE(decltype(property_file), Iterator, Context)

}  // namespace rmpl::grammar
