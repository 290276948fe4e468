// The steps of control programs (language.md "Control programs"; thesis 5.1.2).
// SPDX-License-Identifier: MIT
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

/// What ends a `do`: `watching c` or `maintaining c`.
struct Ending {
  bool watching = false;
  Constraint condition;
};

Step ended(Step inner, Ending ending) {
  Step step;
  if (ending.watching) {
    step.node = Watching{std::move(inner), std::move(ending.condition)};
  } else {
    step.node = Maintaining{std::move(inner), std::move(ending.condition), true};
  }
  return step;
}

/// Takes the ending at the end of a step away from it, for a `do` around it that has none. What binds to the nearest
/// step at first may have to go further out: in `do when d donext A maintaining c` the `do` needs it, and in
/// `do do A maintaining c watching d` the outer `do` needs the last, and the first does for the inner one.
bool detach_ending(Step& from, Ending& ending);

bool detach_from(Step& from, Box<Step>& inner, Ending& ending) {
  if (!detach_ending(*inner, ending)) return false;
  from.span.end = inner->span.end;
  return true;
}

struct Detach {
  Step& from;
  Ending& ending;

  bool operator()(Maintaining& node) const {
    if (node.with_do) return take_over(node, false);
    ending = {false, std::move(node.condition)};
    Step inner = std::move(*node.step);
    from = std::move(inner);
    return true;
  }
  bool operator()(Watching& node) const { return take_over(node, true); }
  bool operator()(If& node) const { return detach_from(from, node.otherwise ? *node.otherwise : node.step, ending); }
  bool operator()(Unless& node) const { return detach_from(from, node.step, ending); }
  bool operator()(When& node) const { return detach_from(from, node.step, ending); }
  bool operator()(Whenever& node) const { return detach_from(from, node.step, ending); }
  bool operator()(Always& node) const { return detach_from(from, node.step, ending); }
  bool operator()(Repeat& node) const { return detach_from(from, node.step, ending); }
  bool operator()(Next& node) const { return detach_from(from, node.step, ending); }
  // These end with something of their own.
  bool operator()(Goal&) const { return false; }
  bool operator()(ClockStart&) const { return false; }
  bool operator()(Call&) const { return false; }
  bool operator()(Block&) const { return false; }
  bool operator()(Nothing&) const { return false; }
  bool operator()(Each&) const { return false; }
  bool operator()(Choose&) const { return false; }

 private:
  /// An inner `do` gives its ending away where what is inside it has another that does for it.
  template <class Do>
  [[nodiscard]] bool take_over(Do& node, bool watching) const {
    Ending before;
    if (!detach_ending(*node.step, before)) return false;
    ending = {watching, std::move(node.condition)};
    const Span span{from.span.file, from.span.begin, before.condition.span.end};
    Step inner = std::move(*node.step);
    from = ended(std::move(inner), std::move(before));
    from.span = span;
    return true;
  }
};

bool detach_ending(Step& from, Ending& ending) { return std::visit(Detach{from, ending}, from.node); }

/// `do A watching c`, `do A maintaining c`.
struct DoStep : x3::parser<DoStep> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;

  template <class C, class Unused>
  bool parse(Iterator& first, const Iterator& last, const C& context, Step& target, Unused&) const {
    ParseState& state = state_of(context);
    if (!scan_word(first, state, "do")) return false;
    Step inner;
    x3::expect[step].parse(first, last, context, x3::unused, inner);
    Ending ending;
    if (scan_word(first, state, "watching")) {
      ending.watching = true;
      x3::expect[constraint].parse(first, last, context, x3::unused, ending.condition);
    } else if (!detach_ending(inner, ending)) {
      throw x3::expectation_failure<Iterator>(first, "`watching` or `maintaining`");
    }
    target.node = ended(std::move(inner), std::move(ending)).node;
    return true;
  }
};

/// A step and any number of `maintaining c` behind it, each around what stands before it.
template <class Subject>
struct Maintained : x3::parser<Maintained<Subject>> {
  using attribute_type = Step;
  static constexpr bool has_attribute = true;
  Subject subject;
  constexpr explicit Maintained(Subject s) : subject(s) {}

  template <class C, class R>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& unused, Step& all) const {
    if (!subject.parse(first, last, context, unused, all)) return false;
    for (std::size_t levels = 1; scan_word(first, state_of(context), "maintaining"); ++levels) {
      state_of(context).check_depth(first, levels);
      Constraint condition;
      x3::expect[constraint].parse(first, last, context, unused, condition);
      const Span span = join(all.span, condition.span);
      Step inner = std::move(all);
      all = Step{span, Maintaining{std::move(inner), std::move(condition), false}};
    }
    return true;
  }
};

