// Programs on plants without bystanders, against the same on the whole plant.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "compiler/session/compiler.hpp"
#include "compiler/session/provider.hpp"
#include "tests/property/draw.hpp"
#include "verifier/closed_loop/check.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;
using Kind = verifier::ProgramProperty::Kind;

std::string number(std::size_t n) { return std::to_string(n); }
std::string interval() {
  const std::size_t lower = up_to(1, 3);
  return " in [" + number(lower) + " s, " + number(lower + up_to(0, 2)) + " s]";
}

/// A component that no command reaches; it may fail, stand, move round and round, or be rewarded.
std::string bystander(std::size_t n) {
  std::string text = "component Bystander" + number(n) + " {\n  output out : { no, yes };\n  initial a;\n" +
                     "  mode a { out = no };\n  mode b { out = yes }" + (chance(15) ? " reward 2" : "") +
                     ";\n  mode c { out = yes };\n";
  if (chance(40))
    text += "  fault dead { out = no };\n  any nominal -> dead with " + std::string(chance(85) ? "0.01" : "1") + ";\n";
  for (const char* step : {"a -> b", "b -> c", "c -> a"}) {
    if (chance(20)) continue;
    text += std::string("  ") + step + (chance(10) ? "" : interval()) + ";\n";
  }
  return text + "}\n";
}

std::string machine() {
  std::string text =
      "component Machine {\n  input cmd : { none, on, off };\n  input seen : { no, yes };\n  output out : { no, yes "
      "};\n"
      "  initial idle;\n  mode idle { out = no };\n  mode warm { out = no };\n  mode works { out = yes };\n";
  if (chance(50)) text += "  fault jammed { out = no };\n  works -> jammed with 0.01;\n";
  text += "  idle -> warm when cmd = on;\n  warm -> works" + interval() + ";\n";
  text += chance(70) ? "  works -> idle when cmd = off;\n" : "  works -> idle after 2 s;\n";
  if (chance(30)) text += "  warm -> idle when seen = yes;\n";
  return text + "}\n";
}

std::string plant() {
  const std::size_t bystanders = up_to(1, 2);
  std::string text = machine();
  for (std::size_t n = 1; n <= bystanders; ++n) text += bystander(n);
  text += "plant P {\n  m : Machine;\n";
  for (std::size_t n = 1; n <= bystanders; ++n) text += "  s" + number(n) + " : Bystander" + number(n) + ";\n";
  text += "  control m.cmd default none;\n";
  if (chance(30)) text += "  m.seen = s1.out;\n";
  if (chance(15)) text += "  !(s1 = c & s" + number(bystanders) + " = " + pick<std::string>({"a", "c"}) + ");\n";
  return text + "}\n";
}

std::string program() {
  return pick<std::string>({
      "Main() :: { m = works }\n",
      "Main() :: { m = works; m = idle }\n",
      "Main() :: { m = works; t = 0; when (t >= 3 s) donext m = idle }\n",
      "Main() :: { t = 0; do m = works watching t > 4 s; m = idle }\n",
      "Main() :: { when s1 = b donext m = works }\n",
      "Main() :: { m = works; when m = jammed donext m = idle }\n",
      "Main() :: { repeat { m = works; m = idle } }\n",
  });
}

automata::Formula formula(const automata::Plant& plant) {
  const std::string text =
      pick<std::string>({"m = works", "m = warm", "m.out = yes", "m = idle", "m = works & s1 = b", "s1 = c"});
  auto compiled = compiler::compile_formula(text, plant, "test");
  RC_ASSERT(compiled.formula.has_value());
  return *compiled.formula;
}

std::vector<verifier::Property> questions(const automata::Plant& plant) {
  std::vector<verifier::Property> result;
  for (const Kind kind : {Kind::goal_conflict, Kind::no_plan, Kind::endless_wait, Kind::termination, Kind::stuck}) {
    if (chance(30)) result.push_back(verifier::ProgramProperty{.kind = kind});
  }
  for (const Kind kind : {Kind::never, Kind::eventually, Kind::response, Kind::finally}) {
    if (!chance(25)) continue;
    verifier::ProgramProperty property{.kind = kind, .formula = formula(plant)};
    property.within = Ticks::of_seconds(static_cast<std::int64_t>(up_to(1, 9)));
    property.then = formula(plant);
    result.push_back(property);
  }
  if (result.empty()) result.push_back(verifier::ProgramProperty{.kind = Kind::stuck});
  return result;
}

RC_GTEST_PROP(Bystanders, ChangeNothing, ()) {
  const std::string model = plant();
  const std::string text = program();
  compiler::Memory memory;
  memory.put("p.tcca", model);
  memory.put("m.rmpl", text);
  const auto compilation = compiler::compile(std::vector<std::string>{"p.tcca", "m.rmpl"}, {}, memory);
  RC_LOG() << model << text;
  for (const auto& diagnostic : compilation.findings().diagnostics.all()) RC_LOG() << diagnostic.message << '\n';
  RC_PRE(compilation.ok());
  const automata::Document& document = compilation.document();
  const automata::Plant& plant = document.plants.front();
  const std::vector<verifier::Property> properties = questions(plant);
  verifier::CheckOptions options;
  options.faults = static_cast<unsigned>(up_to(0, 2));
  options.entailed = chance(20);
  if (chance(50)) options.period = pick<Ticks>({Ticks::of_seconds(1), {Ticks::per_second / 2}});
  verifier::Limits limits;
  limits.states = 30000;
  const auto ask = [&](bool slice) {
    options.slice = slice;
    automata::PlantStep step(plant);
    return verifier::check(document.programs.front(), step, properties, options, limits);
  };
  const std::vector<verifier::Answer> whole = ask(false);
  const std::vector<verifier::Answer> without = ask(true);
  bool fewer = false;
  for (std::size_t p = 0; p < properties.size(); ++p) {
    if (whole[p].limit || without[p].limit) continue;
    RC_LOG() << verifier::name_of(properties[p]) << ", faults " << *options.faults << ", dense " << !options.period
             << ", whole " << static_cast<int>(whole[p].verdict) << ", cut off " << whole[p].cut_off.stuck
             << whole[p].cut_off.still << whole[p].cut_off.spent << ", without " << static_cast<int>(without[p].verdict)
             << ", cut off " << without[p].cut_off.stuck << without[p].cut_off.still << without[p].cut_off.spent
             << '\n';
    fewer = fewer || without[p].progress.states < whole[p].progress.states;
    RC_ASSERT(without[p].verdict == whole[p].verdict);
    RC_ASSERT(without[p].witness.has_value() == whole[p].witness.has_value());
    RC_ASSERT(without[p].vacuous == whole[p].vacuous);
    RC_ASSERT(without[p].cut_off.stuck == whole[p].cut_off.stuck);
    RC_ASSERT(without[p].cut_off.still == whole[p].cut_off.still);
    RC_ASSERT(without[p].cut_off.spent == whole[p].cut_off.spent);
  }
  RC_CLASSIFY(fewer, "bystanders left");
}

}  // namespace
}  // namespace rmpl::property
