// The abstraction of a plant, component by component, as a least fixed point.
//
// A question that was answered with no names the modes to which that is due (a refutation is blamed on the assumptions
// that it used); it is asked again only when one of these is reached. So each is asked a few times, whatever the depth
// of the plant.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/reach.hpp"

#include <deque>
#include <map>
#include <set>
#include <utility>

#include "automata/step/transition_rules.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::ComponentId;
using automata::ModeId;
using automata::Plant;
using automata::TransitionId;
using automata::ValueId;

namespace {

class Search {
 public:
  explicit Search(PlantQuestions& questions) : questions_(questions), plant_(questions.plant()) {}

  Reach run() {
    find_possible();
    find_initial();
    do {
      while (!open_.empty()) {
        const auto [component, transition] = open_.front();
        open_.pop_front();
        look_at(component, transition);
      }
    } while (enter_together());
    return std::move(reach_);
  }

 private:
  struct Exit {
    ComponentId component;
    TransitionId transition;
  };

  [[nodiscard]] Assignment in(ComponentId component, std::size_t mode) const {
    return {plant_[component].mode, ValueId(mode)};
  }

  void find_possible() {
    reach_.possible = all_modes(plant_);
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      for (std::size_t m = 0; m < plant_.components[c].modes.size(); ++m) {
        const Assignment own = in(ComponentId(c), m);
        reach_.possible[c][m] = questions_.possible({&own, 1});
      }
    }
  }

  void find_initial() {
    for (const automata::Component& component : plant_.components) {
      std::vector<bool>& initial = reach_.initial.emplace_back();
      for (const double probability : component.initial) initial.push_back(probability > 0);
      reach_.reached.emplace_back(component.modes.size(), false);
      reach_.guards.emplace_back(component.transitions.size());
    }
    questions_.keep_to(reach_.initial);
    reach_.has_initial_state = questions_.possible({});
    if (reach_.has_initial_state) drop_impossible_starts();
    questions_.keep_to(reach_.initial);
    for (std::size_t c = 0; c < reach_.initial.size(); ++c) {
      for (std::size_t m = 0; m < reach_.initial[c].size(); ++m) {
        if (reach_.initial[c][m]) enter(ComponentId(c), ModeId(m));
      }
    }
  }

  void drop_impossible_starts() {
    for (std::size_t c = 0; c < reach_.initial.size(); ++c) {
      std::vector<bool>& initial = reach_.initial[c];
      if (std::count(initial.begin(), initial.end(), true) < 2) continue;
      for (std::size_t m = 0; m < initial.size(); ++m) {
        const Assignment own = in(ComponentId(c), m);
        if (initial[m]) initial[m] = questions_.possible({&own, 1});
      }
    }
  }

  void enter(ComponentId component, ModeId mode) {
    reach_.reached[component.index()][mode.index()] = true;
    questions_.allow(component, mode);
    const auto& transitions = plant_[component].transitions;
    for (std::size_t t = 0; t < transitions.size(); ++t) {
      if (transitions[t].from == mode && can_ever_be_taken(transitions[t])) {
        open_.push_back({component, TransitionId(t)});
      }
    }
    const auto waiting = waiting_.find(in(component, mode.index()));
    if (waiting == waiting_.end()) return;
    open_.insert(open_.end(), waiting->second.begin(), waiting->second.end());
    waiting_.erase(waiting);
  }

  void look_at(ComponentId component, TransitionId id) {
    const automata::Transition& transition = plant_[component].transitions[id.index()];
    Implied& guard = reach_.guards[component.index()][id.index()];
    if (guard.verdict == Implied::Verdict::yes && has_reached(component, transition.to)) return;
    if (guard.verdict != Implied::Verdict::yes) {
      const automata::Formula* formula = &transition.guard;
      guard = questions_.implied(component, transition.from, {&formula, 1});
      if (guard.verdict == Implied::Verdict::no) return wait({component, id}, guard.due_to);
    }
    if (has_reached(component, transition.to)) return;
    const Assignment target = in(component, transition.to.index());
    if (questions_.possible({&target, 1})) return enter(component, transition.to);
    barred_.emplace(component, transition.to);
    wait({component, id}, questions_.due_to());
  }

  /// Components that the interconnections bind together may only move together: each mode that is barred is let in,
  /// those that even so no state has are shut out again, and what is left is entered. Whether anything was.
  bool enter_together() {
    std::erase_if(barred_, [&](const auto& mode) { return has_reached(mode.first, mode.second); });
    std::set<std::pair<ComponentId, ModeId>> together = barred_;
    for (std::size_t before = 0; before != together.size();) {
      before = together.size();
      let_in(together);
      std::erase_if(together, [&](const auto& mode) {
        const Assignment target = in(mode.first, mode.second.index());
        return !questions_.possible({&target, 1});
      });
    }
    let_in({});
    for (const auto& [component, mode] : together) enter(component, mode);
    return !together.empty();
  }

  /// From here on questions are about what is reached, and these.
  void let_in(const std::set<std::pair<ComponentId, ModeId>>& modes) {
    questions_.keep_to(reach_.reached);
    for (const auto& [component, mode] : modes) questions_.allow(component, mode);
  }

  [[nodiscard]] bool has_reached(ComponentId component, ModeId mode) const {
    return reach_.reached[component.index()][mode.index()];
  }

  void wait(Exit exit, const std::vector<Assignment>& due_to) {
    for (const Assignment& mode : due_to) waiting_[mode].push_back(exit);
  }

  PlantQuestions& questions_;
  const Plant& plant_;
  Reach reach_;
  std::deque<Exit> open_;
  std::set<std::pair<ComponentId, ModeId>>
      barred_;  ///< modes that a transition may lead to, and that contradict all that is reached
  std::map<Assignment, std::vector<Exit>> waiting_;  ///< by the mode that might change the answer
};

}  // namespace

Reach reach_of(PlantQuestions& questions) { return Search(questions).run(); }

}  // namespace rmpl::compiler
