// Whole `.mon` files (grammar/mon.ebnf).
// SPDX-License-Identifier: MIT
#include "grammar/parse/monitor_rule.hpp"

namespace rmpl::grammar {
namespace {

const Rule<struct BandId, BandText> band{"limits"};
const Rule<struct LiteralsId, LiteralsText> literals{"what the channel says"};
const Rule<struct HysteresisId, HysteresisText> hysteresis{"`hysteresis`"};
const Rule<struct PersistId, PersistText> persist{"`persist`"};
const Rule<struct StaleId, StaleText> stale{"`stale`"};
const Rule<struct UnfinishedId, BandText> unfinished{"a value"};
const Rule<struct MonitorId, MonitorDefinition> monitor{"a channel"};

// A value may be called `persist`: what follows tells.
constexpr auto kind = &BandText::kind;
using Kind = BandText::Kind;
const auto one_limit = (set<kind, Kind::below>[Keyword("below")] | set<kind, Kind::above>[Keyword("above")]) >>
                       x3::expect[field<&BandText::limit>[signed_number]];
const auto two_limits = field<&BandText::limit>[signed_number] >>
                        Keyword("to") >> x3::expect[field<&BandText::upper>[signed_number]];
const auto band_def = record[field<&BandText::value>[value] >> (one_limit | two_limits) > semicolon];
const auto literals_def =
    record[field<&LiteralsText::value>[value] >> equals >
           comma_list(named("a text in double quotes or a number",
                            append<&LiteralsText::literals>[string] | append<&LiteralsText::literals>[signed_number])) >
           named("`,` or `;`", semicolon)];
const auto hysteresis_def = record[Keyword("hysteresis") >> field<&HysteresisText::by>[signed_number] > semicolon];
const auto persist_def = record[Keyword("persist") >> field<&PersistText::amount>[duration] > semicolon];
const auto stale_def = record[Keyword("stale") >> Keyword("after") > field<&StaleText::after>[duration] > semicolon];
// What begins like a value, and is none of the above, ends here.
const auto unfinished_def =
    record[field<&BandText::value>[value] > named("`below`, `above`, `=` or limits, `1 to 2`", Missing("limits"))];

constexpr auto items = &MonitorDefinition::items;
const auto monitor_def =
    record[Keyword("channel") > field<&MonitorDefinition::channel>[string] >
           -((Symbol("-") > field<&MonitorDefinition::minus>[string]) |
             (Keyword("rate") > Keyword("over") > field<&MonitorDefinition::over>[duration])) >
           named("`-`, `rate over` or `:`", colon) > field<&MonitorDefinition::attribute>[name] >
           statements_in_braces("a value with its limits, `hysteresis`, `persist` or `stale after`",
                                append<items>[band] | append<items>[literals] | append<items>[hysteresis] |
                                    append<items>[persist] | append<items>[stale] | append<items>[unfinished])];

const auto monitor_file_def = record[statements_of_file("`channel`", append<&MonitorFile::monitors>[monitor])];

BOOST_SPIRIT_DEFINE(band, literals, hysteresis, persist, stale, unfinished, monitor)

}  // namespace

BOOST_SPIRIT_DEFINE(monitor_file)
BOOST_SPIRIT_INSTANTIATE(decltype(monitor_file), Iterator, Context)

}  // namespace rmpl::grammar
