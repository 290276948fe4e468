// The transitions of a component (language.md "Plant models").
// SPDX-License-Identifier: MIT
#include "base/nearest.hpp"
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

const Rule<struct AnySourceId, AnySource> any_source{"`any`"};
const Rule<struct NamedSourcesId, NamedSources> named_sources{"modes"};
const Rule<struct SourcesId, TransitionSources> sources{"the modes that a transition leaves"};
const Rule<struct ProbabilityId, ProbabilityWeight> probability{"a probability"};
const Rule<struct RateId, RateWeight> rate{"a rate"};
const Rule<struct DensityId, DensityText> density{"a density"};
const Rule<struct TimingId, TimingText> timing{"a time bound"};
const Rule<struct TargetId, Branch> target{"a mode"};
const Rule<struct BranchId, Branch> branch{"a mode"};

/// The arrow behind the sources. What has none is no transition, if its first word is nearly a keyword.
struct ArrowBehindSources : x3::parser<ArrowBehindSources> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;

  template <class C, class Unused>
  bool parse(Iterator& first, const Iterator&, const C& context, TransitionText& text, Unused&) const {
    static const std::vector<std::string> keywords = {"input", "output", "internal", "initial", "mode", "fault"};
    if (arrow.scan(first, state_of(context))) return true;
    const auto* named = std::get_if<NamedSources>(&text.sources.node);
    if (named != nullptr && base::nearest(named->modes.front().text, keywords)) return false;
    throw x3::expectation_failure<Iterator>(first, "`->`");
  }
};

const auto any_source_def = record[Keyword("any") >> -set<&AnySource::nominal, true>[Keyword("nominal")]];
const auto named_sources_def = record[comma_list(append<&NamedSources::modes>[name])];
const auto sources_def =
    record[field<&TransitionSources::node>[any_source] | field<&TransitionSources::node>[named_sources]];

const auto probability_def = record[field<&ProbabilityWeight::probability>[signed_number]];
const auto rate_def =
    record[Keyword("rate") > field<&RateWeight::rate>[signed_number] > slash > field<&RateWeight::unit>[unit]];

const auto parameter = append<&DensityText::parameters>[duration];
const auto shape_and_parameter =
    open_paren > field<&DensityText::shape>[signed_number] > comma > parameter > close_paren;
const auto density_def =
    record[tilde > named("`uniform`, `exponential`, `normal`, `weibull` or `erlang`",
                         set<&DensityText::kind, DensityKind::uniform>[Keyword("uniform")] |
                             (set<&DensityText::kind, DensityKind::exponential>[Keyword("exponential")] > open_paren >
                              parameter > close_paren) |
                             (set<&DensityText::kind, DensityKind::normal>[Keyword("normal")] > open_paren > parameter >
                              comma > parameter > close_paren) |
                             (set<&DensityText::kind, DensityKind::weibull>[Keyword("weibull")] > shape_and_parameter) |
                             (set<&DensityText::kind, DensityKind::erlang>[Keyword("erlang")] > shape_and_parameter))];

// `after d` is `in [d, d]`: the one duration is read into both bounds.
const auto both_bounds =
    named("a duration", &field<&TimingText::lower>[duration] >> field<&TimingText::upper>[duration]);
const auto timing_def = record[((Keyword("in") > open_bracket > field<&TimingText::lower>[duration] > comma >
                                 field<&TimingText::upper>[bound] > close_bracket) |
                                (set<&TimingText::after, true>[Keyword("after")] > both_bounds)) >>
                               -field<&TimingText::density>[density]];

const auto target_def = record[field<&Branch::target>[name]];
const auto branch_def = record[field<&Branch::target>[name] > Keyword("with") > field<&Branch::weight>[probability]];

const auto weight = Keyword("with") > named("a probability or `rate`",
                                            field<&Branch::weight>[rate] | field<&Branch::weight>[probability]);

const auto guard = Keyword("when") > field<&TransitionText::guard>[constraint];
const auto timed = field<&TransitionText::timing>[timing];

// Guard and timing stand before or behind the braces of a branch.
const auto branches = set<&TransitionText::braced, true>[open_brace] >
                      comma_list(append<&TransitionText::branches>[branch]) > named("`,` or `}`", close_brace);
const auto branched = (&(Keyword("when") | Keyword("in") | Keyword("after") >> number) >> -guard >> -timed >
                       named("`{` and the branches", branches)) |
                      (branches >> -guard >> -timed);
const auto plain = append<&TransitionText::branches>[target] >>
                   -set<&TransitionText::restart, true>[Keyword("restart")] >> -guard >> -timed >>
                   -last_of<&TransitionText::branches>[weight];

const auto transition_def = record[field<&TransitionText::sources>[sources] >> ArrowBehindSources {
} > named("a mode or branches in braces", branched | plain) > named("`when`, `in`, `after`, `with` or `;`", semicolon)];

BOOST_SPIRIT_DEFINE(any_source, named_sources, sources, probability, rate, density, timing, target, branch)

}  // namespace

BOOST_SPIRIT_DEFINE(transition)
BOOST_SPIRIT_INSTANTIATE(decltype(transition), Iterator, Context)

}  // namespace rmpl::grammar
