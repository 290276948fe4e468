// Joint steps: what all components do at once.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/joint_steps.hpp"

#include <algorithm>

namespace rmpl::verifier {
namespace {

/// Stands for changing nothing.
const Choice stays{};

}  // namespace

using automata::ComponentId;
using automata::ControlAction;
using automata::Modes;

JointSteps::JointSteps(Behaviours& behaviours, unsigned faults, Meter& meter)
    : behaviours_(behaviours),
      nogoods_(behaviours.step()),
      faults_(faults),
      visible_(behaviours.step().plant().components.size(), false),
      meter_(meter),
      idle_(automata::idle_action(behaviours.step().plant())) {}

void JointSteps::use(Steps steps, const std::vector<ComponentId>& visible) {
  steps_ = steps;
  visible_.assign(visible_.size(), false);
  for (const ComponentId c : visible) visible_[c.index()] = true;
}

void JointSteps::set_out(const Modes& modes, const Late& late, const Late& due,
                         const std::vector<BehaviourId>& idling) {
  modes_ = &modes;
  late_ = &late;
  due_ = &due;
  idling_ = &idling;
  alone_.clear();
  calm_ = false;
  if (steps_ != Steps::irreducible) return;
  const At at{modes, late, due, idle_, idling, idling};
  calm_ = calm(at, modes);
  at_rest_.assign(modes.size(), false);
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const auto does_something = [&](const Choice& choice) {
      return choice.mode != modes[c] && choice.faults <= faults_;
    };
    const std::vector<Choice>& choices = behaviours_[idling[c]].choices;
    at_rest_[c] = may_stay(at, c, idling[c], modes) && std::none_of(choices.begin(), choices.end(), does_something);
  }
}

void JointSteps::enumerate(const ControlAction& action, const std::vector<BehaviourId>& here, const Visit& visit) {
  const At at{*modes_, *late_, *due_, action, *idling_, here};
  ahead_.modes = *modes_;
  ahead_.decided.assign(modes_->size(), true);
  restarts_ = behaviours_.some_restart() && std::any_of(here.begin(), here.end(), [&](BehaviourId behaviour) {
                return behaviours_[behaviour].restarts;
              });
  taken_.clear();
  return steps_ == Steps::irreducible ? irreducible(at, visit) : all(at, visit);
}

/// Equal options in equal modes that have no clock: where an automorphism exchanges the two components
/// and leaves all else as it is, it takes a step in which they have done the one thing and the other to that in which
/// they have done it the other way round, and the present state to itself.
std::vector<std::size_t> JointSteps::likes(const At& at, const Options& options) const {
  std::vector<std::size_t> result;
  if (symmetry_ == nullptr) return result;
  for (std::size_t i = 0; i < options.size(); ++i) {
    result.push_back(i);
    const auto component = [&](std::size_t k) { return options[k].front().component; };
    const ComponentId own(component(i));
    if (behaviours_.step().plant().has_timed_exit(own, at.modes[own.index()])) continue;
    const auto alike = [](const Option& a, const Option& b) { return *a.choice == *b.choice; };
    for (std::size_t k = i; k-- > 0 && result[i] == i;) {
      if (at.here[component(k)] == at.here[component(i)] && at.modes[component(k)] == at.modes[component(i)] &&
          std::equal(options[k].begin(), options[k].end(), options[i].begin(), options[i].end(), alike) &&
          symmetry_->exchanges(ComponentId(component(k)), own)) {
        result[i] = k;
      }
    }
  }
  return result;
}

template <class Leaf>
void JointSteps::product(const At& at, const Options& options, const Leaf& leaf) {
  const std::vector<std::size_t> like = likes(at, options);
  std::vector<std::size_t> chosen(like.size());
  unsigned so_far = faults_of(taken_);
  base::multiply_out(
      options,
      [&](std::size_t position, std::size_t i) {
        if (i == 0) meter_.poll();
        if (!like.empty() && i < chosen[like[position]] && like[position] != position) return false;
        const Option& option = options[position][i];
        if (so_far + option.choice->faults > faults_) return false;
        ahead_.modes[option.component] = option.choice == &stays ? at.modes[option.component] : option.choice->mode;
        if (nogoods_.refutes(ahead_, ComponentId(option.component))) return false;
        if (!like.empty()) chosen[position] = i;
        ahead_.decided[option.component] = true;
        if (option.choice != &stays) taken_.push_back(option);
        so_far += option.choice->faults;
        return true;
      },
      [&](std::size_t position, std::size_t i) {
        const Option& option = options[position][i];
        so_far -= option.choice->faults;
        if (option.choice != &stays) taken_.pop_back();
        ahead_.decided[option.component] = false;
      },
      [&] {
        leaf();
        return false;
      });
}

