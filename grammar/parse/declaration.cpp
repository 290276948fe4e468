// Declarations that several languages share.
// SPDX-License-Identifier: MIT
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

const auto import_def = record[Keyword("import") > field<&Import::path>[string] > semicolon];

const auto values_def =
    record[open_brace > comma_list(append<&Values::names>[value]) > named("`,` or `}`", close_brace)];

const auto domain_def =
    record[Keyword("domain") >> field<&Domain::name>[name] > equals > field<&Domain::values>[values] > semicolon];

const auto observe_def =
    record[statement("observe") > comma_list(append<&Observe::names>[name]) > named("`,` or `;`", semicolon)];

const auto control_def =
    record[statement("control") > comma_list(append<&Control::names>[name]) >>
           -(Keyword("default") > field<&Control::idle>[value]) > named("`,`, `default` or `;`", semicolon)];

const auto requirement_def = record[requirement_tags<&RequirementPart::tags>() > named("`,` or `;`", semicolon)];

}  // namespace

BOOST_SPIRIT_DEFINE(import, domain, values, observe, control, requirement)
BOOST_SPIRIT_INSTANTIATE(decltype(import), Iterator, Context)
BOOST_SPIRIT_INSTANTIATE(decltype(domain), Iterator, Context)
BOOST_SPIRIT_INSTANTIATE(decltype(values), Iterator, Context)
BOOST_SPIRIT_INSTANTIATE(decltype(observe), Iterator, Context)
BOOST_SPIRIT_INSTANTIATE(decltype(control), Iterator, Context)
BOOST_SPIRIT_INSTANTIATE(decltype(requirement), Iterator, Context)

}  // namespace rmpl::grammar
