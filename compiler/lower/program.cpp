// RMPL becomes THCA: one function a construct, as in thesis Fig. 5-2 and the table of semantics 2. Each makes a
// fragment of the draft; sequence joins the ends of one to the starts of the next.
// SPDX-License-Identifier: MIT
#include "compiler/lower/program.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "compiler/check/probabilities.hpp"
#include "compiler/lower/draft.hpp"
#include "compiler/lower/expansions.hpp"
#include "compiler/lower/program_resolver.hpp"

namespace rmpl::compiler {

using automata::Condition;
using automata::Formula;
using automata::LocationId;
using grammar::Code;

namespace {

/// Steps within steps, through calls: recursion stays this far from the end of the stack.
constexpr std::size_t depth_limit = 500;

/// A condition or constraint costs as much as a location for so many atoms and connectives.
constexpr std::size_t atoms_a_unit = 4;

/// An argument that calls double on and on is caught while it is still small.
constexpr std::size_t argument_limit = 1 << 16;

/// How much a condition holds once its parameters are replaced.
std::size_t size_of(const Formula& formula) {
  std::size_t size = 1;
  for (const Formula& operand : formula.operands) size += size_of(operand);
  return size;
}

/// One error in a definition comes back with each call of it.
constexpr std::size_t error_limit = 1000;

/// A `choose` under construction; what it starts may still be an expansion.
struct Choice {
  LocationId location;
  std::vector<std::vector<Target>> starts;  ///< per branch
  std::vector<double> probabilities;        ///< per branch
};

class ProgramLowering {
 public:
  ProgramLowering(const grammar::Sources& sources, const Definitions& definitions, const Recursion& recursion,
                  std::size_t entry, Purpose purpose, const Part* plant, std::vector<bool>& reached,
                  grammar::Diagnostics& diagnostics)
      : definitions_(definitions),
        recursion_(recursion),
        entry_(entry),
        purpose_(purpose),
        reached_(reached),
        diagnostics_(diagnostics),
        errors_before_(diagnostics.error_count()),
        model_(definitions.model),
        resolver_(program_, model_, plant, diagnostics),
        draft_(sources, definitions.all[entry].definition->name, program_, diagnostics),
        expansions_(definitions, recursion) {}

  LoweredProgram run() {
    const grammar::Definition& definition = *definitions_.all[entry_].definition;
    Environment environment;
    for (const grammar::Name& parameter : definition.parameters)
      environment.parameters.emplace(parameter.text, Anything{});
    resolver_.enter(&environment);
    program_.name = definition.name.text;
    const LocationId whole = draft_.composite(definition.name.text + "()", definition.name.span, {});
    expand(entry_, "", whole, environment);
    if (purpose_ == Purpose::run) resolver_.check_values();
    if (draft_.complete()) connect();
    return {std::move(program_), {draft_.take_spans(), std::move(conditions_)}, std::move(parts_), draft_.complete()};
  }

 private:
  void connect() {
    draft_.connect();
    for (const Choice& choice : choices_) {
      std::vector<Branch>& branches = parts_.choices[choice.location];
      for (std::size_t b = 0; b < choice.starts.size(); ++b)
        branches.push_back({choice.probabilities[b], draft_.locations(choice.starts[b])});
    }
  }

  // Conditions.

  Condition condition(const grammar::Constraint& constraint, bool entailed, const char* construct) {
    Condition made{entailed, resolver_.resolve(constraint)};
    draft_.grow(size_of(made.constraint) / atoms_a_unit, constraint.span);
    if (purpose_ == Purpose::run) conditions_.push_back({constraint.span, construct, made.constraint});
    return made;
  }

  static Condition opposite(const Condition& condition) { return {!condition.entailed, condition.constraint}; }

  [[nodiscard]] std::string text(const Condition& condition) const {
    return automata::to_text(condition.constraint, program_.variables, program_.clocks);
  }

