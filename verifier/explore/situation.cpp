// Situations: a mode for every component, with all that may happen there.
// SPDX-License-Identifier: MIT
#include "verifier/explore/situation.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

namespace verifier {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::ModeId;
using automata::Modes;

namespace {

void add_bound(Box& box, ComponentId component, const Interval& clock) {
  if (!clock.is_trivial()) box.push_back({component, clock});
}

/// The joint choices of all components, depth first in declaration order.
class Product {
 public:
  using Visit = std::function<void(const Modes&, unsigned, const Box&)>;

  Product(const std::vector<std::vector<Choice>>& choices, unsigned faults, const Visit& visit)
      : choices_(choices), faults_(faults), visit_(visit) {}

  void run() { extend(0); }

 private:
  void extend(unsigned cost) {
    if (modes_.size() == choices_.size()) return visit_(modes_, cost, box_);
    const ComponentId component(modes_.size());
    for (const Choice& choice : choices_[component.index()]) {
      if (cost + choice.faults > faults_) continue;
      const std::size_t bounds = box_.size();
      modes_.push_back(choice.mode);
      add_bound(box_, component, choice.clock);
      extend(cost + choice.faults);
      modes_.pop_back();
      box_.resize(bounds);
    }
  }

  const std::vector<std::vector<Choice>>& choices_;
  unsigned faults_;
  const Visit& visit_;
  Modes modes_;
  Box box_;
};

}  // namespace

Situations::Situations(automata::PlantStep& step, const Reading& reading, Commands commands, unsigned faults,
                       Meter& meter)
    : step_(step), reading_(reading), commands_(commands), faults_(faults), meter_(meter) {}

std::optional<SituationId> Situations::find(const Modes& modes) {
  if (const auto known = numbers_.find(modes); known != numbers_.end()) return known->second;
  std::optional<SituationId> id;
  if (step_.possible(modes)) {
    id = SituationId(entries_.size());
    entries_.push_back({describe(modes), {}, false});
  }
  numbers_.emplace(modes, id);
  return id;
}

Situation Situations::describe(const Modes& modes) {
  Situation result{modes, {}, {}, waits(modes, step_.enabled(modes, automata::idle_action(plant())))};
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const ComponentId component(c);
    if (!plant().has_timed_exit(component, modes[c])) continue;
    result.live.push_back(component);
    result.limits.push_back(clock_limits(plant()[component], modes[c], reading_));
  }
  return result;
}

std::vector<Box> Situations::waits(const Modes& modes, const std::vector<Enabled>& enabled) {
  std::vector<Box> boxes = {{}};
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const ComponentId component(c);
    std::vector<Box> longer;
    for (const Interval& wait : verifier::waits(plant()[component], modes[c], enabled[c], reading_)) {
      for (Box box : boxes) {
        add_bound(box, component, wait);
        longer.push_back(std::move(box));
      }
    }
    boxes = std::move(longer);
  }
  return boxes;
}

const std::vector<Move>& Situations::moves(SituationId id) {
  Entry& entry = entries_[id.index()];
  if (!entry.worked_out) {
    entry.moves = work_out(id);
    entry.worked_out = true;
  }
  return entry.moves;
}

std::vector<Move> Situations::work_out(SituationId id) {
  const Modes modes = entries_[id.index()].situation.modes;
  std::vector<Move> result;
  // Many control actions enable the same: what the components may do tells whether an action is worth a look, and a
  // step that two actions lead to is listed with the first.
  std::set<std::vector<std::vector<Choice>>> seen_choices;
  std::set<std::tuple<SituationId, unsigned, bool, Box>> seen_moves;
  for_each_action(plant(), commands_, [&](const ControlAction& action) {
    meter_.poll();
    const std::vector<Enabled>& enabled = step_.enabled(modes, action);
    std::vector<std::vector<Choice>> all;
    for (std::size_t c = 0; c < modes.size(); ++c) {
      all.push_back(choices(plant()[ComponentId(c)], modes[c], enabled[c], reading_));
    }
    if (!seen_choices.insert(all).second) return;
    std::optional<std::uint32_t> position;
    const auto add = [&](SituationId target, unsigned cost, bool hold, const Box& bounds) {
      if (!seen_moves.emplace(target, cost, hold, bounds).second) return;
      if (!position) {
        position = static_cast<std::uint32_t>(actions_.size());
        actions_.push_back(action);
      }
      result.push_back({target, *position, cost, hold, bounds});
    };
    if (!reading_.is_dense()) {
      for (const Box& box : waits(modes, enabled)) add(id, 0, true, box);
    }
    Product(all, faults_, [&](const Modes& next, unsigned cost, const Box& bounds) {
      meter_.poll();
      if (next == modes) return;
      if (const auto target = find(next)) add(*target, cost, false, bounds);
    }).run();
  });
  // What waiting under idle controls allows needs no command.
  const auto& idle = entries_[id.index()].situation.waits;
  std::erase_if(result, [&](const Move& m) { return m.hold && std::count(idle.begin(), idle.end(), m.bounds) > 0; });
  std::stable_partition(result.begin(), result.end(), [](const Move& m) { return m.hold; });
  return result;
}

std::vector<SituationId> Situations::initial(const std::vector<Assignment>& from) {
  std::vector<std::vector<Choice>> all;
  for (const Component& component : plant().components) {
    auto& modes = all.emplace_back();
    const auto given =
        std::find_if(from.begin(), from.end(), [&](const Assignment& a) { return a.variable == component.mode; });
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      if (given == from.end() ? component.initial[m] > 0 : given->value.index() == m)
        modes.push_back({ModeId(m), 0, {}});
    }
  }
  std::vector<SituationId> result;
  Product(all, 0, [&](const Modes& modes, unsigned, const Box&) {
    meter_.poll();
    if (const auto id = find(modes)) result.push_back(*id);
  }).run();
  return result;
}

}  // namespace verifier
