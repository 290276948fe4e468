// Trees to two levels.
// SPDX-License-Identifier: MIT
#include "compiler/lower/draws.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rmpl::compiler {

using automata::InitialBranch;
using automata::LocationId;
using automata::TransitionFunction;

namespace {

/// Start locations in all the functions of a program; nested choices multiply, and this is where it ends.
constexpr std::size_t draws_limit = 1'000'000;

/// What is started together, with a probability.
struct Outcome {
  double probability = 1;
  std::vector<LocationId> started;
};
using Outcomes = std::vector<Outcome>;

class Drawing {
 public:
  Drawing(const automata::Program& program, const ModelParts& parts)
      : program_(program), parts_(parts), children_(program.locations.size()), again_(program.locations.size(), false) {
    for (std::size_t l = 0; l < program.locations.size(); ++l) {
      const automata::Location& location = program.locations[l];
      if (location.parent && location.start) children_[location.parent->index()].emplace_back(l);
    }
    draws_.first.assign(program.locations.size(), false);
  }

  Draws run() {
    for (const automata::Location& location : program_.locations) {
      for (const automata::Arc& arc : location.arcs) start_again(arc.target);
    }
    find_first(LocationId(0), true);
    // A choice comes before those in its branches, which are wanted first.
    for (auto choice = parts_.choices.rbegin(); choice != parts_.choices.rend(); ++choice) {
      if (draws_.first[choice->first.index()]) continue;
      auto& functions = draws_.functions[choice->first];
      for (Outcome& outcome : drawn(choice->first, false))
        functions.push_back({outcome.probability, std::move(outcome.started), {}});
    }
    return std::move(draws_);
  }

 private:
  [[nodiscard]] const std::vector<Branch>* choice(LocationId location) const {
    const auto found = parts_.choices.find(location);
    return found == parts_.choices.end() ? nullptr : &found->second;
  }

  /// Notes what an arc starts.
  void start_again(LocationId location) {
    if (again_[location.index()]) return;
    again_[location.index()] = true;
    for (const LocationId child : children_[location.index()]) start_again(child);
  }

  /// Goes over what starts with the program. `outermost`: not in a branch of a choice that is drawn first itself.
  void find_first(LocationId location, bool outermost) {
    for (const LocationId child : children_[location.index()]) find_first(child, outermost);
    const auto* branches = choice(location);
    if (branches == nullptr || again_[location.index()]) return;
    draws_.first[location.index()] = true;
    for (const Branch& branch : *branches) {
      for (const LocationId start : branch.starts) find_first(start, false);
    }
    if (!outermost) return;
    automata::InitialDraw draw{location, {}};
    for (Outcome& outcome : drawn(location, true))
      draw.branches.push_back({outcome.probability, std::move(outcome.started)});
    draws_.initial.push_back(std::move(draw));
  }

  /// What a choice may start. `first`: before time 0.
  Outcomes drawn(LocationId location, bool first) {
    Outcomes all;
    for (const Branch& branch : *choice(location)) {
      if (branch.probability == 0) continue;
      Outcomes outcomes{{branch.probability, {}}};
      for (const LocationId start : branch.starts) multiply(outcomes, opened(start, first), location);
      std::move(outcomes.begin(), outcomes.end(), std::back_inserter(all));
    }
    for (Outcome& outcome : all) {
      std::sort(outcome.started.begin(), outcome.started.end());
      outcome.started.erase(std::unique(outcome.started.begin(), outcome.started.end()), outcome.started.end());
    }
    return all;
  }

  /// What a start of a branch comes to. Before time 0 composites are started as such, and what is drawn first inside
  /// them with them; else they come to their start locations, and every choice to what it may start.
  Outcomes opened(LocationId location, bool first) {
    if (choice(location) != nullptr) {
      if (first && !draws_.first[location.index()]) return {{1, {location}}};
      if (first) return drawn(location, true);
      const auto known = draws_.functions.find(location);
      if (known == draws_.functions.end()) return drawn(location, false);
      Outcomes all;
      for (const TransitionFunction& function : known->second) all.push_back({function.probability, function.started});
      return all;
    }
    if (!program_.locations[location.index()].composite) return {{1, {location}}};
    Outcomes all{{1, {}}};
    if (first) {
      all.front().started.push_back(location);
      multiply_first_inside(location, all);
    } else {
      for (const LocationId child : children_[location.index()]) multiply(all, opened(child, false), location);
    }
    return all;
  }

  /// Distributes over the outcomes what is drawn before time 0 where a composite starts.
  void multiply_first_inside(LocationId composite, Outcomes& all) {
    for (const LocationId child : children_[composite.index()]) {
      if (draws_.first[child.index()]) multiply(all, drawn(child, true), child);
      multiply_first_inside(child, all);
    }
  }

  /// Distributes one over the other.
  void multiply(Outcomes& all, const Outcomes& more, LocationId blame) {
    if (more.size() == 1) {
      // What is certain is added in place: many threads side by side are no product.
      const auto& [probability, started] = more.front();
      if (!grow(all.size() * (1 + started.size()), blame)) return;
      for (Outcome& one : all) {
        one.probability *= probability;
        one.started.insert(one.started.end(), started.begin(), started.end());
      }
      return;
    }
    Outcomes product;
    for (const Outcome& one : all) {
      for (const Outcome& other : more) {
        if (!grow(1 + one.started.size() + other.started.size(), blame)) return;
        Outcome& both = product.emplace_back(Outcome{one.probability * other.probability, one.started});
        both.started.insert(both.started.end(), other.started.begin(), other.started.end());
      }
    }
    all = std::move(product);
  }

  bool grow(std::size_t more, LocationId blame) {
    size_ += more;
    if (size_ > draws_limit && !draws_.too_large) draws_.too_large = blame;
    return size_ <= draws_limit;
  }

  const automata::Program& program_;
  const ModelParts& parts_;
  std::vector<std::vector<LocationId>> children_;  ///< per composite, those that start with it
  std::vector<bool> again_;                        ///< per location, whether an arc starts it
  Draws draws_;
  std::size_t size_ = 0;
};

}  // namespace

Draws draws_of(const automata::Program& program, const ModelParts& parts) { return Drawing(program, parts).run(); }

}  // namespace rmpl::compiler
