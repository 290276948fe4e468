// The k most likely ways through the last updates of a plant, where its states are too many for a trellis.
//
// A* (Hart, Nilsson & Raphael 1968) over sequences of states: the steps out of a state come best first from the search
// of conflict-directed extensions (extensions.hpp), and what is to come is bounded by window_prospects.hpp. So only
// states on ways that may be among the k best are ever looked at. States, and the steps found out of them, are kept
// while they are in the window: a further update adds those after it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/component_moves.hpp"
#include "runtime/reasoning/estimate/extensions.hpp"
#include "runtime/reasoning/estimate/open_readings.hpp"
#include "runtime/reasoning/estimate/possible_share.hpp"
#include "runtime/reasoning/estimate/reading.hpp"
#include "runtime/reasoning/estimate/set_aside.hpp"
#include "runtime/reasoning/estimate/window/window_prospects.hpp"

namespace rmpl::runtime {

class WindowSearch {
 public:
  /// A way: where in the belief it set out, and the modes after each update.
  struct Way {
    double probability = 0;      ///< normalised over those that were found
    std::vector<double> worths;  ///< after each update: the logarithm of what the way is worth until then
    std::size_t from = 0;
    std::vector<automata::Modes> modes;
    std::vector<std::vector<bool>> restarted;  ///< by update, the components whose clocks restarts start anew
  };
  struct Result {
    std::vector<Way> ways;                ///< best first; some may be as good as the k-th, as of `Trellis::best`
    bool cut = false;                     ///< the search ended early: these are the best, but fewer than there are
    std::optional<std::size_t> dead_end;  ///< no way leads beyond this update, the first being 0
  };

  /// Keeps a reference.
  explicit WindowSearch(automata::PlantStep& step);

  /// One more update, after which `likely` is thought to be the state.
  void add(const automata::ControlAction& action, const automata::Observation& observation, automata::Ticks before,
           automata::Ticks now, const automata::Modes& likely);
  void drop_first();

  /// The `k` best ways from the belief through all updates, each of which counts as `counted` says.
  Result best(const Belief& from, const std::vector<Counted>& counted, std::size_t k);
  /// After a dead end: takes in what the states that the last search came to before an update may become after it.
  void add_targets(std::size_t update, StepTargets& targets);

 private:
  /// What one observation says, and what the states lead to under it, where no clock matters.
  struct Context;
  /// A state, as far as the future depends on it, with the steps out of it found so far.
  struct Node {
    automata::SystemState state;  ///< clocks that nothing asks for are 0
    std::shared_ptr<Extensions> steps;
    double scale = 0;                    ///< logarithm of what its steps are worth more, as some cannot happen
    std::optional<double> most;          ///< what its steps are worth at most
    std::vector<std::uint32_t> targets;  ///< by extension: nodes of the layer behind
    std::vector<std::pair<double, double>> limits;  ///< of one search: at most, and what may be gained behind
    std::size_t visits = 0;                         ///< likewise
    std::size_t search = 0;                         ///< which one
  };
  /// The states before an update, and the update.
  struct Layer {
    std::vector<Node> nodes;
    std::unordered_map<automata::SystemState, std::uint32_t, SystemStateHash> numbers;  ///< looked up, never iterated
    automata::ControlAction action;
    automata::Observation observation;
    automata::Ticks before, now;
    automata::Modes likely;  ///< after it
    Counted counted;
    std::shared_ptr<Context> context;
    NearbyFactors factors;
    MoveTable::Passing moves;
  };
  /// A way as far as it was followed.
  struct Path {
    std::uint32_t node;
    std::uint32_t parent;  ///< at the start: its place in the belief
    std::uint32_t updates;
    double worth;  ///< logarithm, without what is to come
  };
  /// A path whose next step is the extension at `place`; none: its steps were not looked at yet.
  struct Open {
    double bound;
    std::uint32_t path;
    std::uint32_t place;
    bool operator<(const Open& other) const {
      if (bound != other.bound) return bound < other.bound;
      return path != other.path ? path > other.path : place > other.place;
    }
  };
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  void forget();
  static void forget(Layer& layer);
  static std::uint32_t number(Layer& layer, automata::SystemState state);
  std::shared_ptr<Context> context(const automata::Observation& observation);
  void take(const std::vector<Counted>& counted);
  static void look_at_factors(Layer& layer);
  [[nodiscard]] WindowProspects look_ahead() const;
  void begin(const Belief& from, const WindowProspects& prospects);
  void push(const Path& path, double bound);
  void push(const Open& open);
  Node& node_of(const Path& path) { return layers_[path.updates].nodes[path.node]; }
  std::size_t visit(Node& node) const;
  void open_steps(std::uint32_t path, const WindowProspects& prospects);
  void find_steps(Layer& layer, Node& node);
  static void limit(Node& node, std::size_t updates, const WindowProspects& prospects);
  static double bound(const Node& node, std::size_t place);
  void follow(std::uint32_t path, std::uint32_t place, const WindowProspects& prospects);
  [[nodiscard]] Way trace(std::uint32_t path);
  void learn(const Way& best);

  automata::PlantStep& step_;
  PossibleShare possible_;
  const Clocks clocks_;
  MoveTable table_;
  MoveTable::Moves moves_;
  OpenReadings open_readings_;
  ConflictSet lasting_;
  std::map<automata::Observation, std::weak_ptr<Context>> contexts_;
  std::deque<Layer> layers_;  ///< the last is behind the last update
  std::vector<Path> paths_;
  std::vector<Open> queue_;  ///< a heap
  std::size_t searches_ = 0, work_ = 0, deepest_ = 0;
};

}  // namespace rmpl::runtime