  // Constructs.

  /// A body: a block of parallel threads, or what is within the only braces. `whole`: it is the whole of a composite.
  Fragment body(const grammar::Body& body, bool whole) {
    if (body.threads.size() == 1) return sequence(body.threads.front(), whole);
    if (whole) return threads(body);
    const LocationId block = draft_.composite("{ … , … }", body.span, {});
    return draft_.inside(block, [&] { return threads(body); });
  }

  Fragment threads(const grammar::Body& body) {
    Fragment all;
    for (const grammar::Sequence& thread : body.threads) {
      Fragment one = sequence(thread, false);
      std::move(one.starts.begin(), one.starts.end(), std::back_inserter(all.starts));
      std::move(one.ends.begin(), one.ends.end(), std::back_inserter(all.ends));
    }
    return all;
  }

  Fragment sequence(const grammar::Sequence& sequence, bool whole) {
    Fragment all;
    for (std::size_t s = 0; s < sequence.steps.size(); ++s) {
      Fragment next = step(sequence.steps[s], whole && sequence.steps.size() == 1);
      for (const End& end : all.ends) draft_.arcs(end.location, end.guard, next.starts);
      if (s == 0) all.starts = std::move(next.starts);
      all.ends = std::move(next.ends);
    }
    return all;
  }

  Fragment step(const grammar::Step& s, bool whole) {
    if (!draft_.complete()) return {};
    if (++depth_ > depth_limit) {
      return abandon(Code::nesting_too_deep, s.span, "steps and calls nest deeper than " + std::to_string(depth_limit));
    }
    if (diagnostics_.error_count() - errors_before_ > error_limit) {
      return abandon(Code::too_many_errors, s.span, "too many errors: the rest is not looked at");
    }
    Fragment made = std::visit([&](const auto& node) { return lower(node, s.span, whole); }, s.node);
    --depth_;
    return made;
  }

  Fragment abandon(Code code, grammar::Span span, std::string reason) {
    draft_.abandon(code, span, std::move(reason));
    return {};
  }

  Fragment lower(const grammar::Goal& goal, grammar::Span span, bool) {
    constexpr std::size_t bytes_a_unit = 32;
    draft_.grow((span.end - span.begin) / bytes_a_unit, span);
    if (model_) return told(resolver_.resolve(goal.constraint), span);
    auto [modes, constraints] = resolver_.goal(goal.constraint);
    for (const Formula& constraint : constraints) draft_.grow(size_of(constraint) / atoms_a_unit, span);
    const LocationId id = draft_.location("", span);
    draft_[id].goal = std::move(modes);
    draft_[id].goal_constraints = std::move(constraints);
    draft_[id].label = automata::to_text(automata::goal_of(draft_[id]), program_.variables);
    return primitive(id);
  }

  Fragment told(Formula constraint, grammar::Span span) {
    draft_.grow(size_of(constraint) / atoms_a_unit, span);
    const LocationId id = draft_.location(automata::to_text(constraint, program_.variables), span);
    parts_.told.emplace(id, std::move(constraint));
    return primitive(id);
  }

  Fragment lower(const grammar::ClockStart& start, grammar::Span span, bool) {
    if (model_) {
      resolver_.report_clock(start.clock);
      return primitive(draft_.location(start.clock.text + " = 0", span));
    }
    const auto clock = resolver_.start(start.clock);
    const LocationId id = draft_.location((clock ? program_.clocks[clock->index()] : start.clock.text) + " = 0", span);
    draft_[id].clock_start = clock;
    return primitive(id);
  }

  static Fragment primitive(LocationId id) { return {{target(id)}, {{id, {}}}}; }

  Fragment lower(const grammar::Block& block, grammar::Span, bool whole) { return body(block.body, whole); }

  /// An empty location: it asserts nothing, and takes a cycle.
  Fragment lower(const grammar::Nothing&, grammar::Span span, bool) {
    if (model_) return told(automata::constant(true), span);
    return primitive(draft_.location("{ }", span));
  }

