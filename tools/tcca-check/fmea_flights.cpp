// A flight without the fault; one with it, compared step by step with its twin without it; and one without it that has
// the random numbers of the second.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/fmea_flights.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "automata/controls.hpp"
#include "automata/fault_step.hpp"
#include "base/error.hpp"
#include "runtime/executive/campaign/counterfactual.hpp"
#include "runtime/executive/plant/luck.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/reasoning/reconfigure/outcome.hpp"

namespace rmpl::tools {
namespace {

using automata::Modes;
using automata::Plant;
using automata::Ticks;
using runtime::CycleRecord;
using verifier::FailureMode;
using verifier::FlownFault;

/// Flights in which something else fails by chance are drawn anew, so often.
constexpr std::uint64_t most_draws = 16;
/// How long a flight goes on after what it is flown for, at least.
constexpr Ticks afterwards{3600 * Ticks::per_second};

bool is_forced(const CycleRecord& record, std::size_t component) {
  return std::any_of(record.events.begin(), record.events.end(), [&](const runtime::Event& event) {
    return event.kind == runtime::Event::Kind::forced && event.component == automata::ComponentId(component);
  });
}

/// Whether a component goes into a fault mode by itself.
bool fails_by_chance(const Plant& plant, const Modes& before, const CycleRecord& record) {
  for (std::size_t c = 0; c < before.size(); ++c) {
    if (automata::is_fault_step(plant.components[c], before[c], (*record.truth)[c]) && !is_forced(record, c))
      return true;
  }
  return false;
}

/// Looks at a flight without injections.
class Calm final : public runtime::CycleObserver {
 public:
  explicit Calm(const Plant& plant) : plant_(plant) {}

  void observe(const CycleRecord& record) override {
    if (record.cycle > 0) unlucky_ = unlucky_ || fails_by_chance(plant_, before_, record);
    before_ = *record.truth;
    for (std::size_t c = 0; c < before_.size(); ++c) entered_.try_emplace({c, before_[c]}, record.time);
  }
  [[nodiscard]] bool unlucky() const { return unlucky_; }
  /// The end of the first cycle with the component in that mode.
  [[nodiscard]] std::optional<Ticks> entered(automata::ComponentId component, automata::ModeId mode) const {
    const auto at = entered_.find({component.index(), mode});
    return at == entered_.end() ? std::nullopt : std::optional(at->second);
  }

 private:
  const Plant& plant_;
  Modes before_;
  std::map<std::pair<std::size_t, automata::ModeId>, Ticks> entered_;
  bool unlucky_ = false;
};

/// Looks at a flight with the fault.
class Watch final : public runtime::CycleObserver {
 public:
  Watch(const Plant& plant, const verifier::FaultStep& fault) : plant_(plant), step_(plant), fault_(fault) {}

  void observe(const CycleRecord& record) override {
    if (record.cycle > 0) {
      const bool there = (*record.truth)[fault_.component.index()] == fault_.to;
      if (!flown_ && there && is_forced(record, fault_.component.index())) {
        if (before_.modes[fault_.component.index()] != fault_.from) unlucky_ = true;
        flown_.emplace().happened = record.time;
        twin_.emplace(step_, before_, fault_.component);
      }
      unlucky_ = unlucky_ || fails_by_chance(plant_, before_.modes, record);
      if (flown_) follow(record);
    }
    if (record.cycle == 0) {
      before_ = {*record.truth, std::vector<Ticks>(record.truth->size())};
    } else {
      before_ = step_.advance(before_, record.command, *record.truth, record.time);
    }
    from_ = record.time;
  }

  /// Nothing where the fault has not happened in its mode, or something else failed by chance.
  std::optional<FlownFault> result() { return unlucky_ ? std::nullopt : std::move(flown_); }

 private:
  void follow(const CycleRecord& record) {
    flown_->until = record.time;
    const Ticks after{record.time.count - flown_->happened.count};
    if (flown_->named_after && flown_->outcome.empty()) {
      flown_->outcome = runtime::name_of(record.outcome);
      flown_->response = automata::commanded(plant_, record.command);
    }
    if (twin_) {
      const bool contradicted = twin_->contradicted_by(
          {before_.modes, *record.truth, record.command, record.observations, record.events, from_, record.time});
      note_effects(*record.truth, after);
      if (contradicted) note_symptoms(record.observations, after);
    }
    if (!flown_->named_after && record.estimate[fault_.component.index()] == fault_.to) {
      flown_->named_after = after;
      twin_.reset();  // from now on the executive acts on it
    }
    for (std::size_t c = 0; c < record.estimate.size() && !flown_->named_after && !flown_->taken_for; ++c) {
      const automata::ModeId mode = record.estimate[c];
      if (mode == (*record.truth)[c] || !plant_.components[c].modes[mode.index()].fault) continue;
      flown_->taken_for = {plant_.components[c].mode, automata::ValueId(mode.index())};
    }
  }

  void note_effects(const Modes& truth, Ticks after) {
    const Modes& without = twin_->state().modes;
    if (compared_ && compared_->first == truth && compared_->second == without) return;
    compared_ = {truth, without};
    for (std::size_t v = 0; v < plant_.variables.size(); ++v) {
      const automata::VariableId variable(v);
      if (automata::is_control(plant_, variable) || plant_.component_of(variable) == fault_.component) continue;
      const auto with = verifier::implied(step_, truth, variable);
      const auto other = verifier::implied(step_, without, variable);
      const bool known = std::any_of(flown_->effects.begin(), flown_->effects.end(),
                                     [&](const verifier::LaterEffect& effect) { return effect.variable == variable; });
      if (with != other && !known) flown_->effects.push_back({variable, other, with, after});
    }
  }

