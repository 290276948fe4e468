// Plants as engineers write them. SPDX-License-Identifier: MIT
#include "tests/property/engineered.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "automata/assignment_text.hpp"
#include "automata/json/document.hpp"
#include "automata/store/plain_store.hpp"
#include "tests/property/draw.hpp"

namespace rmpl::property {

using automata::Formula;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::Ticks;
using automata::Timing;
using automata::ValueId;
using automata::VariableId;

namespace {

/// Values of attributes that tell whether something is there.
constexpr std::size_t no = 0;
constexpr std::size_t yes = 1;

Timing seconds() {
  const auto lower = static_cast<std::int64_t>(up_to(1, 4));
  return {Ticks::of_seconds(lower), Ticks::of_seconds(lower + static_cast<std::int64_t>(up_to(0, 2))), {}};
}

class Drawing {
 public:
  Plant draw(std::size_t parts) {
    plant_.name = "Engineered";
    using Draw = void (Drawing::*)();
    const std::vector<Draw> kinds = {&Drawing::supply, &Drawing::load,  &Drawing::battery, &Drawing::follower,
                                     &Drawing::level,  &Drawing::motor, &Drawing::brake,   &Drawing::button,
                                     &Drawing::wheel,  &Drawing::latch, &Drawing::driver,  &Drawing::disc,
                                     &Drawing::pyro,   &Drawing::relay, &Drawing::supply,  &Drawing::load};
    for (std::size_t i = 0; i < parts; ++i) (this->*pick(kinds))();
    if (chance(15)) interlock();
    return std::move(plant_);
  }

 private:
  using Modes = std::vector<std::pair<std::string, bool>>;  ///< with whether the part gives something in them

  /// A part that gives something in some of its modes. The first is initial.
  void part(const std::string& kind, const Modes& modes, std::vector<std::string> commands, bool rests) {
    name_ = kind + std::to_string(plant_.components.size());
    std::vector<std::string> names;
    for (const auto& [mode, gives] : modes) names.push_back(mode);
    automata::Component component;
    component.name = name_;
    component.type = kind;
    component.mode = plant_.variables.add({name_, names});
    component.initial.assign(modes.size(), 0.0);
    component.initial.front() = 1;
    const VariableId out = plant_.variables.add({name_ + ".out", {"no", "yes"}});
    for (const auto& [mode, gives] : modes)
      component.modes.push_back({mode, false, automata::is(out, ValueId(gives ? yes : no)), 0, {}});
    if (chance(15)) component.modes[up_to(0, modes.size() - 1)].reward = chance(50) ? 1 : -1;
    cmd_.reset();
    if (!commands.empty()) {
      commands.insert(commands.begin(), "none");
      cmd_ = plant_.variables.add({name_ + ".cmd", std::move(commands)});
      plant_.controls.push_back({*cmd_, ValueId(0)});
    }
    src_.reset();
    if (rests && !outs_.empty()) rest();
    outs_.push_back(out);
    plant_.observables.push_back(out);
    plant_.components.push_back(std::move(component));
  }

  /// On one or two parts that stand before.
  void rest() {
    src_ = plant_.variables.add({name_ + ".src", {"no", "yes"}});
    const VariableId first = pick(outs_);
    const VariableId second = chance(25) ? pick(outs_) : first;
    if (first == second) {
      plant_.interconnections.emplace_back(automata::equality(*src_, first));
      return;
    }
    std::vector<Formula> both = {automata::is(first, ValueId(yes)), automata::is(second, ValueId(yes))};
    plant_.interconnections.emplace_back(
        automata::equivalence(automata::is(*src_, ValueId(yes)), chance(70) ? automata::disjunction(std::move(both))
                                                                            : automata::conjunction(std::move(both))));
  }

  [[nodiscard]] Formula told(std::size_t command) const { return automata::is(*cmd_, ValueId(command)); }
  [[nodiscard]] Formula rests(bool there = true) const {
    return src_ ? automata::is(*src_, ValueId(there ? yes : no)) : automata::constant(there);
  }
  [[nodiscard]] Formula told_and_rests(std::size_t command) const {
    return src_ ? automata::conjunction({told(command), rests()}) : told(command);
  }
  automata::Transition& move(std::size_t from, std::size_t to, Formula guard, std::optional<Timing> timing = {}) {
    return plant_.components.back().transitions.emplace_back(
        automata::Transition{ModeId(from), ModeId(to), std::move(guard), timing, {}, branch_++, {}});
  }
  void falls(std::size_t from, std::size_t to) {
    if (src_) move(from, to, rests(false));
  }

