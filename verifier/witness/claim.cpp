// Whether a run shows what it is a witness of: the words of semantics 7, event by event.
// SPDX-License-Identifier: MIT
#include "verifier/witness/claim.hpp"

#include "automata/time/checked_ticks.hpp"
#include "verifier/witness/known.hpp"
#include "verifier/witness/undone.hpp"

namespace rmpl::verifier {

using automata::Formula;
using automata::Ticks;
using Kind = ProgramProperty::Kind;

namespace {

class ClaimRules {
 public:
  ClaimRules(automata::PlainStep& rules, const ClaimTerms& terms, const Witness& witness)
      : rules_(rules),
        store_(rules.store()),
        entailed_(terms.entailed),
        period_(terms.period),
        witness_(witness),
        events_(witness.events),
        repeats_from_(witness.repeats_from),
        stop_(witness.stop) {}

  std::optional<std::string> failure(const Reachability& p) { return reached(p.target, p.window); }
  std::optional<std::string> failure(const Safety& p) { return reached(p.never, p.window); }

  std::optional<std::string> failure(const Stuck&) { return stop_ ? std::nullopt : std::optional("it is not cut off"); }

  std::optional<std::string> failure(const Response& p) {
    return owed_since(p) ? std::nullopt : std::optional("every response on it comes in time");
  }

  /// The event that asks for a response which does not come; where time stands still, never comes.
  std::optional<std::size_t> owed_since(const Response& p) {
    const bool never = goes_on_without_end(p.within);
    for (std::size_t e = 0; e < events_.size(); ++e) {
      // Under a program: asked for up to its end, the state that it ends in included.
      if (events_[e].cycle && events_[e].cycle->marking.empty()) return std::nullopt;
      const Ticks deadline =
          never ? Ticks::infinite() : automata::checked_sum(events_[e].time, p.within).value_or(Ticks::infinite());
      if (!holds(p.after, e, entailed_) || (!never && !is_past(deadline))) continue;
      if (never_before(p.then, e, deadline)) return e;
    }
    return std::nullopt;
  }

  std::optional<std::string> failure(const ProgramProperty& p) {
    const Cycle& last = *events_.back().cycle;
    const bool ended = last.marking.empty();
    switch (p.kind) {
      case Kind::goal_conflict:
        return last.conflicts.empty() ? std::optional("its goals agree") : std::nullopt;
      case Kind::no_plan:
        return lacks_a_plan(last) ? std::nullopt : std::optional("there is a plan");
      case Kind::endless_wait:
        return ended ? std::optional("the program has ended") : std::nullopt;
      case Kind::stuck:
        return stop_ ? std::nullopt : std::optional("it is not cut off");
      case Kind::termination:
        if (ended) return "the program has ended";
        return repeats_from_ && !comes_round() ? std::optional("it does not come back to where it repeats")
                                               : std::nullopt;
      case Kind::undone:
        return witness_.undone && undone_at_end(rules_, witness_) == witness_.undone
                   ? std::nullopt
                   : std::optional("nothing that was achieved is taken away at its end");
      case Kind::never:
        return reached(p.formula, p.window);
      case Kind::response:
        return failure(Response{p.formula, p.then, p.within});
      case Kind::eventually:
        if (goes_on_without_end(p.within)) {
          return never_before(p.formula, 0, Ticks::infinite()) ? std::nullopt
                                                               : std::optional("the formula comes to hold");
        }
        if (!is_past(p.within)) return "it ends in time";
        return never_before(p.formula, 0, p.within) ? std::nullopt : std::optional("the formula holds in time");
      case Kind::finally:
        if (!ended) return "the program has not ended";
        return holds(p.formula, events_.size() - 1, !entailed_) ? std::optional("the formula holds at its end")
                                                                : std::nullopt;
    }
    return std::nullopt;
  }

 private:
  std::optional<std::string> reached(const Formula& target, const Window& window) {
    const Ticks end = events_.back().time;
    if (window.not_before && end < *window.not_before) return "it ends too early";
    if (window.by && end > *window.by) return "it ends too late";
    return holds(target, events_.size() - 1, entailed_) ? std::nullopt
                                                        : std::optional("the target does not hold at its end");
  }

  /// Whether no more of the run need be seen than is there: time stands still, or, where any time will do, the run is
  /// cut off, goes round or waits for ever.
  [[nodiscard]] bool goes_on_without_end(Ticks within) const {
    if (stop_ && stop_->still) return true;
    const bool round = repeats_from_ && comes_round();
    return within.is_infinite() && (stop_ || round || witness_.waits_for_ever);
  }

  /// Whether all of the run up to that time is there: nothing follows that could come by then.
  [[nodiscard]] bool is_past(Ticks time) const {
    const Ticks end = events_.back().time;
    if (end > time || !stop_) return end > time;
    return period_ ? end + *period_ > time : end == time;
  }

  /// Whether the formula does not hold in any state from an event on that is entered up to that time.
  bool never_before(const Formula& formula, std::size_t from, Ticks time) {
    for (std::size_t e = from; e < events_.size() && events_[e].time <= time; ++e) {
      if (holds(formula, e, !entailed_)) return false;
    }
    return true;
  }

  [[nodiscard]] bool comes_round() const {
    return events_[*repeats_from_ - 1].modes == events_.back().modes &&
           (!events_.back().cycle || events_[*repeats_from_].cycle->marking == events_.back().cycle->marking);
  }

  /// The store of an event implies the formula, or (not `certain`) allows it.
  bool holds(const Formula& formula, std::size_t event, bool certain) {
    const automata::Modes& modes = events_[event].modes;
    const Formula known = with_knowledge(
        formula, [&](const Formula& atom) { return is_known_after(store_, atom, modes, before(event)); });
    return certain ? store_.implies(known, modes) : store_.allows(known, modes);
  }

  /// What the cycle that led to an event has answered; of the last one, under a program, only its begin is known.
  const Answered* before(std::size_t event) {
    const bool begun = event + 1 == events_.size() && events_[event].cycle;
    const std::size_t at = begun ? event - 1 : event;
    if (!events_[at].cycle) return nullptr;
    const Cycle& cycle = *events_[at].cycle;
    return &answered_.emplace(Answered{cycle.goals, cycle.outcome, cycle.left_out});
  }

  automata::PlainStep& rules_;
  automata::PlainStore& store_;
  bool entailed_;
  std::optional<Ticks> period_;
  const Witness& witness_;
  const std::vector<Event>& events_;
  std::optional<std::size_t> repeats_from_;
  const std::optional<Stop>& stop_;
  std::optional<Answered> answered_;
};

}  // namespace

std::optional<std::size_t> owed_since(automata::PlainStep& rules, const Response& response, const ClaimTerms& terms,
                                      const Witness& witness) {
  return ClaimRules(rules, terms, witness).owed_since(response);
}

std::optional<std::string> failure_to_show(automata::PlainStep& rules, const Property& property,
                                           const ClaimTerms& terms, const Witness& witness) {
  ClaimRules claim(rules, terms, witness);
  return std::visit([&](const auto& asked) { return claim.failure(asked); }, property);
}

}  // namespace rmpl::verifier
