// What a part of a plant may come to by itself, whatever its clocks read.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/markov/enclosure.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/slice/slices.hpp"

namespace rmpl::verifier {

/// Components that no guard and no constraint connects with others. Their modes are numbered as they are met. Not for
/// use from two threads at once.
class PartMoves {
 public:
  /// Modes of all components of the part, by number.
  using Number = std::uint32_t;
  /// What can be reached: numbers, ascending.
  using Reach = std::vector<Number>;

  PartMoves(Cone cone, Part part, automata::Ticks period);
  PartMoves(const PartMoves&) = delete;
  PartMoves& operator=(const PartMoves&) = delete;

  [[nodiscard]] const Cone& cone() const { return cone_; }
  [[nodiscard]] const automata::Plant& plant() const { return part_.plant(); }
  /// Whether its components have so many modes together that nothing is told.
  [[nodiscard]] bool is_too_large() const;
  /// Steps end where the formula, over variables of the whole, is implied, or (not `entailed`) allowed.
  void end_in(const automata::Formula& target, bool entailed);

  /// The number of the modes that the whole has there.
  Number number(const automata::Modes& whole);
  /// Gives the components of the part these modes.
  void assign(Number number, automata::Modes& whole) const;

  [[nodiscard]] bool is_end(Number number) const { return states_[number].end; }

  /// What may be reached from there up to the end, itself included, faults too: under commands of any kind, or with all
  /// controls idle. Null where that is not known: a limit stops it, idle controls are not permitted somewhere, or in
  /// some step nothing may follow. The pointer lasts.
  const Reach* reach(Number from, Commands commands, Meter& meter);
  /// The same under commands of any kind, by way of the end, too.
  const Reach* reach_past_end(Number from, Meter& meter);
  /// Those from which the end may yet be reached under commands of any kind, and that are no end. Null where that is
  /// not known. The pointer lasts.
  const Reach* undecided(const Reach& reach, Meter& meter);
  /// Of what is reached under those commands and `alike` takes, what least can be reached from; of several the first in
  /// the order of modes. Nothing where there is none.
  template <class Alike>
  std::optional<Number> most_settled(const Reach& reach, Commands commands, Meter& meter, const Alike& alike);
  [[nodiscard]] const automata::Modes& modes(Number number) const { return states_[number].modes; }
  /// Whether commands may come to more reward from somewhere there than what idle controls come to at least.
  bool gains(const Reach& reach, Meter& meter);
  /// At least and at most how likely one step from somewhere there is to come to where steps end.
  [[nodiscard]] Enclosure hazard(const Reach& reach, Commands commands) const;

 private:
  struct Steps {
    bool known = false;
    std::vector<std::pair<Number, bool>> to;  ///< ascending, each once; whether it takes no fault
    Enclosure hit{1, 0};                      ///< at least and at most how likely it is to come to the end
  };
  struct State {
    automata::Modes modes;
    bool end = false;
    double reward = 0;
    std::optional<Steps> idle, any;
    std::optional<const Reach*> reach_idle, reach_any, reach_past_end;
    std::optional<bool> gains;
  };

  Number enter(const automata::Modes& modes);
  const Steps& steps(Number from, Commands commands, Meter& meter);
  Steps work_out(Number from, Commands commands, Meter& meter);
  bool draw(Number from, const automata::AllEnabled& enabled, Steps& steps, Meter& meter);
  bool gains_at(Number from, Meter& meter);
  enum class Along { every_step, nominal_steps };
  enum class To { end, everywhere };
  const Reach* keep(std::unique_ptr<Reach> found, bool complete);
  template <class Visit>
  bool search(Number from, Commands commands, Along along, To to, Meter& meter, const Visit& visit);

  Cone cone_;
  Part part_;
  automata::PlantStep step_;
  automata::Ticks period_;
  std::optional<automata::Theory::Handle> target_;
  bool entailed_ = false;
  std::map<automata::Modes, Number> numbers_;
  std::vector<State> states_;
  std::vector<std::unique_ptr<Reach>> reaches_;
  std::map<const Reach*, const Reach*> undecided_;
  std::size_t outcomes_ = 0;  ///< drawn so far
};

template <class Alike>
std::optional<PartMoves::Number> PartMoves::most_settled(const Reach& reach, Commands commands, Meter& meter,
                                                         const Alike& alike) {
  std::optional<Number> result;
  std::size_t least = 0;
  for (const Number at : reach) {
    if (!alike(modes(at))) continue;
    const Reach* const next = this->reach(at, commands, meter);
    if (next == nullptr) continue;
    const bool better = !result || next->size() < least || (next->size() == least && modes(at) < modes(*result));
    if (!better) continue;
    result = at;
    least = next->size();
  }
  return result;
}

}  // namespace rmpl::verifier
