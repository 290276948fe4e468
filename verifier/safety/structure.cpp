// Gates, their order, their diagrams.
// SPDX-License-Identifier: MIT
#include "verifier/safety/structure.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rmpl::verifier {

Structure::Structure() {
  gate(Kind::constant, {0});
  gate(Kind::constant, {1});
}

GateId Structure::gate(Kind kind, std::vector<GateId> inputs) {
  const auto [at, fresh] = numbers_.try_emplace(Gate{kind, std::move(inputs)}, static_cast<GateId>(gates_.size()));
  if (fresh) gates_.push_back(&at->first);
  return at->second;
}

GateId Structure::negation(GateId f) {
  if (f <= one) return f == zero ? one : zero;
  if (gates_[f]->kind == Kind::negation) return gates_[f]->inputs.front();
  return gate(Kind::negation, {f});
}

GateId Structure::equivalence(GateId f, GateId g) {
  if (f == g) return one;
  if (f <= one) return f == one ? g : negation(g);
  if (g <= one) return g == one ? f : negation(f);
  return gate(Kind::equivalence, {std::min(f, g), std::max(f, g)});
}

GateId Structure::junction(Kind kind, std::vector<GateId> inputs) {
  const GateId neutral = kind == Kind::conjunction ? one : zero;
  const GateId decides = kind == Kind::conjunction ? zero : one;
  std::sort(inputs.begin(), inputs.end());
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  std::erase(inputs, neutral);
  if (std::binary_search(inputs.begin(), inputs.end(), decides)) return decides;
  if (inputs.empty()) return neutral;
  if (inputs.size() == 1) return inputs.front();
  return gate(kind, std::move(inputs));
}

/// Simplifies gates by what holds wherever they matter.
class Structure::Simplifier {
 public:
  explicit Simplifier(Structure& gates) : gates_(gates), budget_(most_visits * (gates.gates_.size() + 1)) {}

  GateId run(GateId top) {
    std::vector<Known> nothing;
    return simplified(top, nothing);
  }

 private:
  /// So many visits a gate at most; from then on gates stay as they are.
  static constexpr std::size_t most_visits = 16;
  struct Known {
    std::uint32_t event;
    bool holds;
    auto operator<=>(const Known&) const = default;
  };

  /// The events below a gate, ascending.
  const std::vector<std::uint32_t>& support(GateId g) {
    const auto [at, fresh] = supports_.try_emplace(g);
    if (!fresh) return at->second;
    std::vector<std::uint32_t> result;
    const Gate& own = *gates_.gates_[g];
    if (own.kind == Kind::event) result = own.inputs;
    if (own.kind > Kind::event) {
      for (const GateId input : own.inputs) {
        const std::vector<std::uint32_t>& part = support(input);
        std::vector<std::uint32_t> both;
        std::set_union(result.begin(), result.end(), part.begin(), part.end(), std::back_inserter(both));
        result.swap(both);
      }
    }
    return supports_[g] = std::move(result);
  }

  GateId simplified(GateId g, const std::vector<Known>& context) {
    if (gates_.gates_[g]->kind == Kind::constant || budget_ == 0) return g;
    std::vector<Known> known;
    const std::vector<std::uint32_t>& events = support(g);
    for (const Known& fact : context) {
      if (std::binary_search(events.begin(), events.end(), fact.event)) known.push_back(fact);
    }
    if (gates_.gates_[g]->kind == Kind::event) return known.empty() ? g : known.front().holds ? one : zero;
    const auto key = std::pair{g, known};
    if (const auto at = done_.find(key); at != done_.end()) return at->second;
    --budget_;
    const GateId result = anew(g, std::move(known));
    done_.emplace(key, result);
    return result;
  }

