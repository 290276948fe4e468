// Timers that are folded into their clocks, against timers that are modes, on plants as engineers write them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "automata/step/plant_step.hpp"
#include "compiler/session/compiler.hpp"
#include "compiler/session/provider.hpp"
#include "tests/property/draw.hpp"
#include "tests/reference/step.hpp"
#include "verifier/behaviour/folds.hpp"
#include "verifier/check/check.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;

std::string number(std::size_t n) { return std::to_string(n); }
std::string yes_or_no() { return chance(50) ? "yes" : "no"; }
std::string seconds() { return number(up_to(1, 4)) + " s"; }

/// A timer: what runs out after a fixed time, in one step or two, with what starts, stops and asks it.
std::string timer(std::size_t n) {
  const bool warns = chance(40);
  std::string text = "component Timer" + number(n) + " {\n  input starts, stops : Bool;\n  output out : Bool;\n" +
                     "  initial " + (chance(50) ? "idle" : "fresh") + ";\n";
  for (const char* mode : {"idle", "fresh", "old"})
    text += std::string("  mode ") + mode + " { out = " + yes_or_no() + " };\n";
  if (warns) text += "  mode warns { out = " + yes_or_no() + " };\n";
  const bool fails = chance(30);
  if (fails) text += "  fault dead { out = no };\n  any nominal -> dead with 0.01;\n";
  text += "  idle -> fresh when starts = yes;\n";
  text += std::string("  fresh -> ") + (warns ? "warns" : "old") + " after " + seconds() + ";\n";
  if (warns) text += "  warns -> old after " + seconds() + ";\n";
  switch (up_to(0, 6)) {
    case 0:
      text += "  old -> fresh when starts = yes;\n";
      break;
    case 1:
      text += "  any -> fresh when starts = yes;\n";
      break;
    case 2:
      text += "  old -> idle in [1 s, 3 s];\n";  // that is no timer
      break;
    default:
      text += "  any nominal -> idle when stops = yes;\n";
      break;
  }
  return text + "}\n";
}

/// A machine that goes by commands, by times, and by what timers say.
std::string machine(std::size_t n, std::size_t timers) {
  std::string text = "component Machine" + number(n) + " {\n  input cmd : { none, go };\n  input ";
  for (std::size_t t = 1; t <= timers; ++t) text += (t > 1 ? ", t" : "t") + number(t);
  text += " : Bool;\n  output works : Bool;\n  output asks : { none, one, two };\n  initial a;\n";
  for (const char* mode : {"a", "b", "c"}) {
    text += std::string("  mode ") + mode + " { works = " + yes_or_no() +
            " & asks = " + pick<std::string>({"none", "one", "two"}) + " };\n";
  }
  const auto guard = [&] {
    std::string result;
    if (chance(70)) result += "t" + number(up_to(1, timers)) + " = " + yes_or_no();
    if (chance(50)) result += std::string(result.empty() ? "" : " & ") + "cmd = go";
    return result.empty() ? result : " when " + result;
  };
  for (const char* step : {"a -> b", "b -> c", "c -> a", "b -> a", "a -> c"}) {
    if (chance(30)) continue;
    const std::string times =
        pick<std::string>({"", " after " + seconds(), " in [1 s, " + number(up_to(2, 4)) + " s]"});
    std::string own = guard();
    if (times.empty() && own.empty()) own = " when cmd = go";
    text += std::string("  ") + step + own + times + ";\n";
  }
  return text + "}\n";
}

struct Drawn {
  std::string text;
  std::size_t machines;
  std::size_t timers;
};

Drawn plant() {
  Drawn result{"domain Bool = { no, yes };\n", up_to(1, 2), up_to(1, 3)};
  for (std::size_t t = 1; t <= result.timers; ++t) result.text += timer(t);
  for (std::size_t m = 1; m <= result.machines; ++m) result.text += machine(m, result.timers);
  std::string parts, wires;
  for (std::size_t m = 1; m <= result.machines; ++m) {
    const std::string name = "m" + number(m);
    parts += "  " + name + " : Machine" + number(m) + ";\n";
    wires += "  control " + name + ".cmd default none;\n";
    for (std::size_t t = 1; t <= result.timers; ++t)
      wires += "  " + name + ".t" + number(t) + " = x" + number(t) + ".out;\n";
  }
  for (std::size_t t = 1; t <= result.timers; ++t) {
    const std::string name = "x" + number(t);
    parts += "  " + name + " : Timer" + number(t) + ";\n";
    const std::string by = "m" + number(up_to(1, result.machines));
    wires += "  " + name + ".starts = yes <-> " +
             pick<std::string>({by + ".works = yes", by + ".asks = one", by + " = b"}) + ";\n";
    wires += "  " + name + ".stops = yes <-> " +
             pick<std::string>({by + ".asks = two", by + ".works = no", by + " = c & " + name + ".out = yes"}) + ";\n";
  }
  if (chance(15)) wires += "  !(x1 = old & m1 = " + pick<std::string>({"a", "b", "c"}) + ");\n";
  if (result.machines > 1 && chance(30)) wires += "  !(m1 = b & m2 = c);\n";
  result.text += "plant P {\n" + parts + wires + "}\n";
  return result;
}

