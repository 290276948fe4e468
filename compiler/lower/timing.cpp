// Time bounds, densities and weights, checked.
// SPDX-License-Identifier: MIT
#include "compiler/lower/timing.hpp"

#include <cmath>

#include "compiler/check/probabilities.hpp"
#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using automata::Density;
using automata::Ticks;
using automata::Timing;
using automata::Weight;
using grammar::Code;

namespace {

/// A density of one stage, or of shape 1, is the exponential one.
std::optional<Density> weibull_of(const grammar::Number& shape, double scale, bool right,
                                  grammar::Diagnostics& diagnostics) {
  constexpr double least = 0.01, most = 100;
  if (!(shape.value >= least && shape.value <= most)) {
    diagnostics.error(Code::density_out_of_range, shape.span,
                      "the shape of a Weibull density is from 0.01 to 100, not " + shape.text);
    return std::nullopt;
  }
  if (!right) return std::nullopt;
  if (shape.value == 1) return Density{Density::Kind::exponential, scale};
  return Density{Density::Kind::weibull, 0, 0, shape.value, scale};
}

std::optional<Density> erlang_of(const grammar::Number& stages, double mean, bool right,
                                 grammar::Diagnostics& diagnostics) {
  constexpr double most = 100;
  if (!(stages.value >= 1 && stages.value <= most) || stages.value != std::floor(stages.value)) {
    diagnostics.error(Code::density_out_of_range, stages.span,
                      "an Erlang density has a whole number of stages, from 1 to 100, not " + stages.text);
    return std::nullopt;
  }
  if (!right) return std::nullopt;
  if (stages.value == 1) return Density{Density::Kind::exponential, mean};
  return Density{Density::Kind::erlang, mean, 0, stages.value};
}

std::optional<Density> density_of(const grammar::DensityText& text, grammar::Diagnostics& diagnostics) {
  std::vector<Ticks> parameters;
  for (const grammar::Duration& duration : text.parameters) {
    const auto ticks = ticks_of(duration, diagnostics);
    if (!ticks) return std::nullopt;
    parameters.push_back(*ticks);
  }
  const auto positive = [&](std::size_t parameter, const char* what) {
    if (parameters[parameter] > Ticks{0}) return true;
    diagnostics.error(Code::density_out_of_range, text.parameters[parameter].span,
                      std::string("the ") + what + " of a density is above 0");
    return false;
  };
  switch (text.kind) {
    case grammar::DensityKind::uniform:
      return Density{};
    case grammar::DensityKind::exponential:
      if (!positive(0, "mean")) return std::nullopt;
      return Density{Density::Kind::exponential, parameters[0].seconds(), 0};
    case grammar::DensityKind::normal:
      if (!positive(1, "standard deviation")) return std::nullopt;
      return Density{Density::Kind::normal, parameters[0].seconds(), parameters[1].seconds()};
    case grammar::DensityKind::weibull:
      return weibull_of(text.shape, parameters[0].seconds(), positive(0, "scale"), diagnostics);
    case grammar::DensityKind::erlang:
      return erlang_of(text.shape, parameters[0].seconds(), positive(0, "mean"), diagnostics);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Ticks> ticks_of(const grammar::Duration& duration, grammar::Diagnostics& diagnostics) {
  const auto ticks = automata::parse_duration(duration.text());
  if (!ticks) {
    diagnostics.error(Code::duration_out_of_range, duration.span,
                      backquoted(duration.text()) + " is finer than a nanosecond or longer than 292 years");
  }
  return ticks;
}

std::optional<Timing> timing_of(const grammar::TimingText& text, grammar::Diagnostics& diagnostics) {
  const auto lower = ticks_of(text.lower, diagnostics);
  const auto upper = text.after ? lower : ticks_of(text.upper, diagnostics);
  const auto density = text.density ? density_of(*text.density, diagnostics) : Density{};
  if (!lower || !upper || !density) return std::nullopt;
  if (*lower > *upper) {
    auto& error = diagnostics.error(Code::reversed_bounds, join(text.lower.span, text.upper.span),
                                    "the lower time bound " + automata::format_seconds(*lower) +
                                        " s is above the upper one, " + automata::format_seconds(*upper) + " s");
    error.suggestion = "exchange the bounds";
    error.fix = {{text.lower.span, text.upper.text()}, {text.upper.span, text.lower.text()}};
    return std::nullopt;
  }
  if (lower->is_infinite()) {
    diagnostics.error(Code::duration_out_of_range, text.lower.span, "the lower time bound is finite");
    return std::nullopt;
  }
  return Timing{*lower, *upper, *density};
}

bool check_density(const Timing& timing, grammar::Span span, grammar::Diagnostics& diagnostics) {
  if (!timing.lacks_density()) return true;
  auto& error = diagnostics.error(Code::density_required, span,
                                  "an infinite upper bound needs a density: a uniform one has no end");
  error.suggestion = "add `~ exponential(mean)`, or another density but the uniform one";
  return false;
}

std::optional<Weight> weight_of(const grammar::WeightText& text, grammar::Diagnostics& diagnostics) {
  if (const auto* weight = std::get_if<grammar::ProbabilityWeight>(&text)) {
    if (!check_probability(weight->probability, diagnostics, "outside of `-> { … }` a weight is at most 1, too"))
      return std::nullopt;
    return Weight{Weight::Kind::probability, weight->probability.value};
  }
  const auto& rate = std::get<grammar::RateWeight>(text);
  if (rate.rate.value < 0) {
    diagnostics.error(Code::negative_rate, rate.rate.span,
                      "the rate " + rate.rate.text + " is negative, expected 0 or more");
    return std::nullopt;
  }
  const auto unit = automata::parse_duration("1" + rate.unit.text);
  if (!unit) {
    diagnostics.error(Code::syntax, rate.unit.span, "expected a unit of time, found " + backquoted(rate.unit.text));
    return std::nullopt;
  }
  return Weight{Weight::Kind::rate, rate.rate.value / unit->seconds()};
}

}  // namespace rmpl::compiler
