// What may still come of a state of a closed loop, whatever clocks read.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "automata/program.hpp"
#include "automata/step/program_rules.hpp"
#include "verifier/markov/part_moves.hpp"

namespace rmpl::verifier {

/// Where a program can end no more, and its plant comes to the target in each step with about the same probability
/// whatever is commanded, nothing else matters. Elsewhere some components do not matter: no goal to come asks for them,
/// and whatever modes they come to, each condition to come that reads them is the same, as long as the target may yet
/// be reached.
///
/// What a program may still come to is taken to be as much as it can be: each location goes on as soon as some modes
/// that its plant may come to would let it. What the plant may come to is asked of each of the parts that nothing
/// connects: under commands of any kind where a location that may be marked asks something of the part, or commands may
/// gain reward there, and with idle controls elsewhere, as nobody commands it. Where a goal that can never be had is
/// asserted for ever, there is no plan for ever, and all controls stay idle.
class Outlook {
 public:
  struct Question {
    const automata::Formula& target;
    bool entailed;
    automata::Ticks period;
    Real precision;  ///< of the bounds that are asked for
  };

  /// `program` is bound to the plant. Keeps references to both.
  Outlook(const automata::Program& program, const automata::Plant& plant, const Question& question, Meter& meter);

  struct Told {
    /// Where the program can end no more, or the target cannot be reached: at least and at most how likely each step is
    /// to come to the target, from the next one on, if that is about the same for ever.
    std::optional<Enclosure> steady_hazard = {};
    /// By component; empty: all matter. Such a one may as well be in its mode of `modes`, whatever its clock reads.
    std::vector<bool> idle = {};
    automata::Modes modes = {};  ///< in place of those that were asked about, where some do not matter
  };
  /// The reference lasts. Throws LimitReached.
  const Told& tell(const automata::Marking& marking, const automata::Modes& modes);

 private:
  /// A formula of the program, taken apart: each conjunct over states, with the parts of the plant that decide it.
  struct Conjunct {
    std::optional<automata::Theory::Handle> handle;  ///< nothing: clocks decide it, too
    Cone cone;                                       ///< components that decide it
    std::vector<std::size_t> parts;                  ///< ascending
    std::map<std::vector<PartMoves::Number>, bool> known;
    std::map<std::vector<const PartMoves::Reach*>, std::pair<bool, bool>> asked;
  };
  using Asked = std::vector<std::size_t>;  ///< conjuncts, by number
  struct Condition {
    Asked asked;
    bool entailed = true;
    bool trivial = false;
    const automata::Formula* formula = nullptr;
  };
  struct Location {
    Asked goal;
    std::vector<std::size_t> goal_parts;  ///< of the plant, that it reads
    Condition maintenance;
    std::vector<Condition> guards;                           ///< by arc
    std::vector<std::vector<automata::LocationId>> targets;  ///< by arc: all that it marks
  };
  /// Whether a condition may hold, and whether it may not.
  struct Chances {
    bool holds, fails;
  };
  struct Future {
    std::vector<bool> locations;                   ///< that may come to be marked
    std::vector<bool> commanded;                   ///< by part of the plant
    std::vector<const PartMoves::Reach*> reaches;  ///< by part of the plant
    /// The same, of a single part with an end only from where that may yet be reached.
    std::vector<const PartMoves::Reach*> open;
  };
  struct Key {
    automata::Marking marking;
    std::vector<PartMoves::Number> numbers;
    auto operator<=>(const Key&) const = default;
  };

  void find_parts();
  void compile();
  void set_ends();
  Asked taken_apart(const automata::Formula& formula);
  Condition compiled(const automata::Condition& condition);
  void mark_fully(automata::LocationId location, std::vector<automata::LocationId>& marked) const;

  Told work_out(const Key& key);
  std::optional<Future> future(const Key& key, bool at_rest);
  bool set_reach(const Key& key, std::size_t part, Future& future);
  bool grow(Future& future);
  bool lacks_a_plan_for_ever(const Key& key, const Future& at_rest);
  bool goes_on_for_ever(const Key& key, const Future& future);
  std::vector<bool> lasting(const Future& future);
  bool goes_on(std::size_t location, const std::vector<bool>& lasting, const Future& future);
  [[nodiscard]] bool is_end(const Key& key) const;
  [[nodiscard]] std::optional<Enclosure> hazard(const Future& future) const;
  bool is_hopeless(Future future);
  void find_idle(const Key& key, const Future& future, Told& told);
  std::vector<bool> matter(const Future& future);
  std::optional<PartMoves::Number> settled(const Key& key, std::size_t part, const std::vector<bool>& matters,
                                           const Future& future);

  [[nodiscard]] bool stays_inside(std::size_t location, const Future& future);
  bool holds_in(Conjunct& conjunct, const std::vector<PartMoves::Number>& numbers);
  Chances chances(const Asked& asked, const Future& future);
  Chances chances(Conjunct& conjunct, const Future& future);
  Chances chances(const Condition& condition, const Future& future);

  const automata::Program& program_;
  Slices slices_;
  Question question_;
  Meter& meter_;
  bool known_ = true;  ///< else nothing is told of any state
  std::vector<std::unique_ptr<PartMoves>> parts_;
  Asked target_;                   ///< none of it may fail where the target may hold, as `Condition` has it
  std::vector<std::size_t> ends_;  ///< parts, one of which comes to its end where the target comes to hold; or none
  std::vector<std::vector<automata::LocationId>> children_;
  std::vector<Conjunct> conjuncts_;
  std::vector<Location> locations_;
  automata::Modes base_;  ///< some modes that are possible
  std::map<Key, Told> worked_out_;
  const Told nothing_;
  /// What `settled` has found, by part, reach, commands, and modes of the components that matter.
  std::map<std::tuple<std::size_t, const PartMoves::Reach*, bool, std::vector<std::uint32_t>>,
           std::optional<PartMoves::Number>>
      settled_;
};

}  // namespace rmpl::verifier
