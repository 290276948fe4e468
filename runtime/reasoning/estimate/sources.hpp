// Where k-best searches go out from: the mode combinations of the belief, each with its extensions.
//
// The extensions of a combination depend on the control action, the length of the step and the readings of the clocks
// that matter. Where no clock matters they are remembered from cycle to cycle; where one runs they are worked out anew
// in the memory of the last cycle: one search for all clocks, by the best that any of them promises.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/combination.hpp"
#include "runtime/reasoning/estimate/extensions.hpp"
#include "runtime/reasoning/estimate/filter.hpp"
#include "runtime/reasoning/estimate/k_best_model.hpp"
#include "runtime/reasoning/estimate/possible_share.hpp"
#include "runtime/reasoning/estimate/source.hpp"
#include "runtime/reasoning/estimate/source_key.hpp"

namespace rmpl::runtime {

class Sources {
 public:
  /// Keeps a reference.
  explicit Sources(KBestModel& model);

  /// Once an update, before anything else: past the limits of memory everything is forgotten.
  void begin_update();
  /// What is known of readings. Valid until the next `begin_update`.
  ReadingEvidence& evidence(const automata::Observation& observation) { return context(observation).evidence; }
  /// The combinations of a belief as of `last`, with their extensions in the step. Valid until the next call; keeps
  /// references to the combinations until then.
  std::span<const Source> of(const Combinations& belief, const StepInput& input, automata::Ticks last);
  /// Whether the step goes out from the modes of the last one, in their order, by the same extensions; then `all` are
  /// its sources. Only what they weigh is new: a plant at rest costs no search.
  bool of_rest(const Combinations& belief, const Combinations& before, const StepInput& input, automata::Ticks last);
  [[nodiscard]] std::span<const Source> all() const { return sources_; }
  /// The same states as `of`, with all moves of the components that the readings bring into conflict, each of the
  /// others taking its likeliest move; none where these are too many. Valid until the next call.
  std::vector<Source> exact_on_blamed(const Combinations& belief, const ConflictSet& refuted, const StepInput& rest,
                                      automata::Ticks last);

 private:
  /// The extensions of modes in which no clock matters.
  struct Remembered {
    Remembered(ReadingEvidence& evidence, const MoveTable::Moves& moves, PossibleShare::Share share);
    Extensions extensions;
    double scale;
    double slack;
  };

  /// The extensions of one combination with a running clock.
  struct Transient {
    std::vector<double> scales;  ///< by clocks, or of all
    std::optional<Extensions> extensions;
    std::vector<std::size_t> varied;
    std::vector<const ComponentMoves*> moves;  ///< by clocks, by varied component
    std::vector<ComponentMoves> best;          ///< by varied component
  };

  /// What is remembered for one observation.
  struct Context {
    Context(automata::PlantStep& step, const automata::Observation& observation, ConflictSet& lasting,
            OpenReadings* open)
        : evidence(step, observation, lasting, open) {}
    ReadingEvidence evidence;
    std::unordered_map<SourceKey, Remembered, SourceKeyHash> extensions;
  };

  /// What a search over remembered extensions was about, beside the states that it went out from.
  struct Rest {
    const Context* context;
    automata::ControlAction action;
    automata::Ticks step;
  };

  Context& context(const automata::Observation& observation);
  std::span<const std::size_t> restarted(const automata::Modes& modes, const automata::ControlAction& action,
                                         std::vector<std::size_t>& result);
  Remembered* remembered(Context& context, const Combination& own, const StepInput& input, automata::Ticks last);
  void work_out(std::size_t position, Context& context, const Combination& own, automata::Ticks last,
                automata::Ticks now, Source& source);
  void scale_up(Transient& slot, const Combination& own, Source& source);
  void multiply_shares(const Transient& slot, const automata::Modes& modes, std::size_t cluster);
  PossibleShare::Share possible_share(const automata::Modes& modes, PossibleShare::MovesOf moves,
                                      const PossibleShare::Clusters& clusters);
  [[nodiscard]] std::vector<bool> components_in(const std::vector<Conflict>& conflicts) const;

  KBestModel& model_;
  automata::PlantStep& step_;
  MoveTable table_;
  MoveTable::Moves moves_;
  OpenReadings open_;
  ConflictSet lasting_;  ///< conflicts that need no observation
  std::map<automata::Observation, Context> contexts_;
  std::map<automata::Observation, Context> retired_;  ///< forgotten, and not yet let go of
  std::size_t remembered_ = 0;
  SourceKey key_;
  std::vector<std::unique_ptr<Transient>> transient_;  ///< of sources with a running clock; reused
  std::vector<Source> sources_;
  std::vector<PossibleShare::Share> shares_;         ///< of one source, by clock or of all
  std::vector<std::vector<std::size_t>> differing_;  ///< by source
  std::vector<std::vector<std::size_t>> restarted_;  ///< by source
  std::optional<Rest> rest_;                         ///< of `sources_`, where no clock matters in any of them
  std::vector<std::unique_ptr<Extensions>> obligatory_;
  std::vector<std::vector<std::size_t>> obligatory_restarted_;  ///< of these
};

}  // namespace rmpl::runtime