  /// A composite of composites, of which each holds a thread and has goals of its own.
  Fragment lower(const grammar::Each& each, grammar::Span span, bool) {
    const LocationId all = draft_.composite("each { … }", span, {});
    return draft_.inside(all, [&] {
      Fragment branches;
      for (const grammar::Sequence& thread : each.body.threads) {
        const LocationId branch = draft_.composite("branch of each", thread.span, {});
        draft_[branch].apart = true;
        Fragment one = draft_.inside(branch, [&] { return sequence(thread, true); });
        std::move(one.starts.begin(), one.starts.end(), std::back_inserter(branches.starts));
        std::move(one.ends.begin(), one.ends.end(), std::back_inserter(branches.ends));
      }
      return branches;
    });
  }

  Fragment lower(const grammar::Watching& watching, grammar::Span span, bool) {
    Condition maintained = condition(watching.condition, false, "watching");
    const std::string label = "do … watching " + text(maintained);
    const LocationId id = draft_.composite(label, span, std::move(maintained));
    return draft_.inside(id, [&] { return step(*watching.step, true); });
  }

  Fragment lower(const grammar::Maintaining& maintaining, grammar::Span span, bool) {
    Condition maintained = condition(maintaining.condition, true, "maintaining");
    const std::string label = "do … maintaining " + text(maintained);
    const LocationId id = draft_.composite(label, span, std::move(maintained));
    return draft_.inside(id, [&] { return step(*maintaining.step, true); });
  }

  /// An empty location with a guarded transition to the starts of A; where the guard fails, the construct ends there.
  Fragment branch(const char* keyword, Condition guard, const grammar::Step& then, grammar::Span span) {
    const LocationId id = draft_.location(keyword + text(guard), span);
    Fragment inner = step(then, false);
    draft_.arcs(id, guard, inner.starts);
    inner.ends.push_back({id, opposite(guard)});
    return {{target(id)}, std::move(inner.ends)};
  }

  Fragment lower(const grammar::If& conditional, grammar::Span span, bool) {
    Condition guard = condition(conditional.condition, true, "if");
    if (!conditional.otherwise) return branch("if ", std::move(guard), *conditional.step, span);
    const LocationId id = draft_.location("if " + text(guard), span);
    Fragment then = step(*conditional.step, false);
    draft_.arcs(id, guard, then.starts);
    Fragment otherwise = step(**conditional.otherwise, false);
    draft_.arcs(id, opposite(guard), otherwise.starts);
    std::move(otherwise.ends.begin(), otherwise.ends.end(), std::back_inserter(then.ends));
    return {{target(id)}, std::move(then.ends)};
  }

  Fragment lower(const grammar::Unless& unless, grammar::Span span, bool) {
    return branch("unless ", condition(unless.condition, false, "unless"), *unless.step, span);
  }

  Fragment lower(const grammar::When& when, grammar::Span span, bool) {
    const Condition guard = condition(when.condition, true, "when");
    const LocationId id = draft_.location("when " + text(guard), span);
    draft_.arc(id, opposite(guard), target(id));
    Fragment inner = step(*when.step, false);
    draft_.arcs(id, guard, inner.starts);
    return {{target(id)}, std::move(inner.ends)};
  }

  Fragment lower(const grammar::Whenever& whenever, grammar::Span span, bool) {
    const Condition guard = condition(whenever.condition, true, "whenever");
    const LocationId id = draft_.location("whenever " + text(guard), span);
    draft_.arc(id, {}, target(id));
    draft_.arcs(id, guard, step(*whenever.step, false).starts);
    return {{target(id)}, {}};
  }

