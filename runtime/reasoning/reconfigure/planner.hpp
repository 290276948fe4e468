// The reactive planner: from a state and a goal state to the first control action (semantics 5; thesis 6.3.2).
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "automata/dependencies/plant_index.hpp"
#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "base/bounded_cache.hpp"
#include "base/function_ref.hpp"
#include "runtime/reasoning/reconfigure/causal_order.hpp"
#include "runtime/reasoning/reconfigure/impasse.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/nominal_step.hpp"
#include "runtime/reasoning/reconfigure/parts.hpp"
#include "runtime/reasoning/reconfigure/policy.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "runtime/reasoning/reconfigure/ways.hpp"

namespace rmpl::runtime {

/// What to do in one cycle, and what comes of it if nothing fails.
struct PlannedStep {
  automata::ControlAction action;   ///< idle: wait
  automata::ComponentId component;  ///< the one that is to change its mode
  automata::ComponentId serves;     ///< the one on whose way that is
  NominalOutcome outcome;
  bool idle = false;
};

/// What a planner is asked: everything but the state that it starts from.
struct Objective {
  const automata::Modes& target;
  const Permitted& permitted;       ///< transitions that may be taken
  std::size_t part;                 ///< only its components are looked at
  const std::vector<bool>& wanted;  ///< by component: it is to come to its target; others may end where they are
  /// Housekeeping: what every state on the way satisfies. Empty for what the goal needs.
  std::function<bool(const automata::Modes&)> keeps = {};
  /// With that, by component: its own timed transitions may be waited for, as it is aimed at another mode. No others.
  std::vector<bool> moved = {};
  /// Plans of objectives with the same number may be remembered for each other: 0 where nothing is kept. None where
  /// what is kept is no matter of the part alone.
  std::optional<std::uint64_t> keeps_number = 0;
};

/// A plan for one part.
struct IslandPlan {
  PlannedStep first;
  automata::Modes end;  ///< other parts as they were
};

/// Goals are achieved one by one, downstream first; the policy of a component names the transition to take, and what
/// its guard requires of components upstream becomes a subgoal (a depth-first walk through the policies). Each choice
/// is checked on the step function: it must not undo a goal that is achieved, nor take an irreversible step that is not
/// named. The walk is followed to the goal state before its first action is given; where it turns in a circle or gets
/// stuck, and where components control each other in a cycle, the whole part is searched instead.
///
/// A wait is unsafe while another component has a mode that the rest of the plan relies on and may leave it by a timed
/// transition of its own. A way without unsafe waits goes before all others: the walk, then the walk that puts off what
/// does not last, then a search; only where there is none are unsafe waits accepted. Whether a wait is unsafe is read
/// from the state alone, so the answers along a plan agree with each other.
///
/// Cost of a walk: about the plan's length times the requirements along it. Of a search: exponential in the part.
class Planner {
 public:
  Planner(automata::PlantStep& step, const NominalGraph& graph, const Parts& parts);

  /// The first step from `modes`, which differ from the target in some wanted component of the part, and where the
  /// plan ends.
  std::variant<IslandPlan, Impasse> next(const automata::Modes& modes, const Objective& objective);
  /// The searches of one answer share a budget; this renews it.
  void renew_budget(std::size_t trials = trial_limit) { tried_ = tried_alike_ = trial_limit - trials; }
  /// What the policies that lead components to their targets go through: modes that they rely on, components that they
  /// move, themselves among them.
  struct Followed {
    std::vector<bool> relied, moved;
    bool waits;                                                           ///< for timed transitions of these
    std::set<std::pair<automata::ComponentId, automata::ModeId>> sought;  ///< where those that are moved are to come
  };
  /// Of the wanted components, whichever way they go.
  Followed followed(const automata::Modes& modes, const Objective& objective);

  /// Whether time alone takes the component on to its target.
  bool is_under_way(const automata::Modes& modes, const Objective& objective, automata::ComponentId component);

  /// Components in the order in which their goals are achieved.
  [[nodiscard]] const std::vector<automata::ComponentId>& order() const { return order_.downstream_first(); }

