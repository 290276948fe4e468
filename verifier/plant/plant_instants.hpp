// What may happen at an instant in a plant: for the search for standstills.
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <map>
#include <memory>

#include "verifier/plant/instant_clocks.hpp"
#include "verifier/plant/situation.hpp"
#include "verifier/search/standstill.hpp"

namespace rmpl::verifier {

/// From one situation on; nodes are numbers of situations. Keeps references.
class PlantInstants : public Instants {
 public:
  /// `others` clocks come before those of the live components in the zone.
  PlantInstants(Situations& situations, SituationId root, const Situation& here, std::size_t others, const Zone& zone);

  const std::vector<ZoneBox>& waits(std::uint64_t node) override;
  const Instant* step(std::uint64_t node, std::size_t number) override;

 private:
  [[nodiscard]] Late late(const Situation& there) const;
  void add_periods(std::vector<ZoneBox>& result);

  Situations& situations_;
  SituationId root_;
  InstantClocks clocks_;
  const Zone& zone_;
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
