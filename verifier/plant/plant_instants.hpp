// What may happen at an instant in a plant: for the search for standstills.
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <map>
#include <memory>

#include "verifier/behaviour/situation.hpp"
#include "verifier/plant/instant_clocks.hpp"
#include "verifier/search/standstill.hpp"

namespace rmpl::verifier {

/// From one situation on; nodes are numbers of situations. What is due moves in the next step. Steps that exist only at
/// one instant do not count (semantics 7, "an instant saves no run"). Keeps references.
class PlantInstants : public Instants {
 public:
  /// `others` clocks come before those of the live components in the zone. `folds`: where timers are folded;
  /// `idle`: steps that take a command are none.
  PlantInstants(Situations& situations, SituationId root, const Situation& here, std::size_t others, const Zone& zone,
                Folds* folds = nullptr, bool idle = false);

  /// A component that was folded, and is asked for its mode a few steps on: nothing was found out then.
  [[nodiscard]] const std::optional<automata::ComponentId>& asked() const { return asked_; }

  const std::vector<ZoneBox>& waits(std::uint64_t node) override;
  const Instant* step(std::uint64_t node, std::size_t number) override;

 private:
  /// What is at its bound, or beyond, at some reading; with `always` at each.
  [[nodiscard]] Late late(const Situation& there, bool always) const;
  void add_periods(std::vector<ZoneBox>& result);
  [[nodiscard]] bool asks(std::uint64_t node);

  Situations& situations_;
  SituationId root_;
  const Situation& here_;
  std::size_t others_;
  InstantClocks clocks_;
  const Zone& zone_;
  Folds* folds_;
  bool idle_;
  std::optional<automata::ComponentId> asked_;
  std::map<std::uint64_t, std::vector<ZoneBox>> waits_;
  /// Of one node: its moves, and the steps that the first so many of them are.
  struct Steps {
    std::shared_ptr<const Situation> from;
    std::shared_ptr<const std::vector<JointStep>> moves;
    std::size_t looked_at = 0;
    std::deque<Instant> found;
  };
  std::map<std::uint64_t, Steps> steps_;
};

}  // namespace rmpl::verifier