  /// Whether the step achieves a goal that a timed transition may undo, or begins what does without a wait.
  bool is_brief(const IslandPlan& plan, const Objective& objective);
  /// Whether the step achieves a goal that an untimed transition undoes in the next.
  bool is_passing(const PlannedStep& step, const Objective& objective);
  /// Whether a timed transition stands in the ways that lead from the modes to the target.
  bool has_waits(const automata::Modes& modes, const Objective& objective);

  /// States that a search visits at most, before it gives up.
  static constexpr std::size_t search_limit = 1u << 14;
  /// Control actions that the searches of one answer try at most, over all states, but for those that change nothing.
  static constexpr std::size_t trial_limit = planning_trials;
  /// Of those of housekeeping, for a shorter way than one that is known.
  static constexpr std::size_t shortcut_trials = 1u << 7;

 private:
  using NextStep = std::variant<PlannedStep, Impasse>;
  bool is_brief(const PlannedStep& step, const Objective& objective);
  std::vector<NominalMove> brief_goals(const automata::Modes& modes, const Objective& objective);
  /// The order of goals. `commands_first`: downstream first, but commands for others go out while that waits.
  enum class Order { commands_first, downstream_first, lasting_first };
  /// `grounded`: safe, and nothing that the ways rest on is given up, in order to be safe.
  enum class Waits { grounded, safe, any };
  /// A walk to the goal state: its first step, or why it does not get there; how many of its waits are unsafe; and
  /// whether it has commands `meanwhile`.
  struct Trace {
    NextStep first;
    std::size_t unsafe;  ///< waits; of a walk that leads nowhere more than any walk has
    bool asides;
    automata::Modes end;
    bool loses = false;  ///< on the way something that was achieved
    [[nodiscard]] bool safe() const { return unsafe == 0; }
  };
  /// What a search finds; `excluded`: ways were left out because of unsafe waits.
  struct Found {
    NextStep first;
    bool excluded;
    automata::Modes end;
    bool given_up = false;
  };
  std::variant<IslandPlan, Impasse> planned(const automata::Modes& modes, const Objective& objective);
  [[nodiscard]] static bool astray(const automata::Modes& modes, const Objective& objective, automata::ComponentId c) {
    return objective.wanted[c.index()] && modes[c.index()] != objective.target[c.index()];
  }
  /// Whether the step may be part of a plan: it keeps what is to be kept, whatever its action lets come besides, and
  /// waits for nothing that it must not.
  bool may_take(const automata::Modes& modes, const Objective& objective, const automata::ControlAction& action,
                const NominalOutcome& outcome);
  Trace follow(const automata::Modes& modes, const Objective& objective, Order order);
  /// Of states that a walk led through, the last of which is one that it came through before.
  [[nodiscard]] Impasse turns_in_a_circle(const std::vector<automata::Modes>& states, automata::ComponentId astray,
                                          const Objective& objective) const;
  NextStep walk(const automata::Modes& modes, const Objective& objective, Order order);
  /// Of the components that are astray, the first that can be brought on without reaching a goal too early.
  NextStep advance(const automata::Modes& modes, const Objective& objective, Order order);
  /// The first command that suits on the nearest way of a component, whatever of it is to be achieved first.
  std::optional<PlannedStep> preparation(const automata::Modes& modes, const Objective& objective,
                                         automata::ComponentId component, std::span<const automata::ModeId> wanted,
                                         base::FunctionRef<bool(const PlannedStep&)> suits);
  /// While one goal waits, the first command after which it waits as before: for another goal, no part of its way, or
  /// for what its way needs beside what it waits for.
  std::optional<PlannedStep> meanwhile(const automata::Modes& modes, const Objective& objective,
                                       const PlannedStep& waiting);
  /// The next step of a component that is astray, to its target.
  NextStep approach(const automata::Modes& modes, const Objective& objective, automata::ComponentId component);
  NextStep achieve(const automata::Modes& modes, const Objective& objective, automata::ComponentId component,
                   std::span<const automata::ModeId> wanted);
  NextStep bring_about(const automata::Modes& modes, const Objective& objective, automata::ComponentId component,
                       const NominalTransition& next);
  NextStep command(const automata::Modes& modes, const Objective& objective, automata::ComponentId component,
                   const NominalTransition& transition, const Precondition& precondition);
  /// All actions that a search of a part tries.
  const std::vector<OffIdle>& actions(std::size_t part);
  /// The actions that can matter: those on controls that some transition needs of a component that is astray, or of one
  /// upstream of it. It can take others, to bring a component out of the way that is where it should be in the end.
  std::vector<OffIdle> promising(const automata::Modes& modes, const Objective& objective);
  /// What the ways of the components that are astray can have to do with, or of all that are wanted: components, and
  /// all variables that some transition of them needs.
  struct Upstream {
    std::vector<bool> components, variables;
  };
  Upstream upstream(const automata::Modes& modes, const Objective& objective, bool achieved);
  /// The actions that a search tries, the components that it tells states apart by, those that have to do with the
  /// goal, and what it counts its trials in.
  struct SearchSpace {
    std::span<const OffIdle> actions;
    const std::vector<bool>& told_apart;
    const std::vector<bool>& involved;
    std::size_t& tried;
  };
  Found search(const automata::Modes& modes, const Objective& objective, const Impasse& otherwise, Waits waits);
  Found search(const automata::Modes& modes, const Objective& objective, Impasse otherwise, Waits waits,
               const SearchSpace& space);
  /// With a small part of the budget: for a shorter way where there is one.
  Found search_a_little(const automata::Modes& modes, const Objective& objective);