  GateId anew(GateId g, std::vector<Known> known) {
    const Gate own = *gates_.gates_[g];
    if (own.kind == Kind::negation) return gates_.negation(simplified(own.inputs.front(), known));
    if (own.kind == Kind::equivalence) {
      const GateId left = simplified(own.inputs.front(), known);
      return gates_.equivalence(left, simplified(own.inputs.back(), known));
    }
    // Beside an event in a disjunction nothing matters but where the event does not happen.
    const bool holds = own.kind == Kind::conjunction;
    std::vector<GateId> inputs = own.inputs;
    std::vector<GateId> events;
    for (bool found = true; found;) {
      found = false;
      std::vector<GateId> others;
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        const Gate& input = *gates_.gates_[inputs[i]];
        if (input.kind == own.kind) {
          inputs.insert(inputs.end(), input.inputs.begin(), input.inputs.end());
        } else if (input.kind == Kind::event) {
          const Known fact{input.inputs.front(), holds};
          const auto at = std::lower_bound(known.begin(), known.end(), Known{fact.event, false});
          if (at != known.end() && at->event == fact.event) {
            if (at->holds != holds) return holds ? zero : one;
          } else {
            known.insert(at, fact);
            events.push_back(inputs[i]);
            found = true;
          }
        } else {
          others.push_back(inputs[i]);
        }
      }
      inputs.clear();
      for (const GateId input : others) inputs.push_back(simplified(input, known));
      found = found || inputs != others;
    }
    inputs.insert(inputs.end(), events.begin(), events.end());
    return gates_.junction(own.kind, std::move(inputs));
  }

  Structure& gates_;
  std::size_t budget_;
  std::map<GateId, std::vector<std::uint32_t>> supports_;
  std::map<std::pair<GateId, std::vector<Known>>, GateId> done_;
};

GateId Structure::simplified(GateId top) { return Simplifier(*this).run(top); }

std::vector<bool> Structure::below(GateId top) const {
  std::vector<bool> result(top + std::size_t{1}, false);
  result[top] = true;
  for (GateId g = top + 1; g-- > 0;) {
    if (!result[g] || gates_[g]->kind <= Kind::event) continue;
    for (const GateId input : gates_[g]->inputs) result[input] = true;
  }
  return result;
}

std::vector<std::uint32_t> Structure::order(GateId top) const {
  const std::vector<bool> there = below(top);
  std::vector<std::uint32_t> parents(there.size(), 0);
  for (GateId g = 0; g <= top; ++g) {
    if (!there[g] || gates_[g]->kind <= Kind::event) continue;
    for (const GateId input : gates_[g]->inputs) ++parents[input];
  }
  std::vector<std::uint32_t> result;
  std::vector<bool> seen(there.size(), false);
  std::vector<GateId> open{top};
  while (!open.empty()) {
    const GateId g = open.back();
    open.pop_back();
    if (seen[g]) continue;
    seen[g] = true;
    const Gate& own = *gates_[g];
    if (own.kind == Kind::event) result.push_back(own.inputs.front());
    if (own.kind <= Kind::event) continue;
    std::vector<GateId> inputs = own.inputs;
    const auto rank = [&](GateId input) { return std::pair(gates_[input]->kind == Kind::event, ~parents[input]); };
    std::stable_sort(inputs.begin(), inputs.end(), [&](GateId a, GateId b) { return rank(a) < rank(b); });
    open.insert(open.end(), inputs.rbegin(), inputs.rend());
  }
  return result;
}

NodeId Structure::diagram(GateId top, const std::vector<std::uint32_t>& variables, Diagrams& diagrams) const {
  const std::vector<bool> there = below(top);
  std::vector<NodeId> built(top + std::size_t{1}, Diagrams::zero);
  for (GateId g = 0; g <= top; ++g) {
    if (!there[g]) continue;
    const Gate& own = *gates_[g];
    switch (own.kind) {
      case Kind::constant:
        built[g] = g == one ? Diagrams::one : Diagrams::zero;
        break;
      case Kind::event:
        built[g] = diagrams.variable(variables[own.inputs.front()]);
        break;
      case Kind::negation:
        built[g] = diagrams.negation(built[own.inputs.front()]);
        break;
      case Kind::equivalence: {
        const NodeId right = built[own.inputs.back()];
        built[g] = diagrams.choose(built[own.inputs.front()], right, diagrams.negation(right));
        break;
      }
      case Kind::conjunction:
      case Kind::disjunction: {
        // From the bottom up: an operand that stands above all so far is looked through once, and they are not.
        std::vector<NodeId> inputs;
        for (const GateId input : own.inputs) inputs.push_back(built[input]);
        std::stable_sort(inputs.begin(), inputs.end(),
                         [&](NodeId a, NodeId b) { return diagrams.tested(a) > diagrams.tested(b); });
        const bool both = own.kind == Kind::conjunction;
        NodeId all = both ? Diagrams::one : Diagrams::zero;
        for (const NodeId input : inputs)
          all = both ? diagrams.conjunction(input, all) : diagrams.disjunction(input, all);
        built[g] = all;
        break;
      }
    }
  }
  return built[top];
}

}  // namespace rmpl::verifier