const Rule<struct GoalId, Goal> goal{"a goal"};
const Rule<struct ClockStartId, ClockStart> clock_start{"a clock start"};
const Rule<struct ArgumentId, Argument> argument{"an argument"};
const Rule<struct CallId, Call> call{"a call"};
const Rule<struct SequenceId, Sequence> sequence{"a step"};
const Rule<struct BlockId, Block> block{"a block"};
const Rule<struct NothingId, Nothing> nothing{"`{ }`"};
const Rule<struct EachId, Each> each{"`each`"};
const Rule<struct IfId, If> if_{"`if`"};
const Rule<struct UnlessId, Unless> unless{"`unless`"};
const Rule<struct WhenId, When> when{"`when`"};
const Rule<struct WheneverId, Whenever> whenever{"`whenever`"};
const Rule<struct AlwaysId, Always> always{"`always`"};
const Rule<struct RepeatId, Repeat> repeat{"`repeat`"};
const Rule<struct NextId, Next> next{"`next`"};
const Rule<struct ChoiceId, Choice> choice{"an alternative"};
const Rule<struct ChooseId, Choose> choose{"`choose`"};
const Rule<struct SimpleStepId, Step> simple_step{"a step"};

const auto goal_def = record[field<&Goal::constraint>[constraint]];

const auto clock_start_def = record[field<&ClockStart::clock>[name] >> equals >> &number > zero];

// What is known is a constraint, as it is everywhere, and no name or call.
const auto known = Keyword("surprise") | Keyword("noplan") | Keyword("possible") | Keyword("likely");
const auto argument_def =
    record[(!known >> field<&Argument::node>[name] >> &(comma | close_paren)) | field<&Argument::node>[constraint]];

const auto call_def =
    record[!(known >> open_paren) >> field<&Call::definition>[name] >> open_paren >>
           (close_paren | (x3::expect[append<&Call::arguments>[argument]] >>
                           *(comma > append<&Call::arguments>[argument]) > named("`,` or `)`", close_paren)))];

const auto block_def = record[open_brace > field<&Block::body>[body] > close_brace];

const auto nothing_def = record[open_brace >> close_brace];

// A component may be called `each` or `repeat`: then a relation follows.
const auto each_def = record[(Keyword("each") >> open_brace) > field<&Each::body>[body] > close_brace];

const auto if__def = record[Keyword("if") > field<&If::condition>[constraint] > Keyword("thennext") >
                            field<&If::step>[step] > -(Keyword("elsenext") > field<&If::otherwise>[step])];

const auto unless_def = record[Keyword("unless") > field<&Unless::condition>[constraint] > Keyword("thennext") >
                               field<&Unless::step>[step]];

const auto when_def =
    record[Keyword("when") > field<&When::condition>[constraint] > Keyword("donext") > field<&When::step>[step]];

const auto whenever_def = record[Keyword("whenever") > field<&Whenever::condition>[constraint] > Keyword("donext") >
                                 field<&Whenever::step>[step]];

const auto always_def = record[Keyword("always") > field<&Always::step>[step]];

const auto repeat_def = record[(Keyword("repeat") >> !relation) > field<&Repeat::step>[step]];

const auto next_def = record[Keyword("next") > field<&Next::step>[step]];

const auto choice_def =
    record[field<&Choice::step>[step] > Keyword("with") > field<&Choice::probability>[signed_number]];

const auto choose_def = record[Keyword("choose") > open_brace > comma_list(append<&Choose::choices>[choice]) >
                               named("`,` or `}`", close_brace)];

const auto simple_step_def =
    record[DoStep{} | field<&Step::node>[if_] | field<&Step::node>[unless] | field<&Step::node>[when] |
           field<&Step::node>[whenever] | field<&Step::node>[always] | field<&Step::node>[repeat] |
           field<&Step::node>[next] | field<&Step::node>[choose] | field<&Step::node>[nothing] |
           field<&Step::node>[each] | field<&Step::node>[block] | field<&Step::node>[call] |
           field<&Step::node>[clock_start] | field<&Step::node>[goal]];

const auto step_def = nested[Maintained<decltype(simple_step)>(simple_step)];

// Each step of a sequence recovers by itself, and so does what follows it.
const auto step_end =
    recovering<Resume::at_semicolon>[named("`;`, `,` or `}`", &(semicolon | comma | close_brace | end_of_text))];
const auto slot = recovering<Resume::at_semicolon>[append<&Sequence::steps>[step]] >> step_end;

const auto sequence_def = record[slot >> *(semicolon >> !(close_brace | end_of_text) >> slot)];

const auto body_def =
    record[append<&Body::threads>[sequence] >> *(comma >> append<&Body::threads>[sequence]) >> -semicolon];

BOOST_SPIRIT_DEFINE(goal, clock_start, argument, call, sequence, block, nothing, each, repeat, if_, unless, when,
                    whenever, always, next)
BOOST_SPIRIT_DEFINE(choice, choose, simple_step)

}  // namespace

BOOST_SPIRIT_DEFINE(step, body)
BOOST_SPIRIT_INSTANTIATE(decltype(step), Iterator, Context)
BOOST_SPIRIT_INSTANTIATE(decltype(body), Iterator, Context)

}  // namespace rmpl::grammar
