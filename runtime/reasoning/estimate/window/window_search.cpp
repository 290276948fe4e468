// Ways are opened best first; each takes its next step only when nothing else may be better.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/window/window_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/estimate/source_key.hpp"

namespace rmpl::runtime {

using automata::Modes;
using automata::Observation;
using automata::SystemState;
using automata::Ticks;

namespace {

/// Ways that are taken up and candidates that are checked, together; beyond, the search ends.
constexpr std::size_t most_work = 100'000;

/// Sums of logarithms that are nearer than this may be equal.
constexpr double margin = 1e-9;

/// Beyond so many sources or conflicts what is remembered for one observation is begun anew, and beyond so many
/// conflicts that need no observation these are forgotten.
constexpr std::size_t context_limit = 1024;
constexpr std::size_t conflict_limit = 512;
constexpr std::size_t table_limit = 1u << 15;

/// Beyond so many ways of some components to gain, the best of each is taken.
constexpr std::size_t most_limits = 256;

/// Outcomes of a state that are looked at for what of them can happen; beyond, they are not scaled.
constexpr std::size_t most_joint_outcomes = std::size_t{1} << 16;

constexpr double log_of_zero = -std::numeric_limits<double>::infinity();

}  // namespace

struct WindowSearch::Context {
  Context(automata::PlantStep& step, const Observation& observation, ConflictSet& lasting, OpenReadings* open)
      : evidence(step, observation, lasting, open) {}
  ReadingEvidence evidence;
  struct Known {
    std::shared_ptr<Extensions> steps;
    double scale;
  };
  std::unordered_map<SourceKey, Known, SourceKeyHash> steps;
};

WindowSearch::WindowSearch(automata::PlantStep& step)
    : step_(step),
      possible_(step, most_joint_outcomes),
      clocks_(step.plant(), true),
      table_(step.plant()),
      open_readings_(step) {
  layers_.emplace_back();
}

void WindowSearch::add(const automata::ControlAction& action, const Observation& observation, Ticks before, Ticks now,
                       const Modes& likely) {
  if (table_.size() > table_limit) forget();
  Layer& layer = layers_.back();
  layer.action = action;
  layer.observation = observation;
  layer.before = before;
  layer.now = now;
  layer.likely = likely;
  layers_.emplace_back();
}

void WindowSearch::drop_first() { layers_.pop_front(); }

/// All but the states themselves.
void WindowSearch::forget() {
  for (Layer& layer : layers_) {
    forget(layer);
    layer.context.reset();
  }
  contexts_.clear();
  table_.forget();
}

void WindowSearch::forget(Layer& layer) {
  for (Node& node : layer.nodes) {
    node.steps.reset();
    node.most.reset();
    node.targets.clear();
  }
  layer.moves.clear();
}

std::uint32_t WindowSearch::number(Layer& layer, SystemState state) {
  const auto next = static_cast<std::uint32_t>(layer.nodes.size());
  const auto [known, fresh] = layer.numbers.try_emplace(state, next);
  if (fresh) layer.nodes.push_back({std::move(state), nullptr, 0, std::nullopt, {}, {}});
  return known->second;
}

std::shared_ptr<WindowSearch::Context> WindowSearch::context(const Observation& observation) {
  if (contexts_.size() > context_limit) {
    std::erase_if(contexts_, [](const auto& known) { return known.second.expired(); });
  }
  std::weak_ptr<Context>& known = contexts_[observation];
  auto context = known.lock();
  const bool full = context && (context->steps.size() > context_limit ||
                                context->evidence.conflicts()->conflicts().size() > context_limit);
  if (!context || full) {
    if (lasting_.conflicts().size() > conflict_limit) lasting_ = {};
    context = std::make_shared<Context>(step_, observation, lasting_, &open_readings_);
    known = context;
  }
  return context;
}

/// How each update counts, and what is known of the factors near what is likely.
void WindowSearch::take(const std::vector<Counted>& counted) {
  for (std::size_t t = 0; t < counted.size(); ++t) {
    Layer& layer = layers_[t];
    if (layer.context && layer.counted == counted[t]) continue;
    forget(layer);
    layer.counted = counted[t];
    layer.context = context(without(layer.observation, layer.counted.set_aside));
    look_at_factors(layer);
  }
}

void WindowSearch::look_at_factors(Layer& layer) {
  layer.factors = {};
  if (layer.counted.stands || !layer.context->evidence.bounds_factors()) return;
  NearbyFactors found = layer.context->evidence.nearby_factors(layer.likely);
  if (found.most < 1) layer.factors = std::move(found);
}

WindowProspects WindowSearch::look_ahead() const {
  std::vector<WindowProspects::Update> updates;
  for (std::size_t t = 0; t + 1 < layers_.size(); ++t) {
    const Layer& layer = layers_[t];
    updates.push_back({&layer.factors, layer.now - layer.before});
  }
  return {step_.plant(), updates, possible_.excluding()};
}

WindowSearch::Result WindowSearch::best(const Belief& from, const std::vector<Counted>& counted, std::size_t k) {
  CHECK(counted.size() + 1 == layers_.size());
  take(counted);
  const WindowProspects prospects = look_ahead();
  begin(from, prospects);
  Result result;
  const std::size_t enough = 2 * k + 64;
  std::vector<std::uint32_t> found;
  while (!queue_.empty() && found.size() < enough) {
    const Open next = queue_.front();
    if (found.size() >= k && next.bound < paths_[found[k - 1]].worth - margin) break;
    if (++work_ > most_work) {
      result.cut = true;
      break;
    }
    std::pop_heap(queue_.begin(), queue_.end());
    queue_.pop_back();
    const Path path = paths_[next.path];
    if (path.updates == counted.size()) {
      found.push_back(next.path);
    } else if (next.place == none) {
      if (visit(node_of(path)) <= enough) open_steps(next.path, prospects);
    } else {
      follow(next.path, next.place, prospects);
    }
  }
  if (found.empty() && !result.cut) result.dead_end = deepest_;
  if (found.empty()) return result;
  double total = 0;
  for (const std::uint32_t path : found) {
    Way& way = result.ways.emplace_back(trace(path));
    way.probability = std::exp(paths_[path].worth - paths_[found.front()].worth);
    if (result.ways.size() <= k) total += way.probability;
  }
  for (Way& way : result.ways) way.probability /= total;
  learn(result.ways.front());
  return result;
}

void WindowSearch::add_targets(std::size_t update, StepTargets& targets) {
  const Layer& layer = layers_[update];
  for (const Node& node : layer.nodes) {
    if (node.search != searches_) continue;
    targets.add(step_.moves(node.state, layer.action, layer.before, layer.now));
  }
}

void WindowSearch::begin(const Belief& from, const WindowProspects& prospects) {
  paths_.clear();
  queue_.clear();
  work_ = deepest_ = 0;
  ++searches_;
  for (std::uint32_t i = 0; i < from.size(); ++i) {
    SystemState state = from[i].state;
    for (std::size_t c = 0; c < state.modes.size(); ++c) {
      if (!clocks_.live(c, state.modes[c])) state.clock_starts[c] = {};
    }
    const double worth = std::log(from[i].probability);
    const double promise = worth + prospects.of(0, state.modes);
    push({number(layers_.front(), std::move(state)), i, 0, worth}, promise);
  }
}

void WindowSearch::push(const Path& path, double bound) {
  if (bound == log_of_zero) return;
  deepest_ = std::max<std::size_t>(deepest_, path.updates);
  paths_.push_back(path);
  push({bound, static_cast<std::uint32_t>(paths_.size() - 1), none});
}

void WindowSearch::push(const Open& open) {
  if (open.bound == log_of_zero) return;
  queue_.push_back(open);
  std::push_heap(queue_.begin(), queue_.end());
}

/// How many paths have led here in this search.
std::size_t WindowSearch::visit(Node& node) const {
  if (std::exchange(node.search, searches_) != searches_) {
    node.limits.clear();
    node.visits = 0;
  }
  return ++node.visits;
}

/// A path whose steps are wanted now.
void WindowSearch::open_steps(std::uint32_t path, const WindowProspects& prospects) {
  const Path& own = paths_[path];
  Layer& layer = layers_[own.updates];
  Node& node = layer.nodes[own.node];
  if (layer.counted.stands) {
    const double worth = own.worth;
    const std::uint32_t updates = own.updates + 1;
    const std::uint32_t same = number(layers_[updates], node.state);
    push({same, path, updates, worth}, worth + prospects.of(updates, layers_[updates].nodes[same].state.modes));
    return;
  }
  if (!node.steps) find_steps(layer, node);
  if (node.limits.empty()) limit(node, own.updates + 1, prospects);
  push({own.worth + bound(node, 0), path, 0});
}

/// The extensions of a state: remembered under the observation where no clock matters.
void WindowSearch::find_steps(Layer& layer, Node& node) {
  Context& context = *layer.context;
  const SystemState& state = node.state;
  SourceKey key{state.modes, layer.action, layer.now - layer.before};
  if (const auto known = context.steps.find(key); known != context.steps.end()) {
    node.steps = known->second.steps;
    node.scale = known->second.scale;
    return;
  }
  table_.look_up(step_, state.modes, state.clock_starts, layer.action, layer.before, layer.now, layer.moves, moves_);
  node.steps = std::make_shared<Extensions>(context.evidence, moves_);
  const auto share = possible_.of(state.modes, [&](std::size_t c) { return moves_[c]->moves(); });
  node.scale = share.exact && share.value > 0 ? -std::log(share.value) : 0;
  if (table_.timed().empty()) context.steps.try_emplace(std::move(key), Context::Known{node.steps, node.scale});
  if (!layer.factors.gains.empty()) node.steps->tighten();
}

/// What the steps of a node can be worth at most, by where they take the components that may gain later.
void WindowSearch::limit(Node& node, std::size_t updates, const WindowProspects& prospects) {
  const Extensions& steps = *node.steps;
  if (prospects.contested().empty()) {
    node.limits.emplace_back(0.0, prospects.to_come(updates));
    return;
  }
  const auto greatest = [&](std::size_t component) {
    double most = 0;
    for (const OptimalSearch::PricedValue& choice : steps.choices(component)) {
      most = std::max(most, steps.promise(component, automata::ModeId(choice.value)));
    }
    return most;
  };
  if (!node.most) {
    node.most = std::log(steps.greatest_factor());
    for (std::size_t c = 0; c < node.state.modes.size(); ++c) *node.most += std::log(greatest(c));
  }
  std::vector<std::pair<double, double>> limits{{*node.most, prospects.to_come(updates)}};
  for (const WindowProspects::Contested& contested : prospects.contested()) {
    const std::vector<double>& gain = contested.gain[updates];
    std::vector<std::pair<double, double>> next;
    const double likeliest = greatest(contested.component);
    double all = log_of_zero;
    for (const OptimalSearch::PricedValue& choice : steps.choices(contested.component)) {
      const double share = steps.promise(contested.component, automata::ModeId(choice.value));
      all = std::max(all, gain[choice.value]);
      for (const auto& [limit, gained] : limits) {
        next.emplace_back(limit + std::log(share / likeliest), gained + gain[choice.value]);
      }
    }
    if (next.size() <= most_limits) {
      limits = std::move(next);
    } else {
      for (auto& [limit, gained] : limits) gained += all;
    }
  }
  node.limits = std::move(limits);
}

/// Of the step at `place` and all that come later, with what is to come behind them.
double WindowSearch::bound(const Node& node, std::size_t place) {
  const double left = node.steps->bound(place);
  if (!(left > 0)) return log_of_zero;
  double result = log_of_zero;
  for (const auto& [limit, gained] : node.limits) result = std::max(result, std::min(std::log(left), limit) + gained);
  return result + node.scale;
}

void WindowSearch::follow(std::uint32_t path, std::uint32_t place, const WindowProspects& prospects) {
  const Path own = paths_[path];
  Layer& layer = layers_[own.updates];
  Node& node = layer.nodes[own.node];
  if (place == node.steps->found().size()) {
    node.steps->check_one();
    push({own.worth + bound(node, place), path, place});
    return;
  }
  const Extension& extension = node.steps->found()[place];
  Layer& behind = layers_[own.updates + 1];
  while (node.targets.size() <= place) {
    const Modes& modes = node.steps->found()[node.targets.size()].modes;
    SystemState state{modes, node.state.clock_starts};
    const std::vector<bool>& restarted = step_.restarted(node.state.modes, layer.action);
    for (std::size_t c = 0; c < modes.size(); ++c) {
      state.clock_starts[c] =
          clocks_.advance(c, node.state.modes[c], node.state.clock_starts[c], modes[c], layer.now, restarted[c]);
    }
    node.targets.push_back(number(behind, std::move(state)));
  }
  const std::uint32_t target = node.targets[place];
  const double worth = own.worth + std::log(extension.prior) + std::log(extension.factor) + node.scale;
  push({target, path, own.updates + 1, worth}, worth + prospects.of(own.updates + 1, behind.nodes[target].state.modes));
  push({own.worth + bound(node, place + 1), path, place + 1});
}

WindowSearch::Way WindowSearch::trace(std::uint32_t path) {
  Way way;
  for (; paths_[path].updates > 0; path = paths_[path].parent) {
    way.modes.push_back(layers_[paths_[path].updates].nodes[paths_[path].node].state.modes);
    way.worths.push_back(paths_[path].worth);
    const Path& from = paths_[paths_[path].parent];
    const Layer& layer = layers_[from.updates];
    const Modes& modes = layer.nodes[from.node].state.modes;
    way.restarted.push_back(layer.counted.stands ? std::vector<bool>(modes.size())
                                                 : step_.restarted(modes, layer.action));
  }
  way.from = paths_[path].parent;
  std::reverse(way.modes.begin(), way.modes.end());
  std::reverse(way.worths.begin(), way.worths.end());
  std::reverse(way.restarted.begin(), way.restarted.end());
  return way;
}

/// What is most likely in hindsight is the better base for bounds from now on.
void WindowSearch::learn(const Way& best) {
  for (std::size_t t = 0; t < best.modes.size(); ++t) {
    if (layers_[t].likely == best.modes[t]) continue;
    layers_[t].likely = best.modes[t];
    look_at_factors(layers_[t]);
  }
}

}  // namespace rmpl::runtime
