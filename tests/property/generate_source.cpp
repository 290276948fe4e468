// Random RMPL sources with every construct of the language.
// SPDX-License-Identifier: MIT
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"

namespace rmpl::property {

using automata::ClockId;
using automata::Formula;
using automata::Ticks;
using reference::Rmpl;
using reference::Statement;

namespace {

class SourceDraw {
 public:
  explicit SourceDraw(const automata::Plant& plant) : plant_(plant) {}

  Rmpl draw() {
    source_.clocks = {"t0", "t1"};
    definitions_ = up_to(1, 3);
    for (std::size_t i = 0; i < definitions_; ++i) source_.definitions.push_back(definition(i));
    return std::move(source_);
  }

 private:
  /// Clocks are started first of all in the program, so that every path to a reader starts them.
  Statement definition(std::size_t position) {
    self_ = position;
    source_.has_own.push_back(position > 0 && chance(50));
    Statement body = statement(3);
    if (position > 0 && !source_.has_own.back()) return body;
    Statement whole{.kind = Statement::Kind::sequence};
    if (position > 0) {
      whole.parts.push_back({.kind = Statement::Kind::clock_start, .clock = ClockId(source_.clocks.size())});
      whole.parts.push_back(std::move(body));
      return whole;
    }
    for (std::size_t clock = 0; clock < source_.clocks.size(); ++clock)
      whole.parts.push_back({.kind = Statement::Kind::clock_start, .clock = ClockId(clock)});
    whole.parts.push_back(std::move(body));
    return whole;
  }

  Statement statement(int depth) {
    using Kind = Statement::Kind;
    static const std::vector<Kind> leaves = {Kind::goal, Kind::goal, Kind::clock_start, Kind::call, Kind::nothing};
    static const std::vector<Kind> all = {Kind::sequence, Kind::parallel, Kind::if_then,    Kind::if_else, Kind::unless,
                                          Kind::when,     Kind::whenever, Kind::always,     Kind::repeat,  Kind::next,
                                          Kind::watching, Kind::each,     Kind::maintaining};
    Statement s;
    s.kind = depth == 0 || chance(20) ? pick(leaves) : pick(all);
    switch (s.kind) {
      case Kind::goal:
        draw_goal(s);
        break;
      case Kind::clock_start:
        s.clock = clock();
        break;
      case Kind::call:
        if (self_ + 1 < definitions_) {
          s.callee = up_to(self_ + 1, definitions_ - 1);
        } else {
          s.kind = Kind::goal;
          draw_goal(s);
        }
        break;
      case Kind::nothing:
        break;
      case Kind::each:
        add_parts(s, up_to(1, 3), depth);
        break;
      case Kind::sequence:
      case Kind::parallel:
        add_parts(s, up_to(2, 3), depth);
        break;
      case Kind::if_else:
        s.constraint = constraint();
        add_parts(s, 2, depth);
        break;
      case Kind::always:
      case Kind::repeat:
      case Kind::next:
        add_parts(s, 1, depth);
        break;
      case Kind::if_then:
      case Kind::unless:
      case Kind::when:
      case Kind::whenever:
      case Kind::watching:
      case Kind::maintaining:
        s.constraint = constraint();
        add_parts(s, 1, depth);
        break;
    }
    return s;
  }

  /// One of the program's, or the definition's own.
  ClockId clock() { return ClockId(up_to(0, source_.clocks.size() - (source_.has_own.back() ? 0 : 1))); }

  void add_parts(Statement& s, std::size_t count, int depth) {
    for (std::size_t i = 0; i < count; ++i) s.parts.push_back(statement(depth - 1));
  }

  void draw_goal(Statement& s) {
    const std::size_t first = up_to(0, plant_.components.size() - 1);
    for (std::size_t i = first; i < plant_.components.size(); ++i) {
      const automata::Component& component = plant_.components[i];
      if (i == first || chance(30))
        s.goal.push_back({component.mode, automata::ValueId(up_to(0, component.modes.size() - 1))});
    }
  }

  /// In the forms in which the compiler keeps them: assignments, clock bounds, conjunctions and disjunctions of two.
  Formula constraint() {
    const auto atom = [&] {
      if (chance(25)) {
        const auto comparison =
            pick<automata::Comparison>({automata::Comparison::at_least, automata::Comparison::less,
                                        automata::Comparison::at_most, automata::Comparison::greater});
        return automata::clock_bound(clock(), comparison,
                                     Ticks{static_cast<std::int64_t>(up_to(0, 6)) * Ticks::per_second / 2});
      }
      const automata::VariableId variable = pick(all_variables(plant_));
      Formula is = automata::is(variable, automata::ValueId(up_to(0, plant_.variables[variable].values.size() - 1)));
      if (!chance(15)) return is;
      using automata::Knowing;
      const automata::VariableId component = pick(plant_.components).mode;
      switch (up_to(0, 5)) {
        case 0:
          return automata::knowledge(Knowing::surprise);
        case 1:
          return automata::knowledge(Knowing::no_plan);
        case 2:
          return automata::knowledge(Knowing::surprise, component);
        case 3:
          return automata::knowledge(Knowing::no_plan, component);
        case 4:
          return automata::knowledge(Knowing::possible, std::move(is), chance(50) ? automata::least_possible : 0.25);
        default:
          return automata::knowledge(Knowing::likely, std::move(is), 0.95);
      }
    };
    if (chance(60)) return atom();
    return chance(50) ? automata::conjunction({atom(), atom()}) : automata::disjunction({atom(), atom()});
  }

  const automata::Plant& plant_;
  Rmpl source_;
  std::size_t definitions_ = 1;
  std::size_t self_ = 0;
};

}  // namespace

void showValue(const RandomSource& source, std::ostream& out) { out << source.text; }

rc::Gen<RandomSource> sources(const automata::Plant& plant) {
  return rc::gen::exec([plant] {
    RandomSource result{SourceDraw(plant).draw(), {}};
    result.text = reference::to_text(result.source, plant.variables);
    return result;
  });
}

}  // namespace rmpl::property
