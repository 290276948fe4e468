// k-best as it is by default beside the exact estimator, through long silences, late repairs and renewals.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "runtime/reasoning/estimate/estimator.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/unit/runtime/reasoning/estimate/estimate_models.hpp"

namespace rmpl::property {
namespace {

using automata::ComponentId;
using automata::Modes;
using automata::Ticks;
using Density = automata::Density;
using ByModes = std::map<Modes, double>;

/// Times are whole seconds; a step takes one.
Ticks seconds(std::size_t count) { return Ticks::of_seconds(static_cast<std::int64_t>(count)); }

/// How long a repair or a service takes: about `typical` steps.
automata::Timing draw_time(std::size_t typical) {
  const auto mean = static_cast<double>(typical);
  const Ticks low = seconds(up_to(0, typical)), high = seconds(typical + up_to(1, typical));
  const Ticks ever = Ticks::infinite();
  switch (up_to(0, 6)) {
    case 0:
      return {low, high, {Density::Kind::exponential, mean}};
    case 1:
      return {chance(50) ? Ticks{} : low, ever, {Density::Kind::exponential, mean / 2}};
    case 2:
      return {Ticks{}, high, {Density::Kind::normal, mean, mean / 4}};
    case 3:
      return {Ticks{}, ever, {Density::Kind::weibull, 0, 0, pick<double>({0.7, 1.5, 4.0}), mean}};
    case 4:
      return {low, chance(50) ? ever : high, {Density::Kind::erlang, mean, 0, pick<double>({2.0, 5.0})}};
    default:
      return {low, high, {}};
  }
}

/// Links that drop and come back late, some of them served now and then, some for ever dead.
runtime::test::PlantWriter draw_links(std::size_t count, std::size_t typical) {
  runtime::test::PlantWriter w;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = "link" + std::to_string(i), seen = name + ".s";
    w.observable(seen, {"good", "lost"});
    const auto lost = w.is(seen, "lost");
    const ComponentId link = w.component(
        name, {{"up", false, w.is(seen, "good")}, {"down", true, lost}, {"served", false, lost}, {"dead", true, lost}});
    const auto fails = [&](const char* from, const char* to, double probability) {
      w.transition(link, from, to).weight = {automata::Weight::Kind::probability, probability};
    };
    fails("up", "down", pick<double>({0.02, 0.1, 0.3}));
    if (chance(40)) fails("down", "dead", pick<double>({0.001, 0.02}));
    auto& back = w.transition(link, "down", "up");
    back.timing = draw_time(typical);
    if (i > 0 && chance(40)) back.guard = w.is("link" + std::to_string(i - 1) + ".s", "good");
    if (chance(40)) {
      w.transition(link, "up", "served").timing = draw_time(typical);
      w.transition(link, "served", "up").timing = draw_time(std::max<std::size_t>(typical / 2, 1));
    }
    if (i > 0 && chance(40)) {
      const char* const mode = chance(50) ? "down" : "served";
      const auto both = {w.is(name, mode), w.is("link" + std::to_string(i - 1), mode)};
      w.plant.interconnections.emplace_back(automata::negation(automata::conjunction(both)));
    }
  }
  return w;
}

ByModes by_modes(const runtime::Belief& belief) {
  ByModes result;
  for (const runtime::BeliefEntry& entry : belief) result[entry.state.modes] += entry.probability;
  return result;
}

/// What is seen of one link in a state that the belief has for possible.
automata::Observation draw_reading(const runtime::test::PlantWriter& w, const ByModes& belief) {
  auto at = belief.begin();
  for (std::size_t skip = up_to(0, belief.size() - 1); skip > 0; --skip) ++at;
  const std::size_t c = up_to(0, w.plant.components.size() - 1);
  const bool good = w.plant.components[c].modes[at->first[c].index()].name == "up";
  return {w.assignment(w.plant.components[c].name + ".s", good ? "good" : "lost")};
}

double gap(const ByModes& belief) {
  std::vector<double> shares;
  for (const auto& [modes, share] : belief) shares.push_back(share);
  std::sort(shares.rbegin(), shares.rend());
  return shares.size() < 2 ? 1 : shares[0] - shares[1];
}

/// Half of what two beliefs differ by.
double apart(const ByModes& one, ByModes other) {
  double sum = 0;
  for (const auto& [modes, share] : one) sum += std::max(0.0, share - other[modes]);
  return sum;
}

struct Count {
  std::size_t updates = 0;  ///< in which the most likely modes are clear
  std::size_t other = 0;    ///< and k-best told other ones
};

/// The bound holds in each update. The most likely modes are the same but for one clear case in a thousand.
void compare(const char* what, std::size_t most_links, std::size_t most_typical, std::size_t most_silence) {
  Count count;
  const bool bounded = rc::check(what, [&] {
    const std::size_t links = up_to(1, most_links);
    const std::size_t typical = up_to(2, std::max<std::size_t>(3, most_typical / (links * links)));
    const auto w = draw_links(links, typical);
    automata::PlantStep one(w.plant), other(w.plant);
    const auto exact = runtime::make_exact_estimator(one, {.live_clocks_only = true});
    const auto fast = runtime::make_k_best_estimator(other, {.live_clocks_only = true, .account = chance(50)});
    Ticks now;
    for (std::size_t reading = up_to(1, 3); reading > 0; --reading) {
      for (std::size_t left = up_to(1, most_silence / (links * links)); left > 0; --left) {
        now = now + seconds(1);
        const automata::Observation seen =
            left == 1 ? draw_reading(w, by_modes(exact->belief())) : automata::Observation{};
        const bool explained = exact->update({}, seen, now).consistent;
        fast->update({}, seen, now);
        if (!explained) return;
        const ByModes expected = by_modes(exact->belief()), found = by_modes(fast->belief());
        double listed = 0;  // of independent links not all combinations are
        for (const auto& [modes, share] : found) listed += share;
        const double bound = fast->estimate().missing_total + 1 - std::min(1.0, listed);
        RC_ASSERT(apart(expected, found) <= bound + 1e-9);
        if (gap(expected) < 0.01) continue;
        ++count.updates;
        if (exact->estimate().modes != fast->estimate().modes) ++count.other;
      }
    }
  });
  EXPECT_TRUE(bounded);
  EXPECT_GT(count.updates, 0u);
  EXPECT_LE(1000 * count.other, count.updates) << count.other << " of " << count.updates;
}

TEST(Silence, LeavesKBestNearExact) { compare("k-best is within its bound of exact", 3, 12, 40); }

TEST(Silence, LeavesMergedClocksNearExact) { compare("merged clocks are within their bound of exact", 1, 200, 500); }

}  // namespace
}  // namespace rmpl::property