  void supply() {
    part("supply", {{"off", false}, {"warming", false}, {"on", true}}, {"on", "off"}, chance(40));
    move(0, 1, told_and_rests(1));
    move(1, 2, automata::negation(told(2)), seconds());
    for (const std::size_t m : {1U, 2U}) {
      move(m, 0, told(2));
      falls(m, 0);
    }
  }
  void relay() {
    part("relay", {{"open", false}, {"closed", true}}, {"close", "open"}, chance(50));
    move(0, 1, told_and_rests(1));
    move(1, 0, told(2));
  }
  void load() {
    part("load", {{"off", false}, {"on", true}}, {"on", "off"}, true);
    move(0, 1, told_and_rests(1));
    move(1, 0, told(2));
    if (chance(80)) falls(1, 0);
  }
  void follower() {
    part("lamp", {{"dark", false}, {"lit", true}}, {}, true);
    move(0, 1, rests(), chance(20) ? std::optional(seconds()) : std::nullopt);
    falls(1, 0);
  }
  void battery() {
    part("battery", {{"full", true}, {"low", true}, {"flat", false}, {"charging", chance(30)}}, {"charge"}, chance(30));
    const bool always = chance(50);
    move(0, 1, always ? automata::constant(true) : told(0), seconds());
    move(1, 2, told(0), seconds());
    for (const std::size_t m : {1U, 2U}) move(m, 3, told_and_rests(1));
    move(3, 0, automata::constant(true), seconds());
  }
  void level() {
    part("tank", {{"empty", false}, {"filling", false}, {"full", true}},
         chance(50) ? std::vector<std::string>{"drain"} : std::vector<std::string>{}, true);
    move(0, 1, rests());
    move(1, 2, rests(), seconds());
    falls(1, 0);
    if (cmd_) move(2, 0, told(1));
    if (!cmd_ || chance(30)) move(2, 0, rests(!src_), seconds());
  }
  void motor() {
    part("motor", {{"still", false}, {"running", true}}, {"run"}, true);
    move(0, 1, told_and_rests(1));
    move(1, 0, automata::negation(told(1)));
    falls(1, 0);
  }
  void brake() {
    part("brake", {{"set", false}, {"free", true}}, {"set", "release"}, chance(20));
    move(0, 1, told_and_rests(2));
    move(1, 0, told(1));
    move(1, 0, told(0), seconds());
  }
  void button() {
    part("button", {{"lo", false}, {"hi", true}}, {"press"}, chance(20));
    move(0, 1, told_and_rests(1));
    move(1, 0, told(0), chance(50) ? std::optional(seconds()) : std::nullopt);
  }
  void wheel() {
    part("wheel", {{"off", false}, {"spinning-up", false}, {"running", true}, {"coasting", false}}, {"spin", "stop"},
         true);
    move(0, 1, told_and_rests(1));
    move(1, 2, rests(), seconds());
    move(2, 3, told(2));
    for (const std::size_t m : {1U, 2U}) falls(m, 3);
    move(3, 0, automata::constant(true), seconds());
  }
  void latch() {
    part("latch", {{"off", false}, {"on", true}}, {"engage", "release"}, chance(50));
    const std::uint32_t branch = branch_;
    for (const std::size_t to : {1U, 0U}) {
      automata::Transition& t = move(0, to, told_and_rests(1));
      t.branch = branch;
      t.weight = {automata::Weight::Kind::probability, to == 1 ? 0.9 : 0.1};
    }
    move(1, 0, told(2));
  }
  void driver() {
    part("driver", {{"up", true}, {"booting", false}, {"hung", false}}, {"reset"}, chance(30));
    plant_.components.back().modes[2].fault = true;
    move(0, 2, automata::constant(true)).weight = {automata::Weight::Kind::probability, 0.001};
    move(2, 1, told(1));
    move(1, 0, rests(), seconds());
    if (chance(50)) move(0, 1, told(1));
  }
  /// What bursts by itself, where what it rests on lasts.
  void disc() {
    part("disc", {{"whole", false}, {"burst", true}}, {}, true);
    move(0, 1, src_ ? rests() : automata::constant(false), chance(50) ? std::optional(seconds()) : std::nullopt);
  }
  void pyro() {
    part("pyro", {{"armed", false}, {"firing", false}, {"fired", true}}, {"fire"}, chance(50));
    move(0, 1, told_and_rests(1));
    move(1, 2, automata::constant(true), chance(50) ? std::optional(seconds()) : std::nullopt);
  }
  /// Two parts that never give at once.
  void interlock() {
    const VariableId first = pick(outs_);
    const VariableId second = pick(outs_);
    if (first == second) return;
    plant_.interconnections.emplace_back(automata::negation(
        automata::conjunction({automata::is(first, ValueId(yes)), automata::is(second, ValueId(yes))})));
  }

  Plant plant_;
  std::vector<VariableId> outs_;
  std::string name_;
  std::optional<VariableId> cmd_, src_;  ///< of the part that is drawn
  std::uint32_t branch_ = 0;
};

/// Some modes of some parts, as programs ask for; now and then what a part gives, or one of two.
Formula draw_goal(const Plant& plant) {
  const auto part = [&] {
    const automata::Component& component = pick(plant.components);
    if (chance(20)) return automata::is(*plant.variables.find(component.name + ".out"), ValueId(yes));
    return automata::is(component.mode, ValueId(up_to(0, component.modes.size() - 1)));
  };
  std::vector<Formula> parts;
  for (std::size_t i = up_to(1, 3); i > 0; --i)
    parts.push_back(chance(10) ? automata::disjunction({part(), part()}) : part());
  return automata::conjunction(std::move(parts));
}

Modes draw_start(const Plant& plant) {
  Modes modes;
  for (const automata::Component& component : plant.components)
    modes.emplace_back(chance(60) ? 0 : up_to(0, component.modes.size() - 1));
  return modes;
}

}  // namespace

void showValue(const Engineered& engineered, std::ostream& out) {
  const auto& variables = engineered.plant.variables;
  out << automata::to_json(automata::Document{{engineered.plant}, {}, {}, {}}).dump() << "\nfrom "
      << automata::to_text(variables, automata::assignments_of(engineered.plant, engineered.start)) << "\ngoal "
      << automata::to_text(engineered.goal, variables);
}

rc::Gen<Engineered> engineered(std::size_t least_parts, std::size_t most_parts) {
  return rc::gen::suchThat(
      rc::gen::exec([least_parts, most_parts] {
        Engineered result;
        result.plant = Drawing().draw(up_to(least_parts, most_parts));
        result.start = draw_start(result.plant);
        result.goal = draw_goal(result.plant);
        return result;
      }),
      [](const Engineered& drawn) { return automata::PlainStore(drawn.plant).possible(drawn.start); });
}

}  // namespace rmpl::property
