// Search with inclusion checking.
// SPDX-License-Identifier: MIT
#include "verifier/search/search.hpp"

#include <algorithm>
#include <compare>
#include <deque>
#include <map>

namespace rmpl::verifier {
namespace {

/// A system without the steps that do not follow a corridor. Keeps references.
class Guided : public TransitionSystem {
 public:
  Guided(TransitionSystem& system, const Corridor& corridor) : system_(system), corridor_(corridor) {}

  void initial(const Visit& visit) override {
    system_.initial([&](SymbolicState&& state, const Label& label) {
      if (corridor_.contains({before_all, state.discrete})) visit(std::move(state), label);
    });
  }
  void successors(const SymbolicState& state, const Visit& visit) override {
    system_.successors(state, [&](SymbolicState&& next, const Label& label) {
      if (corridor_.contains({state.discrete, next.discrete})) visit(std::move(next), label);
    });
  }
  [[nodiscard]] bool accepts(const SymbolicState& state) const override { return system_.accepts(state); }
  [[nodiscard]] bool no_more_faults(unsigned a, unsigned b) const override { return system_.no_more_faults(a, b); }
  [[nodiscard]] unsigned fault_count(unsigned faults) const override { return system_.fault_count(faults); }
  [[nodiscard]] FaultMeasures fault_measures(unsigned faults) const override { return system_.fault_measures(faults); }
  [[nodiscard]] std::uint32_t rank(std::uint64_t discrete) override { return system_.rank(discrete); }
  void limits(std::uint64_t discrete, std::vector<ClockLimits>& result) override { system_.limits(discrete, result); }

 private:
  TransitionSystem& system_;
  const Corridor& corridor_;
};

/// What is explored first: the least. Of several the first found, where steps are counted of all.
struct Urgency {
  unsigned faults = 0;
  std::uint32_t rank = 0;
  auto operator<=>(const Urgency&) const = default;
};

/// Whether the states of a search are new, or were counted by another one.
enum class Counted { now, before };

class Search {
 public:
  Search(TransitionSystem& system, SearchOrder order, Meter& meter, Counted counted = Counted::now)
      : system_(system),
        order_(order),
        meter_(meter),
        counted_(counted),
        passed_(system, order == SearchOrder::fewest_steps) {}

  std::optional<std::vector<PathState>> path() {
    run();
    return found_ ? std::optional(passed_.path(*found_)) : std::nullopt;
  }

  std::optional<Corridor> corridor() {
    run();
    return found_ ? std::optional(passed_.corridor(*found_)) : std::nullopt;
  }

 private:
  void run() {
    system_.initial([&](SymbolicState&& state, const Label& label) {
      if (!found_) add(state, label, Passed::none, 0);
    });
    while (!found_ && !queues_.empty()) {
      const auto queue = queues_.begin();
      if (queue->second.empty()) {
        queues_.erase(queue);
        continue;
      }
      std::uint32_t parent = queue->second.front();
      queue->second.pop_front();
      --waiting_;
      if (order_ != SearchOrder::fewest_steps && passed_[parent].covered) continue;
      if (order_ == SearchOrder::merging) parent = passed_.grown(parent);
      if (parent == Passed::none) continue;
      const std::uint32_t steps = passed_[parent].steps;
      if (order_ != SearchOrder::fewest_steps) {
        meter_.at_faults(queue->first.faults, waiting_);
      } else {
        meter_.at_steps(steps, waiting_);
      }
      meter_.used_faults(system_.fault_count(passed_[parent].faults));
      meter_.poll();
      system_.successors(passed_.state(parent), [&](SymbolicState&& next, const Label& label) {
        if (!found_) add(next, label, parent, label.silent ? steps : steps + 1);
      });
    }
  }

  [[nodiscard]] Urgency urgency(const SymbolicState& state) {
    if (order_ == SearchOrder::fewest_steps) return {};
    return {system_.fault_count(state.faults), system_.rank(state.discrete)};
  }

  void add(const SymbolicState& state, const Label& label, std::uint32_t parent, std::uint32_t steps) {
    const std::uint32_t number = passed_.add(state, label, parent, steps);
    if (number == Passed::none) return;
    if (counted_ == Counted::now) meter_.count_state();
    if (system_.accepts(state)) found_ = number;
    ++waiting_;
    auto& queue = queues_[urgency(state)];
    if (label.silent) {
      queue.push_front(number);
    } else {
      queue.push_back(number);
    }
  }

  TransitionSystem& system_;
  SearchOrder order_;
  Meter& meter_;
  Counted counted_;
  Passed passed_;
  std::map<Urgency, std::deque<std::uint32_t>> queues_;
  std::size_t waiting_ = 0;  ///< in all of them
  std::optional<std::uint32_t> found_;
};

}  // namespace

std::optional<std::vector<PathState>> find_path(TransitionSystem& system, SearchOrder order, Meter& meter) {
  return Search(system, order, meter).path();
}

std::optional<Corridor> find_corridor(TransitionSystem& system, Meter& meter) {
  return Search(system, SearchOrder::merging, meter).corridor();
}

std::optional<std::vector<PathState>> find_path_along(const Corridor& corridor, TransitionSystem& system,
                                                      Meter& meter) {
  Guided guided(system, corridor);
  return Search(guided, SearchOrder::covering, meter, Counted::before).path();
}

}  // namespace rmpl::verifier
