// Which clocks a program reads before any path can have started them.
// SPDX-License-Identifier: MIT
#include "compiler/check/clocks.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/overloaded.hpp"
#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Span;

namespace {

/// What a step does with clocks: which it reads before it has started them itself, and which it may start. Parameters
/// count among the names of clocks.
struct Summary {
  std::map<std::string, std::vector<Span>> needs;
  std::set<std::string> starts;
  /// Parameters that stand for constraints: what their arguments read, the step reads, each time after it may have
  /// started these clocks.
  std::map<std::string, std::set<std::string>> asks;
};

/// Adds `more`; the larger set stays in place, so that a long way up costs little.
void merge(Summary& into, Summary more) {
  if (into.starts.size() < more.starts.size()) std::swap(into.starts, more.starts);
  into.starts.merge(more.starts);
  for (auto& [parameter, started] : more.asks) {
    const auto [known, fresh] = into.asks.try_emplace(parameter, started);
    if (!fresh)
      std::erase_if(known->second,
                    [&known_starts = started](const auto& clock) { return known_starts.count(clock) == 0; });
  }
  if (into.needs.size() < more.needs.size()) std::swap(into.needs, more.needs);
  for (auto& [clock, spans] : more.needs) {
    auto& known = into.needs[clock];
    known.insert(known.end(), spans.begin(), spans.end());
  }
}

void satisfy(Summary& summary, const std::set<std::string>& started) {
  std::erase_if(summary.needs, [&](const auto& need) { return started.count(need.first) != 0; });
  for (auto& [parameter, before] : summary.asks) before.insert(started.begin(), started.end());
}

class Summaries {
 public:
  Summaries(const Definitions& definitions, const Recursion& recursion)
      : definitions_(definitions), recursion_(recursion), summaries_(definitions.all.size()) {
    for (std::size_t group = 0; group < recursion.members.size(); ++group) close(group);
  }

  [[nodiscard]] const Summary& operator[](std::size_t definition) const { return summaries_[definition]; }

  /// A clock of a definition's own that is read where no path of an activation has started it.
  struct Unstarted {
    std::size_t definition;
    std::string clock;
    std::vector<Span> reads;
  };
  std::vector<Unstarted> unstarted;

 private:
  /// The members of a set of definitions that call each other form a loop: what one starts, another may read later.
  void close(std::size_t group) {
    const auto& members = recursion_.members[group];
    for (const std::size_t d : members) {
      caller_ = d;
      Summary whole = body(definitions_.all[d].definition->body);
      take_own(d, whole);
      summaries_[d] = std::move(whole);
    }
    if (members.size() == 1) return satisfy_own(summaries_[members.front()], recursion_.recursive[group]);
    Summary all;
    for (const std::size_t d : members) merge(all, summaries_[d]);
    satisfy(all, all.starts);
    std::set<std::string> parameters;
    for (const std::size_t d : members) {
      for (const grammar::Name& parameter : definitions_.all[d].definition->parameters)
        parameters.insert(parameter.text);
    }
    satisfy(all, parameters);
    for (const std::size_t d : members) summaries_[d] = all;
  }

  /// What concerns the clocks of a definition's own stays in it; those that it reads before it starts them are noted.
  void take_own(std::size_t d, Summary& summary) {
    for (const grammar::Name& clock : definitions_.all[d].definition->clocks) {
      const std::string name = own(clock.text);
      const auto needed = summary.needs.find(name);
      if (needed != summary.needs.end()) unstarted.push_back({d, clock.text, needed->second});
      if (needed != summary.needs.end()) summary.needs.erase(needed);
      summary.starts.erase(name);
      for (auto& [parameter, before] : summary.asks) before.erase(name);
    }
  }

  static void satisfy_own(Summary& summary, bool recursive) {
    if (recursive) satisfy(summary, summary.starts);
  }

  Summary body(const grammar::Body& body) {
    std::vector<Summary> threads;
    for (const grammar::Sequence& thread : body.threads) threads.push_back(sequence(thread));
    // A thread is helped by the starts of every other; its own have been looked at in order.
    std::map<std::string, std::size_t> starters;
    for (const Summary& thread : threads) {
      for (const std::string& clock : thread.starts) ++starters[clock];
    }
    Summary result;
    for (Summary& thread : threads) {
      std::set<std::string> others;
      for (const auto& [clock, threads_that_start] : starters) {
        if (threads_that_start > thread.starts.count(clock)) others.insert(clock);
      }
      satisfy(thread, others);
      merge(result, std::move(thread));
    }
    return result;
  }

  Summary sequence(const grammar::Sequence& sequence) {
    Summary result;
    for (const grammar::Step& s : sequence.steps) {
      Summary next = step(s);
      satisfy(next, result.starts);
      merge(result, std::move(next));
    }
    return result;
  }

