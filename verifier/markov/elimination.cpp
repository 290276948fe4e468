// Elimination, component by component.
// SPDX-License-Identifier: MIT
#include "verifier/markov/elimination.hpp"

#include <map>
#include <set>

#include "verifier/markov/strong_components.hpp"

namespace rmpl::verifier {

namespace {

/// What a state leads to: others of its component, and the end of a run.
struct Equation {
  std::map<StateNumber, Enclosure> inside;
  Fate end;
};

void add(Fate& to, const Enclosure& factor, const Fate& what) {
  to.wanted = to.wanted + factor * what.wanted;
  to.unknown = to.unknown + factor * what.unknown;
  to.lost = to.lost + factor * what.lost;
  to.time = to.time + factor * what.time;
}

class Elimination {
 public:
  Elimination(const DecisionProcess& chain, const std::vector<Enclosure>& times, Meter& meter)
      : chain_(chain), times_(times), meter_(meter), fates_(chain.size()), solved_(chain.size(), false) {}

  std::vector<Fate> run() {
    const std::vector<bool> hopeful = may_reach(chain_);
    for (std::size_t s = 0; s < chain_.size(); ++s) {
      if (chain_.wanted[s]) fates_[s].wanted = certain();
      if (!hopeful[s]) fates_[s].lost = certain();
      solved_[s] = chain_.wanted[s] || !hopeful[s];
    }
    const auto sets = strong_components(
        chain_, [&](std::size_t s) { return !solved_[s]; }, [](std::size_t, const Row&) { return true; });
    for (const auto& set : sets) solve(set);
    return std::move(fates_);
  }

 private:
  [[nodiscard]] Equation equation_of(StateNumber s) const {
    Equation result;
    const Row& row = chain_.rows[s].front();
    for (const Branch& edge : row.edges) {
      if (solved_[edge.to]) {
        add(result.end, edge.probability, fates_[edge.to]);
      } else {
        Enclosure& own = result.inside[edge.to];
        own = own + edge.probability;
      }
    }
    result.end.unknown = result.end.unknown + Enclosure{0, row.left_out};
    result.end.time = result.end.time + (times_.empty() ? certain() : times_[s]);
    return result;
  }

  /// The equation without the state itself: a run that stays is as one that goes on.
  static void leave(StateNumber s, Equation& equation) {
    const auto own = equation.inside.find(s);
    if (own == equation.inside.end()) return;
    equation.inside.erase(own);
    Enclosure out = equation.end.wanted + equation.end.unknown + equation.end.lost;
    for (const auto& [to, probability] : equation.inside) out = out + probability;
    Fate& end = equation.end;
    const auto scale = [&out](Enclosure& value) {
      if (value.upper > 0) value = as_probability(value / out);
    };
    scale(end.wanted);
    scale(end.unknown);
    scale(end.lost);
    end.time = end.time / out;
    for (auto& [to, probability] : equation.inside) scale(probability);
  }

  void solve(const std::vector<StateNumber>& set) {
    std::map<StateNumber, Equation> equations;
    for (const StateNumber s : set) equations.emplace(s, equation_of(s));
    std::map<StateNumber, std::vector<StateNumber>> before;  // which equations may name a state
    for (const auto& [s, equation] : equations) {
      for (const auto& [to, probability] : equation.inside) before[to].push_back(s);
    }
    for (const StateNumber s : set) {
      meter_.poll();
      Equation& own = equations.at(s);
      leave(s, own);
      // Those that are taken out sooner are filled in at the end.
      for (const StateNumber other : before[s]) {
        if (other == s || gone_.contains(other)) continue;
        Equation& theirs = equations.at(other);
        const auto at = theirs.inside.find(s);
        if (at == theirs.inside.end()) continue;
        const Enclosure through = at->second;
        theirs.inside.erase(at);
        for (const auto& [to, probability] : own.inside) {
          const auto [known, fresh] = theirs.inside.try_emplace(to);
          known->second = known->second + through * probability;
          if (fresh) before[to].push_back(other);
        }
        add(theirs.end, through, own.end);
      }
      gone_.insert(s);
    }
    for (std::size_t i = set.size(); i-- > 0;) {
      const StateNumber s = set[i];
      Equation& own = equations.at(s);
      for (const auto& [to, probability] : own.inside) add(own.end, probability, fates_[to]);
      own.end.wanted = as_probability(own.end.wanted);
      own.end.unknown = as_probability(own.end.unknown);
      own.end.lost = as_probability(own.end.lost);
      fates_[s] = own.end;
      solved_[s] = true;
    }
    gone_.clear();
  }

  const DecisionProcess& chain_;
  const std::vector<Enclosure>& times_;
  Meter& meter_;
  std::vector<Fate> fates_;
  std::vector<bool> solved_;
  std::set<StateNumber> gone_;  ///< of the component at hand
};

}  // namespace

std::vector<Fate> fates(const DecisionProcess& chain, const std::vector<Enclosure>& times, Meter& meter) {
  return Elimination(chain, times, meter).run();
}

}  // namespace rmpl::verifier