const Modes& JointSteps::after(const At& at, std::span<const Option> taken) {
  next_ = at.modes;
  for (const Option& option : taken) next_[option.component] = option.choice->mode;
  return next_;
}

unsigned JointSteps::faults_of(std::span<const Option> taken) {
  unsigned faults = 0;
  for (const Option& option : taken) faults += option.choice->faults;
  return faults;
}

bool JointSteps::takes_action(const At& at, std::span<const Option> taken) const {
  return std::any_of(taken.begin(), taken.end(), [&](const Option& option) {
    const BehaviourId here = at.here[option.component];
    const BehaviourId idle = at.idling[option.component];
    if (here == idle) return false;  // the same choices
    const std::vector<Choice>& idling = behaviours_[idle].choices;
    return behaviours_[here].restarts != behaviours_[idle].restarts ||
           std::find(idling.begin(), idling.end(), *option.choice) == idling.end();
  });
}

void JointSteps::emit(const At& at, std::span<const Option> taken, const Visit& visit) {
  if ((after(at, taken) == at.modes && !restarts_) || !nogoods_.possible(next_)) return;
  box_.clear();
  for (const Option& option : taken) {
    const Choice& choice = *option.choice;
    if (!choice.clock.is_trivial()) box_.push_back({ComponentId(option.component), choice.clock, choice.sharp});
  }
  std::sort(box_.begin(), box_.end());
  visit(next_, faults_of(taken), box_);
}

bool JointSteps::add_choices(const At& at, std::size_t component, Options& options) const {
  const bool due = std::binary_search(at.due.begin(), at.due.end(), ComponentId(component));
  const Units bound = behaviours_[at.idling[component]].stays_until;
  bool some = false;
  for (const Choice& choice : behaviours_[at.here[component]].choices) {
    const bool stays_up_to_it = choice.mode == at.modes[component] && choice.clock.upper <= bound;
    if (due && stays_up_to_it && choice.sharp.upper) continue;
    options.add({component, &choice});
    some = true;
  }
  return some;
}

void JointSteps::all(const At& at, const Visit& visit) {
  Options options;
  for (std::size_t c = 0; c < at.modes.size(); ++c) {
    const Behaviour& behaviour = behaviours_[at.here[c]];
    const bool concerned = at.here[c] != at.idling[c];
    if (!concerned && !behaviour.changes && behaviour.free_to_stay()) continue;
    if (!add_choices(at, c, options)) return;
    ahead_.decided[c] = false;
  }
  product(at, options, [&] {
    if (steps_ == Steps::every_action || at.action == idle_ || takes_action(at, taken_)) emit(at, taken_, visit);
  });
}

bool JointSteps::calm(const At& at, const Modes& modes) {
  if (!behaviours_.step().possible(modes) || !behaviours_.step().consistent(modes, idle_)) return false;
  if (calm_) {  // then the store is consistent with idle controls here
    behaviours_.read({at.modes, idle_, at.idling}, modes, idle_, there_);
  } else {
    behaviours_.read(modes, idle_, there_);
  }
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (!may_stay(at, c, there_[c], modes)) return false;
  }
  return true;
}

/// Whether a component may stay in `modes` with this behaviour: a step away at most, so that its clock has started anew
/// or reads what it reads here.
bool JointSteps::may_stay(const At& at, std::size_t component, BehaviourId behaviour, const Modes& modes) const {
  const Behaviour& there = behaviours_[behaviour];
  if (there.restarts) return false;  // a step that leaves it in its mode is one
  if (there.free_to_stay() || there.stays_until < 0) return there.free_to_stay();
  // What has to leave as soon as it comes is due in the next step of the instant.
  if (modes[component] != at.modes[component]) return there.stays_until > 0;
  return behaviour == at.idling[component] &&
         std::find(at.late.begin(), at.late.end(), ComponentId(component)) == at.late.end();
}