  Summary guarded(const grammar::Constraint& condition, const grammar::Step& body) {
    Summary result = reads(condition);
    merge(result, step(body));
    return result;
  }

  static Summary looped(Summary summary) {
    satisfy(summary, summary.starts);
    return summary;
  }

  /// A maintained condition is asked while the body runs, so after what the body starts.
  Summary around(const grammar::Step& body, const grammar::Constraint& condition) {
    Summary inner = step(body);
    Summary asked = reads(condition);
    satisfy(asked, inner.starts);
    merge(inner, std::move(asked));
    return inner;
  }

  Summary step(const grammar::Step& s) {
    return std::visit(
        base::Overloaded{
            [](const grammar::Goal&) { return Summary{}; },
            [&](const grammar::ClockStart& c) {
              return Summary{{}, {own(c.clock.text)}, {}};
            },
            [&](const grammar::Call& c) { return call(c); }, [&](const grammar::Block& b) { return body(b.body); },
            [&](const grammar::Watching& w) { return around(*w.step, w.condition); },
            [&](const grammar::Maintaining& m) { return around(*m.step, m.condition); },
            [&](const grammar::If& i) {
              Summary result = guarded(i.condition, *i.step);
              if (i.otherwise) merge(result, step(**i.otherwise));
              return result;
            },
            [&](const grammar::Unless& u) { return guarded(u.condition, *u.step); },
            [&](const grammar::When& w) { return guarded(w.condition, *w.step); },
            [&](const grammar::Whenever& w) { return looped(guarded(w.condition, *w.step)); },
            [](const grammar::Nothing&) { return Summary{}; }, [&](const grammar::Each& e) { return body(e.body); },
            [&](const grammar::Repeat& r) { return looped(step(*r.step)); },
            [&](const grammar::Always& a) { return looped(step(*a.step)); },
            [&](const grammar::Next& n) { return step(*n.step); },
            [&](const grammar::Choose& c) {
              Summary result;
              for (const grammar::Choice& choice : c.choices) merge(result, step(choice.step));
              return result;
            }},
        s.node);
  }

  /// The summary of the callee with arguments for parameters. A call within a loop of definitions adds nothing: `close`
  /// sees to it.
  Summary call(const grammar::Call& c) {
    const auto known = definitions_.by_name.find(c.definition.text);
    if (known == definitions_.by_name.end()) return {};
    const grammar::Definition& callee = *definitions_.all[known->second].definition;
    if (callee.parameters.size() != c.arguments.size()) return {};
    if (recursion_.group[known->second] == recursion_.group[caller_]) return {};
    Summary result = summaries_[known->second];
    result.asks.clear();
    std::vector<bool> needed;
    std::vector<bool> started;
    for (const grammar::Name& parameter : callee.parameters) {
      needed.push_back(result.needs.erase(parameter.text) != 0);
      started.push_back(result.starts.erase(parameter.text) != 0);
    }
    // The names that the callee's clocks have here.
    const auto here = [&](const std::set<std::string>& clocks) {
      std::set<std::string> names = clocks;
      for (std::size_t a = 0; a < c.arguments.size(); ++a) {
        const auto* name = std::get_if<grammar::Name>(&c.arguments[a].node);
        if (name != nullptr && names.erase(callee.parameters[a].text) != 0) names.insert(own(name->text));
      }
      return names;
    };
    for (std::size_t a = 0; a < c.arguments.size(); ++a) {
      const auto ask = summaries_[known->second].asks.find(callee.parameters[a].text);
      const bool asked = ask != summaries_[known->second].asks.end();
      if (const auto* name = std::get_if<grammar::Name>(&c.arguments[a].node)) {
        if (started[a]) result.starts.insert(own(name->text));
        if (needed[a]) result.needs[own(name->text)].push_back(name->span);
        if (!asked || !is_parameter(name->text)) continue;
        Summary passed_on;
        passed_on.asks.emplace(name->text, here(ask->second));
        merge(result, std::move(passed_on));
      } else if (asked) {
        Summary read = reads(std::get<grammar::Constraint>(c.arguments[a].node));
        satisfy(read, here(ask->second));
        merge(result, std::move(read));
      }
    }
    return result;
  }

  /// The clocks that a constraint reads.
  Summary reads(const grammar::Constraint& constraint) {
    Summary result;
    collect(constraint, result);
    return result;
  }