  Fragment lower(const grammar::Always& always, grammar::Span span, bool) {
    const LocationId id = draft_.location("always", span);
    draft_.arc(id, {}, target(id));
    Fragment inner = step(*always.step, false);
    draft_.arcs(id, {}, inner.starts);
    inner.starts.insert(inner.starts.begin(), target(id));
    return {std::move(inner.starts), {}};
  }

  /// Where A ends it starts again.
  Fragment lower(const grammar::Repeat& repeat, grammar::Span, bool) {
    Fragment inner = step(*repeat.step, false);
    for (const End& end : inner.ends) draft_.arcs(end.location, end.guard, inner.starts);
    return {std::move(inner.starts), {}};
  }

  Fragment lower(const grammar::Next& next, grammar::Span span, bool) {
    const LocationId id = draft_.location("next", span);
    Fragment inner = step(*next.step, false);
    draft_.arcs(id, {}, inner.starts);
    return {{target(id)}, std::move(inner.ends)};
  }

  /// In a model program one location, which comes before what its branches hold; they start as it is drawn. In a
  /// control program it is reported, and its steps are looked at for their own errors.
  Fragment lower(const grammar::Choose& choose, grammar::Span span, bool) {
    Fragment all;
    Choice made{LocationId(0), {}, probabilities(choose, span)};
    if (model_) made.location = draft_.location("choose", span);
    for (const grammar::Choice& choice : choose.choices) {
      Fragment one = step(choice.step, false);
      draft_.grow(one.starts.size(), span);
      made.starts.push_back(std::move(one.starts));
      std::move(one.ends.begin(), one.ends.end(), std::back_inserter(all.ends));
    }
    if (!model_) return {};
    all.starts = {target(made.location)};
    choices_.push_back(std::move(made));
    return all;
  }

  /// Per branch; all 0 where they are wrong.
  std::vector<double> probabilities(const grammar::Choose& choose, grammar::Span span) {
    std::vector<const grammar::Number*> numbers;
    for (const grammar::Choice& choice : choose.choices) numbers.push_back(&choice.probability);
    const auto result =
        model_ ? probabilities_of(numbers, span, Code::choice_distribution, "branch", diagnostics_) : std::nullopt;
    return result.value_or(std::vector<double>(numbers.size(), 0));
  }

  // Calls.

  Fragment lower(const grammar::Call& call, grammar::Span span, bool) {
    const auto site = definitions_.callees.find(&call);
    if (site == definitions_.callees.end() || recursion_.cut.count(&call) != 0) return {};  // an error, reported
    const std::size_t callee = site->second;
    if (purpose_ == Purpose::check && reached_[callee] && !expansions_.is_open(callee)) return {};
    const Environment* caller = resolver_.environment();
    Environment& environment = environments_.emplace_back();
    std::string arguments = pass(call, *definitions_.all[callee].definition, environment);
    if (arguments.size() > argument_limit) {
      environments_.pop_back();
      return abandon(Code::too_large, span,
                     "the arguments of this call grow beyond " + std::to_string(argument_limit) + " characters");
    }
    if (const auto back = expansions_.to_lead_to(call, callee, arguments)) {
      environments_.pop_back();
      return {{{true, *back}}, {}};
    }
    resolver_.enter(&environment);
    Fragment made;
    if (const auto onward = forwarded(callee)) {
      made = {{{true, *onward}}, {}};
    } else {
      const LocationId id = draft_.composite(call.definition.text + "(" + arguments + ")", span, {});
      made = expand(callee, std::move(arguments), id, environment);
    }
    resolver_.enter(caller);
    environments_.pop_back();
    return made;
  }

  std::string pass(const grammar::Call& call, const grammar::Definition& callee, Environment& environment) {
    std::string text;
    environment.call = &call;
    for (std::size_t a = 0; a < call.arguments.size(); ++a) {
      Passed passed = resolver_.pass(call.arguments[a]);
      if (a > 0) text += ", ";
      if (const auto* name = std::get_if<grammar::Name>(&passed)) text += name->text;
      if (const auto* constraint = std::get_if<PassedConstraint>(&passed)) text += constraint->text;
      if (std::holds_alternative<Anything>(passed)) text += "…";
      environment.parameters.emplace(callee.parameters[a].text, std::move(passed));
    }
    return text;
  }

