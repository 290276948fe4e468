// Joint steps: what all components do at once, every one of them or only those that nothing else replaces.
//
// In dense time steps follow each other with no time between. A joint step of components that have nothing to do with
// each other can then be taken in several steps at the same instant, and leads to the same state; among n components
// that is n steps in place of 2^n. What is left out here is only what other steps make up for, so that the reachable
// states are exactly the same; the number of steps to them is not.
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "base/function_ref.hpp"
#include "verifier/behaviour/behaviour.hpp"
#include "verifier/behaviour/joint_choices.hpp"
#include "verifier/behaviour/nogoods.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/symmetry/symmetry.hpp"

namespace rmpl::verifier {

/// Components whose clocks may be past the bound up to which they can stay under idle controls, in dense time;
/// ascending.
using Late = std::vector<automata::ComponentId>;

/// Which joint steps are of interest.
enum class Steps {
  all,
  every_action,  ///< all of them, and those of no command also under commands that change nothing of them
  /// Dense time only: a step is left out where the same state is reached by taking one of its components, or all of
  /// those that the command does not concern, a step earlier or later at the same instant.
  irreducible
};

/// The joint steps from given modes. Keeps references.
class JointSteps {
 public:
  JointSteps(Behaviours& behaviours, unsigned faults, Meter& meter);

  /// Which steps are enumerated from here on; all of them to begin with. `visible` are the components whose modes an
  /// observer reads on the way: none of them is taken earlier or later.
  void use(Steps steps, const std::vector<automata::ComponentId>& visible);

  /// From here on, of steps that differ only in which of several like components does what, one is enumerated: the
  /// states that the others lead to are the same up to symmetry. Keeps a reference.
  void up_to(const Symmetry& symmetry) { symmetry_ = symmetry.trivial() ? nullptr : &symmetry; }

  /// From here on steps have no more faults than these.
  void allow(unsigned faults) { faults_ = faults; }

  /// A possible step: the modes that it leads to, the faults it costs, and where the clocks must be.
  using Visit = base::FunctionRef<void(const automata::Modes& next, unsigned faults, const Box& bounds)>;

  /// From here on steps are from the possible `modes`, where the behaviours with idle controls are `idling`. Where
  /// steps are left out, no component but those that are `late` is past the bound up to which it can stay with idle
  /// controls. Those that are `due` are at that bound or beyond: steps in which they stay up to it are left out. Keeps
  /// references.
  void set_out(const automata::Modes& modes, const Late& late, const Late& due, const std::vector<BehaviourId>& idling);
  /// Every step under the action that changes a mode; the behaviours under it are `here`.
  void enumerate(const automata::ControlAction& action, const std::vector<BehaviourId>& here, const Visit& visit);

 private:
  struct Option {
    std::size_t component;
    const Choice* choice;
  };
  /// Of several components, of each of which one is taken: a list a component, in one memory.
  class Options {
   public:
    void clear() {
      options_.clear();
      begins_.clear();
    }
    /// To the last list, where that is of the same component, or as the first of a new one.
    void add(const Option& option) {
      if (options_.empty() || options_.back().component != option.component) begins_.push_back(options_.size());
      options_.push_back(option);
    }
    [[nodiscard]] std::size_t size() const { return begins_.size(); }
    [[nodiscard]] std::span<const Option> operator[](std::size_t list) const {
      const std::size_t end = list + 1 < begins_.size() ? begins_[list + 1] : options_.size();
      return std::span(options_).subspan(begins_[list], end - begins_[list]);
    }

   private:
    std::vector<Option> options_;
    std::vector<std::size_t> begins_;
  };
  /// Where one component goes to the mode alone: whether all is calm there, and their behaviours with idle controls.
  struct Alone {
    std::size_t component;
    automata::ModeId mode;
    bool calm;
    std::vector<BehaviourId> behaviours;
  };
  /// Where steps are enumerated from: the arguments of `set_out` and `enumerate`.
  struct At {
    const automata::Modes& modes;
    const Late& late;
    const Late& due;
    const automata::ControlAction& action;
    const std::vector<BehaviourId>& idling;  ///< with idle controls
    const std::vector<BehaviourId>& here;    ///< under the action
  };

  /// The choices of a component into a list of its own; false where it has none.
  bool add_choices(const At& at, std::size_t component, Options& options) const;
  void all(const At& at, const Visit& visit);
  void irreducible(const At& at, const Visit& visit);
  /// The steps in which what is `taken_` is done, alone or together with others that are free to be done.
  void rest(const At& at, const Options& free, std::size_t depth, const Visit& visit);
  [[nodiscard]] static unsigned faults_of(std::span<const Option> taken);
  /// Whether it takes the action to do these: with idle controls some component could not. What it does not take is
  /// enumerated with idle controls.
  [[nodiscard]] bool takes_action(const At& at, std::span<const Option> taken) const;
  /// Calls `leaf` for every way of taking one of each list beside what is `taken_`, within the faults that are left.
  /// What changes nothing is not added to `taken_`.
  template <class Leaf>
  void product(const At& at, const Options& options, const Leaf& leaf);
  /// For each list the last one before it whose component can be exchanged with its own, or itself; none where there is
  /// no symmetry.
  [[nodiscard]] std::vector<std::size_t> likes(const At& at, const Options& options) const;
  void emit(const At& at, std::span<const Option> taken, const Visit& visit);
  [[nodiscard]] const automata::Modes& after(const At& at, std::span<const Option> taken);
  /// Whether the modes are possible and let every component stay where it is with idle controls; their behaviours with
  /// idle controls are then in `there_`.
  [[nodiscard]] bool calm(const At& at, const automata::Modes& modes);
  [[nodiscard]] bool may_stay(const At& at, std::size_t component, BehaviourId behaviour,
                              const automata::Modes& modes) const;
  [[nodiscard]] const Alone& alone(const At& at, const Option& option);
  [[nodiscard]] bool goes_first(const At& at, const Option& option);

  Behaviours& behaviours_;
  Nogoods nogoods_;
  unsigned faults_;
  const Symmetry* symmetry_ = nullptr;
  Steps steps_ = Steps::all;
  std::vector<bool> visible_;  ///< by component
  Meter& meter_;

  automata::ControlAction idle_;

  const automata::Modes* modes_ = nullptr;  ///< steps are from there
  const Late* late_ = nullptr;
  const Late* due_ = nullptr;
  const std::vector<BehaviourId>* idling_ = nullptr;
  bool calm_ = false;          ///< whether every component may stay there
  std::vector<bool> at_rest_;  ///< by component: it may stay there, and has nothing else to do, with idle controls
  bool restarts_ = false;      ///< whether a clock starts anew with each step under the action at hand
  std::vector<Alone> alone_;

  // Of the step at hand; their memory serves the next:
  Options core_, free_;
  std::vector<Option> taken_;
  struct Parts {
    Options now, later;
  };
  std::deque<Parts> parts_;  ///< of `rest`, by depth
  PartialModes ahead_;       ///< what is decided of the modes that a step leads to
  automata::Modes next_;
  std::vector<BehaviourId> there_, there_commanded_;
  Box box_;
};

}  // namespace rmpl::verifier