const JointSteps::Alone& JointSteps::alone(const At& at, const Option& option) {
  const auto known = std::find_if(alone_.begin(), alone_.end(), [&](const Alone& one) {
    return one.component == option.component && one.mode == option.choice->mode;
  });
  if (known != alone_.end()) return *known;
  const bool is_calm = calm(at, after(at, {&option, 1}));
  return alone_.emplace_back(Alone{option.component, option.choice->mode, is_calm, there_});
}

/// Whether the change can be made a step earlier, under idle controls, and disturbs nothing of what remains: all others
/// can do what they could, under idle controls and under the action, and all that cannot do a thing can still stay.
bool JointSteps::goes_first(const At& at, const Option& option) {
  if (visible_[option.component]) return false;
  const Alone& then = alone(at, option);
  if (!then.calm) return false;
  const Modes& next = after(at, {&option, 1});
  if (!behaviours_.step().consistent(next, at.action)) return false;
  behaviours_.read({next, idle_, then.behaviours}, next, at.action, there_commanded_);
  for (std::size_t c = 0; c < next.size(); ++c) {
    const Behaviour& commanded = behaviours_[there_commanded_[c]];
    if (c == option.component) {
      if (commanded.stays_until <= 0) return false;
      continue;
    }
    const bool same = then.behaviours[c] == at.idling[c] && there_commanded_[c] == at.here[c];
    const Behaviour& here = behaviours_[at.here[c]];
    const bool active = here.changes || !here.free_to_stay() || here.restarts || commanded.restarts;
    if (!same && (active || !commanded.free_to_stay())) return false;
  }
  return true;
}

void JointSteps::irreducible(const At& at, const Visit& visit) {
  const bool is_idle = at.action == idle_;
  // The core takes part in every step: what the command concerns, and what cannot simply stay.
  core_.clear();
  free_.clear();
  for (std::size_t c = 0; c < at.modes.size(); ++c) {
    const bool concerned = at.here[c] != at.idling[c];
    if (!concerned && at_rest_[c]) continue;
    const Behaviour& behaviour = behaviours_[at.here[c]];
    if (concerned || !may_stay(at, c, at.here[c], at.modes)) {
      if (!add_choices(at, c, core_)) return;
      ahead_.decided[c] = false;
      continue;
    }
    for (const Choice& choice : behaviour.choices) {
      const Option option{c, &choice};
      if (choice.mode == at.modes[c] || choice.faults > faults_) continue;
      if (calm_ && is_idle) emit(at, {&option, 1}, visit);
      if (calm_ && goes_first(at, option)) continue;
      free_.add(option);
      ahead_.decided[c] = false;
    }
  }
  product(at, core_, [&] {
    if (is_idle || takes_action(at, taken_)) rest(at, free_, 0, visit);
  });
}

void JointSteps::rest(const At& at, const Options& free, std::size_t depth, const Visit& visit) {
  emit(at, taken_, visit);
  if (free.size() == 0) return;
  const bool still = after(at, taken_) == at.modes;
  const bool some_wait = !still && calm(at, next_);
  if (parts_.size() <= depth) parts_.emplace_back();
  Options& now = parts_[depth].now;
  Options& later = parts_[depth].later;
  now.clear();
  later.clear();
  for (std::size_t i = 0; i < free.size(); ++i) {
    const std::span<const Option> own = free[i];
    // What the core leaves alone can follow a step later; what it touches cannot wait.
    const std::size_t c = own.front().component;
    if (some_wait && !visible_[c] && there_[c] == at.here[c]) {
      for (const Option& option : own) later.add(option);
      continue;
    }
    now.add({c, &stays});
    for (const Option& option : own) now.add(option);
  }
  if (now.size() == 0) return;

  const std::size_t before = taken_.size();
  product(at, now, [&] {
    const std::size_t more = taken_.size() - before;
    // One change alone, where all may stay, has been visited.
    if (more == 0 || (more == 1 && still && calm_)) return;
    if (later.size() == 0) {
      emit(at, taken_, visit);
    } else {
      rest(at, later, depth + 1, visit);
    }
  });
}

}  // namespace rmpl::verifier