  /// Whether two transitions are one step of a policy: they lead from the same mode to the same mode, and the first may
  /// be taken.
  [[nodiscard]] bool is_parallel(automata::ComponentId component, const NominalTransition& t,
                                 const NominalTransition& other, const Permitted& permitted) const {
    return t.from == other.from && t.to == other.to &&
           permitted.on_ways[component.index()][graph_.position(component, t)];
  }
  [[nodiscard]] bool stands(const NominalTransition& transition, const automata::Modes& modes) const;
  automata::ComponentId served_by(const automata::Modes& modes, const Objective& objective,
                                  automata::ComponentId moved);
  enum class Follow { every_way, nearest_ways };
  Followed followed(const automata::Modes& modes, const Objective& objective,
                    std::span<const automata::ComponentId> seeds, Follow follow);
  /// Of the wanted components of the part, by the nearest ways.
  Followed followed_in_part(const automata::Modes& modes, const Objective& objective);
  /// What the plan relies on in one state, for all steps that are looked at there; each part of it is worked out when
  /// it is first asked for.
  class Reliance {
   public:
    Reliance(Planner& planner, const automata::Modes& modes, const Objective& objective)
        : planner_(planner), modes_(modes), objective_(objective) {}

    /// Whether the step is no wait, or a safe one.
    bool is_safe(const automata::ControlAction& action, const NominalOutcome& outcome);
    /// Whether a component that is not to move leaves a mode that the ways of others rely on, or that was achieved; not
    /// where it leaves it at once whatever is done, nor where what was achieved ends in time, and is achieved again.
    bool gives_up(const NominalOutcome& outcome);

   private:
    /// Of the wanted components of the part, by the nearest ways.
    const Followed& way();
    /// What may leave its mode in time while the action is held, and takes away what the plan relies on.
    const std::vector<NominalMove>& threats(const automata::ControlAction& action);
    /// Whether what leaves its mode by itself takes with it, by untimed transitions one after the other, a mode that
    /// the way relies on, or leads one that is to move farther from where it is to come.
    bool upsets(const NominalMove& leaving);

    Planner& planner_;
    const automata::Modes& modes_;
    const Objective& objective_;
    std::optional<Followed> way_;
    std::optional<std::pair<automata::ControlAction, std::vector<NominalMove>>> threats_;  ///< under the last action
  };