  void collect(const grammar::Constraint& constraint, Summary& into) {
    const auto all = [&](const auto& connective) {
      for (const grammar::Constraint& operand : connective.operands) collect(operand, into);
    };
    std::visit(base::Overloaded{
                   [](const grammar::Truth&) {},
                   [&](const grammar::Reference& r) {
                     if (is_parameter(r.name.text)) into.asks.try_emplace(r.name.text);
                   },
                   [](const grammar::Comparison&) {}, [](const grammar::Membership&) {},
                   [&](const grammar::ClockBound& b) { into.needs[own(b.clock.text)].push_back(b.clock.span); },
                   [&](const grammar::KnowledgeAtom& k) { all(k); }, [&](const grammar::Negation& n) { all(n); },
                   [&](const grammar::Conjunction& c) { all(c); }, [&](const grammar::Disjunction& d) { all(d); },
                   [&](const grammar::Implication& i) { all(i); }, [&](const grammar::Equivalence& e) { all(e); }},
               constraint.node);
  }

  [[nodiscard]] bool is_parameter(const std::string& name) const {
    const auto& parameters = definitions_.all[caller_].definition->parameters;
    return std::any_of(parameters.begin(), parameters.end(), [&](const grammar::Name& p) { return p.text == name; });
  }

  /// The name of a clock in the summaries: that of a definition's own is none that another could have.
  [[nodiscard]] std::string own(const std::string& name) const {
    const auto& clocks = definitions_.all[caller_].definition->clocks;
    const bool found =
        std::any_of(clocks.begin(), clocks.end(), [&](const grammar::Name& clock) { return clock.text == name; });
    return found ? name + "@" : name;
  }

  const Definitions& definitions_;
  const Recursion& recursion_;
  std::vector<Summary> summaries_;
  std::size_t caller_ = 0;
};

/// The places at which clocks are started, by name; and the names of clocks.
class Starts {
 public:
  explicit Starts(const Definitions& definitions) {
    for (const Definitions::Entry& entry : definitions.all) body(entry.definition->body);
  }

  std::map<std::string, Span> first;

 private:
  void body(const grammar::Body& body) {
    for (const grammar::Sequence& thread : body.threads) {
      for (const grammar::Step& s : thread.steps) step(s);
    }
  }

  void step(const grammar::Step& s) {
    std::visit(base::Overloaded{[](const grammar::Goal&) {}, [](const grammar::Call&) {},
                                [&](const grammar::ClockStart& c) { first.emplace(c.clock.text, c.clock.span); },
                                [](const grammar::Nothing&) {}, [&](const grammar::Each& e) { body(e.body); },
                                [&](const grammar::Block& b) { body(b.body); },
                                [&](const grammar::If& i) {
                                  step(*i.step);
                                  if (i.otherwise) step(**i.otherwise);
                                },
                                [&](const grammar::Choose& c) {
                                  for (const grammar::Choice& choice : c.choices) step(choice.step);
                                },
                                [&](const auto& with_body) { step(*with_body.step); }},
               s.node);
  }
};

}  // namespace

void check_clocks(const Definitions& definitions, const Recursion& recursion, const std::vector<std::size_t>& roots,
                  grammar::Diagnostics& diagnostics) {
  const Summaries summaries(definitions, recursion);
  for (const auto& [definition, clock, reads] : summaries.unstarted) {
    for (const Span span : reads) {
      auto& error = diagnostics.error(Code::clock_never_started, span,
                                      "clock " + backquoted(clock) + " is read, but nothing in " +
                                          backquoted(definitions.all[definition].definition->name.text) +
                                          " has started it before: each activation finds it inactive");
      error.suggestion = "start it first, with `" + clock + " = 0`";
    }
  }
  const Starts starts(definitions);
  std::vector<std::string> clocks;
  for (const auto& [clock, span] : starts.first) clocks.push_back(clock);
  for (const std::size_t root : roots) {
    const grammar::Definition& definition = *definitions.all[root].definition;
    for (const auto& [clock, spans] : summaries[root].needs) {
      const auto is_it = [&, &name = clock](const grammar::Name& parameter) { return parameter.text == name; };
      if (std::any_of(definition.parameters.begin(), definition.parameters.end(), is_it)) continue;
      for (const Span span : spans) {
        const std::size_t before = diagnostics.error_count();
        const auto start = starts.first.find(clock);
        auto& error = diagnostics.error(Code::clock_never_started, span,
                                        "clock " + backquoted(clock) + " is read, but no path " +
                                            (start == starts.first.end() ? "starts it" : "has started it before"));
        if (start == starts.first.end()) {
          suggest(error, before, clock, clocks);
          if (!error.suggestion) error.suggestion = "start it first, with `" + clock + " = 0`";
        } else {
          error.notes.push_back({start->second, backquoted(clock) + " is started here"});
        }
      }
    }
  }
}

}  // namespace rmpl::compiler