  /// A definition that consists of one call that leads back: a composite for it would have nothing inside, so the call
  /// leads back directly. The environment in use is that of the definition.
  std::optional<std::size_t> forwarded(std::size_t definition) {
    if (!recursion_.recursive[recursion_.group[definition]]) return std::nullopt;
    const auto& calls = definitions_.all[definition].calls;
    if (calls.size() != 1 || !calls.front().whole) return std::nullopt;
    const CallSite& onward = calls.front();
    if (recursion_.cut.count(onward.call) != 0) return std::nullopt;
    const Environment* own = resolver_.environment();
    Environment& environment = environments_.emplace_back();
    const std::string arguments = pass(*onward.call, *definitions_.all[onward.callee].definition, environment);
    auto found = expansions_.open_one(onward.callee, arguments);
    if (!found) {
      resolver_.enter(&environment);
      found = forwarded(onward.callee);
      resolver_.enter(own);
    }
    environments_.pop_back();
    return found;
  }

  /// The environment is that of the expansion. A tail call of a definition with clocks of its own enters the composite
  /// anew, for it finds them inactive; any other leads to its starts, which marks the same. In a model program every
  /// call enters the composite.
  Fragment expand(std::size_t definition, std::string arguments, LocationId composite, Environment& environment) {
    const std::size_t expansion = draft_.open_expansion();
    expansions_.open(expansion, definition, std::move(arguments));
    reached_[definition] = true;
    const grammar::Definition& text = *definitions_.all[definition].definition;
    add_own_clocks(text, composite, environment);
    std::vector<Target> starts;
    Fragment made = draft_.inside(composite, [&] {
      Fragment inner = body(text.body, true);
      starts = inner.starts;
      return inner;
    });
    if (model_ || !text.clocks.empty()) starts = made.starts;
    draft_.close_expansion(expansion, std::move(starts));
    expansions_.close();
    return made;
  }

  /// Each expansion has clocks of its own, called after its composite: `t@2` is the `t` of location 2.
  void add_own_clocks(const grammar::Definition& definition, LocationId composite, Environment& environment) {
    for (const grammar::Name& declared : definition.clocks) {
      if (model_) {
        resolver_.report_clock(declared);
        continue;
      }
      const std::string unique = declared.text + "@" + std::to_string(composite.index() + 1);
      if (const auto clock = resolver_.own(declared, unique)) {
        environment.clocks.emplace(declared.text, grammar::Name{declared.span, unique});
        draft_[composite].own_clocks.push_back(*clock);
      }
    }
  }

  const Definitions& definitions_;
  const Recursion& recursion_;
  const std::size_t entry_;
  const Purpose purpose_;
  std::vector<bool>& reached_;
  grammar::Diagnostics& diagnostics_;
  const std::size_t errors_before_;
  const bool model_;
  automata::Program program_;
  ProgramResolver resolver_;
  Draft draft_;
  std::vector<PlacedCondition> conditions_;
  std::vector<Choice> choices_;
  ModelParts parts_;
  Expansions expansions_;                 ///< as the draft numbers them
  std::deque<Environment> environments_;  ///< of the open expansions; a deque, for they are referred to
  std::size_t depth_ = 0;
};

}  // namespace

LoweredProgram lower_program(const grammar::Sources& sources, const Definitions& definitions,
                             const Recursion& recursion, std::size_t entry, Purpose purpose, const Part* plant,
                             std::vector<bool>& reached, grammar::Diagnostics& diagnostics) {
  return ProgramLowering(sources, definitions, recursion, entry, purpose, plant, reached, diagnostics).run();
}

}  // namespace rmpl::compiler