  /// How far away the requirements of a way are, with the way back of what moves only for it; and without.
  struct Detour {
    Distance and_back, there;
    auto operator<=>(const Detour&) const = default;
  };
  /// Nothing where one of them cannot be met.
  std::optional<Detour> detour(const automata::Modes& modes, const Objective& objective, const Way& way);
  /// The requirements that the modes do not meet yet, those furthest downstream first.
  [[nodiscard]] std::vector<const ModeRequirement*> pending(const automata::Modes& modes, const Way& way) const;
  /// Of the modes that are wanted of a component, the nearest by its policy; null where none can be come to.
  const automata::ModeId* nearest_of(const automata::Modes& modes, const Objective& objective,
                                     automata::ComponentId component, std::span<const automata::ModeId> wanted);
  /// What a step takes, its own and those of the components that a way to it has to move first, and back; and how many
  /// these are.
  struct Effort {
    Distance distance;
    std::size_t others = 0;
    auto operator<=>(const Effort&) const = default;
    friend Effort operator+(const Effort& a, const Effort& b) { return {a.distance + b.distance, a.others + b.others}; }
  };
  /// By the way that takes least; nothing where none can be gone.
  std::optional<Effort> effort(const automata::Modes& modes, const Objective& objective,
                               automata::ComponentId component, const NominalTransition& t);
  /// The transitions by which a component goes to a mode: those of its policy, or, where others have to move for these,
  /// such as take less with all that moves. Empty where the policy has none.
  using Route = std::vector<const NominalTransition*>;
  Route route(const automata::Modes& modes, const Objective& objective, automata::ComponentId component,
              automata::ModeId target);
  /// How many others depend on the components that a way has to move first.
  std::size_t disturbed(const automata::Modes& modes, const Way& way) const;
  /// One way to bring a step about.
  struct Choice {
    std::optional<Detour> detour;
    std::size_t disturbed;
    const NominalTransition* transition;
    const Way* way;
  };
  /// All of them, the nearest first; of equally near ones those that take no time, then those that disturb least.
  std::vector<Choice> choices(const automata::Modes& modes, const Objective& objective, automata::ComponentId component,
                              const NominalTransition& next);
  [[nodiscard]] bool arrived(const automata::Modes& modes, const Objective& objective) const;
  [[nodiscard]] std::string name(automata::ComponentId component, automata::ModeId mode) const;
  /// The end of a sentence: what forbidden step a command would let be taken.
  [[nodiscard]] std::string would_let(const TransitionOf& refused) const;

  /// What the part and the objective have to do with where a walk leads, as a key.
  std::vector<std::uint64_t> question(const automata::Modes& modes, const Objective& objective) const;
  /// The first step of a safe walk that was followed before, or part of one.
  std::optional<IslandPlan> recall(const automata::Modes& modes, const Objective& objective);

  /// What is remembered of a step: all but the modes of other parts.
  struct RememberedStep {
    automata::ControlAction action;
    automata::ComponentId component, serves;
    std::vector<NominalMove> moves;
    bool idle;
    automata::Modes end;  ///< of the whole plant; the part's are looked at
  };
  /// Beyond about so many remembered steps they are forgotten.
  static constexpr std::size_t memory_limit = 1u << 11;

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  const Parts& parts_;
  CausalOrder order_;
  Policies policies_;
  Ways ways_;
  NominalStep nominal_;
  std::size_t tried_ = 0;
  std::size_t tried_alike_ = 0;  ///< by searches that take states for one
  automata::ControlAction idle_;
  automata::PlantIndex index_;
  std::vector<std::vector<automata::ComponentId>> ordered_;   ///< per part, downstream first
  std::vector<std::optional<std::vector<OffIdle>>> actions_;  ///< per part, as far as asked for
  /// The steps of safe walks, commands first, by `question`: what follows on the first step is a safe walk, too, and
  /// its answer was found on the way.
  base::BoundedCache<std::vector<std::uint64_t>, RememberedStep> remembered_{memory_limit};
};

}  // namespace rmpl::runtime