std::string state_of_machines(const Drawn& drawn) {
  std::string result;
  for (std::size_t m = 1; m <= drawn.machines; ++m) {
    if (!result.empty() && chance(30)) continue;
    result += (result.empty() ? "m" : " & m") + number(m) +
              pick<std::string>({" = a", " = b", " = c", ".works = yes", ".asks = two"});
  }
  return chance(15) ? result + " & x1" + pick<std::string>({" = old", ".out = yes"}) : result;
}

automata::Formula formula(const std::string& text, const automata::Plant& plant) {
  auto compiled = compiler::compile_formula(text, plant, "test");
  RC_ASSERT(compiled.formula.has_value());
  return *compiled.formula;
}

Ticks some_time() { return Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 9))); }

verifier::Property question(const Drawn& drawn, const automata::Plant& plant) {
  switch (up_to(0, 5)) {
    case 0:
      return verifier::Stuck{};
    case 1:
    case 2:
      return verifier::Response{formula(state_of_machines(drawn), plant), formula(state_of_machines(drawn), plant),
                                some_time()};
    default:
      verifier::Reachability target{formula(state_of_machines(drawn), plant), {}, chance(20)};
      if (chance(30)) target.window.not_before = some_time();
      if (chance(30)) target.window.by = some_time();
      return target;
  }
}

bool folds(const automata::Plant& plant) {
  automata::PlantStep step(plant);
  return verifier::Folds(step, verifier::TimeModel::of(std::nullopt, plant, {}), verifier::Commands::one, {}).any();
}

RC_GTEST_PROP(Folds, ChangeNothing, ()) {
  const Drawn drawn = plant();
  compiler::Memory memory;
  memory.put("p.tcca", drawn.text);
  const auto compilation = compiler::compile(std::vector<std::string>{"p.tcca"}, {}, memory);
  RC_LOG() << drawn.text;
  for (const auto& diagnostic : compilation.findings().diagnostics.all()) RC_LOG() << diagnostic.message << '\n';
  RC_ASSERT(compilation.ok());
  const automata::Plant& plant = compilation.document().plants.front();
  RC_CLASSIFY(folds(plant), "there is something to fold");
  const verifier::Property property = question(drawn, plant);
  verifier::CheckOptions options;
  options.faults = static_cast<unsigned>(up_to(0, 2));
  options.entailed = chance(20);
  options.merge = chance(80);
  options.slice = chance(80);
  options.fewest_faults = chance(10);
  options.symmetry = chance(50);
  if (chance(40)) options.commands = pick<verifier::Commands>({verifier::Commands::none, verifier::Commands::any});
  if (chance(40))
    options.period = pick<Ticks>({Ticks::of_seconds(1), {3 * Ticks::per_second / 4}, Ticks::of_seconds(2)});
  verifier::Limits limits;
  limits.states = 100000;
  const auto ask = [&](bool fold) {
    options.fold = fold;
    verifier::Slices slices(plant);
    return verifier::check(slices, property, options, limits);
  };
  const verifier::Answer modes = ask(false);
  const verifier::Answer folded = ask(true);
  RC_PRE(!modes.limit && !folded.limit);
  RC_CLASSIFY(modes.witness.has_value(), "a witness");
  for (const automata::Formula& one : verifier::formulas_of(property))
    RC_LOG() << to_text(one, plant.variables) << '\n';
  RC_LOG() << verifier::name_of(property) << ", faults " << *options.faults << ", dense " << !options.period
           << ", commands " << static_cast<int>(options.commands) << ", entailed " << options.entailed << ", modes "
           << static_cast<int>(modes.verdict) << " cut off " << modes.cut_off.stuck << modes.cut_off.still
           << modes.cut_off.spent << ", folded " << static_cast<int>(folded.verdict) << " cut off "
           << folded.cut_off.stuck << folded.cut_off.still << folded.cut_off.spent << '\n';
  RC_ASSERT(folded.verdict == modes.verdict);
  RC_ASSERT(folded.witness.has_value() == modes.witness.has_value());
  RC_ASSERT(folded.fewest_faults == modes.fewest_faults);
  if (modes.witness) {
    RC_ASSERT(folded.witness->events.size() == modes.witness->events.size());
    return;
  }
  RC_ASSERT(folded.cut_off.stuck == modes.cut_off.stuck);
  RC_ASSERT(folded.cut_off.still == modes.cut_off.still);
  RC_ASSERT(folded.cut_off.spent == modes.cut_off.spent);
}

}  // namespace
}  // namespace rmpl::property