  /// The readings that the twin cannot have, each by itself; or, where only together they are too much, all.
  void note_symptoms(const automata::Observation& readings, Ticks after) {
    if (flown_->symptom_after) return;
    flown_->symptom_after = after;
    for (const automata::Assignment& reading : readings) {
      if (!step_.explains(twin_->state().modes, {reading})) flown_->symptoms.push_back(reading);
    }
    if (flown_->symptoms.empty()) flown_->symptoms = readings;
  }

  const Plant& plant_;
  automata::PlantStep step_;
  const verifier::FaultStep& fault_;
  automata::SystemState before_;
  Ticks from_;
  std::optional<FlownFault> flown_;
  std::optional<runtime::Counterfactual> twin_;  ///< until the estimate has the fault
  std::optional<std::pair<Modes, Modes>> compared_;
  bool unlucky_ = false;
};

class Flights {
 public:
  Flights(const automata::Document& document, Ticks cycle, Ticks duration, const std::atomic<bool>* interrupted)
      : document_(document), plant_(document.plants.front()) {
    scenario_.cycle = cycle;
    scenario_.duration = duration;
    options_.interrupted = [interrupted] { return interrupted != nullptr && interrupted->load(); };
  }

  [[nodiscard]] bool interrupted() const { return options_.interrupted(); }

  /// When the program ends without a fault, in the first flight without one.
  std::optional<Ticks> ended() {
    for (std::uint64_t seed = 0; seed < most_draws; ++seed) {
      if (const Unhurt* flight = without(seed)) return flight->ended;
    }
    return std::nullopt;
  }

  std::optional<FlownFault> with(const verifier::FaultStep& fault) {
    for (std::uint64_t seed = 0; seed < most_draws && !interrupted(); ++seed) {
      const Unhurt* unhurt = without(seed);
      if (unhurt == nullptr) continue;
      const std::optional<Ticks> entered = unhurt->calm.entered(fault.component, fault.from);
      if (!entered) continue;
      options_.seed = seed;
      options_.awaited = {{Ticks{entered->count + scenario_.cycle.count}, fault.component, fault.to, {}}};
      const auto luck = std::make_shared<runtime::Luck>();
      options_.luck = {luck, nullptr};
      Watch watch(plant_, fault);
      const auto ended = fly(watch);
      options_.awaited.clear();
      options_.luck = {};
      auto flown = ended ? watch.result() : std::nullopt;
      if (!flown) continue;
      options_.luck = {nullptr, luck};
      const std::optional<Unhurt> twin = fly_calm();
      options_.luck = {};
      if (!twin) continue;
      flown->ended = *ended;
      flown->ended_without = twin->ended;
      flown->seed = seed;
      return flown;
    }
    return std::nullopt;
  }

 private:
  struct Unhurt {
    Calm calm;
    std::optional<Ticks> ended;
  };

  /// When the program ended, if it did; nothing where the flight came to no end.
  std::optional<std::optional<Ticks>> fly(runtime::CycleObserver& observer) {
    try {
      const runtime::ScenarioResult result = runtime::run_scenario(document_, scenario_, options_, {&observer});
      if (result.interrupted) return std::nullopt;
      return result.ended;
    } catch (const base::InputError&) {  // the model has nowhere to go
      return std::nullopt;
    }
  }

  /// The flight by the options as they are; nothing where something fails in it, or it comes to no end.
  std::optional<Unhurt> fly_calm() {
    Unhurt flight{Calm(plant_), {}};
    const auto ended = fly(flight.calm);
    if (!ended || flight.calm.unlucky()) return std::nullopt;
    flight.ended = *ended;
    return flight;
  }

  /// The flight with this seed in which nothing fails; null where something does.
  const Unhurt* without(std::uint64_t seed) {
    const auto [at, fresh] = unhurt_.try_emplace(seed);
    if (fresh) {
      options_.seed = seed;
      if (auto flight = fly_calm()) at->second.emplace(std::move(*flight));
    }
    return at->second ? &*at->second : nullptr;
  }

  const automata::Document& document_;
  const Plant& plant_;
  automata::Scenario scenario_;
  runtime::ScenarioOptions options_;
  std::map<std::uint64_t, std::optional<Unhurt>> unhurt_;
};

}  // namespace

void fly_rows(const automata::Document& document, verifier::FailureModes& table, Ticks cycle,
              const std::atomic<bool>* interrupted) {
  Ticks last = table.succeeds.value_or(Ticks{});
  for (const FailureMode& row : table.rows) last = std::max(last, row.earliest.value_or(Ticks{}));
  Flights flights(document, cycle, Ticks{last.count + afterwards.count}, interrupted);
  table.ended = flights.ended();
  for (FailureMode& row : table.rows) {
    if (row.earliest) row.flown = flights.with(row.fault);
    row.flights_cut = row.earliest && !row.flown && flights.interrupted();
    if (row.flights_cut) table.limit = verifier::Limit::interrupt;
  }
}

}  // namespace rmpl::tools
