// Instances by names: neighbours are cut out, named relative to themselves, and compared with the types so far.
// SPDX-License-Identifier: MIT
#include "automata/outline.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "automata/instance.hpp"
#include "base/hash.hpp"

namespace rmpl::automata {
namespace {

/// Names with more dots are taken as they are: a document may have any.
constexpr std::size_t depth_limit = 200;

/// Hashes a plant: all that tells two apart, but where a component starts that is the only one, and whether it is one
/// of progress.
class Print {
 public:
  explicit Print(const Plant& plant) {
    for (const Variable& variable : plant.variables) {
      add(variable.name);
      for (const std::string& value : variable.values) add(value);
    }
    for (const Component& component : plant.components) {
      add(component);
      if (plant.components.size() == 1) continue;
      for (const double p : component.initial) add(p);
    }
    for (const Interconnection& q : plant.interconnections) {
      add(q.constraint);
      add(q.origin);
    }
    for (const Control& control : plant.controls) {
      add(control.variable.index());
      add(control.idle.index());
    }
    for (const VariableId observable : plant.observables) add(observable.index());
  }
  [[nodiscard]] std::uint64_t hash() const { return hash_; }

 private:
  void add(std::uint64_t word) { hash_ = base::mix(hash_, word); }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number == 0 ? 0.0 : number)); }  // -0 is 0
  void add(const std::string& text) { add(std::hash<std::string>{}(text)); }
  void add(const Origin& origin) {
    add(origin.file);
    add((std::uint64_t{origin.line} << 32) + origin.column);
  }
  void add(const Formula& formula) {
    add(static_cast<std::uint64_t>(formula.kind) * 2 + (formula.truth ? 1 : 0));
    add(formula.variable.index());
    add(formula.other.index());
    for (const ValueId value : formula.values) add(value.index());
    for (const Formula& operand : formula.operands) add(operand);
  }
  void add(const Timing& timing) {
    add(static_cast<std::uint64_t>(timing.lower.count));
    add(static_cast<std::uint64_t>(timing.upper.count));
    add(static_cast<std::uint64_t>(timing.density.kind));
    add(timing.density.mean);
    add(timing.density.standard_deviation);
    add(timing.density.shape);
    add(timing.density.scale);
  }
  void add(const Component& component) {
    add(component.type);
    add(component.origin);
    for (const Mode& mode : component.modes) {
      add(static_cast<std::uint64_t>(mode.fault));
      add(mode.constraint);
      add(mode.reward);
      add(mode.origin);
    }
    for (const Transition& transition : component.transitions) {
      add(transition.from.index());
      add(transition.to.index());
      add(transition.guard);
      if (transition.timing) add(*transition.timing);
      add(static_cast<std::uint64_t>(transition.weight.kind));
      add(transition.weight.value);
      add(std::uint64_t{transition.branch});
      add(transition.origin);
    }
  }

  std::uint64_t hash_ = base::hash_seed;
};

/// The neighbours that may be one instance.
struct Stretch : PlantStretch {
  std::string name;

  [[nodiscard]] bool has(VariableId id) const { return variables.has(id.index()); }
  [[nodiscard]] bool has(const Formula& formula) const {
    if (formula.kind == Formula::Kind::member && !has(formula.variable)) return false;
    if (formula.kind == Formula::Kind::equality && !(has(formula.variable) && has(formula.other))) return false;
    return std::all_of(formula.operands.begin(), formula.operands.end(), [&](const Formula& f) { return has(f); });
  }
  [[nodiscard]] bool has(const Component& component) const {
    return has(component.mode) &&
           std::all_of(component.modes.begin(), component.modes.end(),
                       [&](const Mode& mode) { return has(mode.constraint); }) &&
           std::all_of(component.transitions.begin(), component.transitions.end(),
                       [&](const Transition& transition) { return has(transition.guard); });
  }
};

/// Up to the first dot.
std::string_view first_name(std::string_view path) { return path.substr(0, path.find('.')); }

/// What a plant has of its own, and the stretches behind it; nothing where they are not one behind the other.
struct Division {
  PlantParts own;
  std::vector<Stretch> stretches;
};

std::optional<Division> division_of(const Plant& plant) {
  Division division;
  PlantParts& own = division.own;
  std::unordered_set<VariableId> modes;
  for (const Component& component : plant.components) modes.insert(component.mode);
  // Modes in a type for components bear the name "": a component of another name is an instance.
  const auto is_own = [&](std::size_t v) {
    const std::string& name = plant.variables.name(VariableId(v));
    return name.empty() || (name.find('.') == std::string::npos && !modes.contains(VariableId(v)));
  };
  while (own.variables < plant.variables.size() && is_own(own.variables)) ++own.variables;
  Stretch itself;
  itself.variables.end = own.variables;
  while (own.components < plant.components.size() && itself.has(plant.components[own.components].mode)) {
    if (!itself.has(plant.components[own.components++])) return std::nullopt;
  }

  std::size_t component = own.components;
  std::unordered_set<std::string_view> names;
  for (std::size_t v = 0; v < own.variables; ++v) names.insert(plant.variables.name(VariableId(v)));
  for (std::size_t v = own.variables; v < plant.variables.size();) {
    const std::string_view name = first_name(plant.variables.name(VariableId(v)));
    if (name.empty() || !names.insert(name).second) return std::nullopt;
    Stretch stretch;
    stretch.name = name;
    stretch.variables.begin = v;
    for (; v < plant.variables.size(); ++v) {
      const std::string& path = plant.variables.name(VariableId(v));
      if (first_name(path) != name) break;
      if (path.size() == name.size() + 1) return std::nullopt;  // `a.` would come back as `a`
    }
    stretch.variables.end = v;
    stretch.components = {component, component};
    while (component < plant.components.size() && stretch.has(plant.components[component].mode)) {
      if (!stretch.has(plant.components[component])) return std::nullopt;
      stretch.components.end = ++component;
    }
    // A component type has none of the rest: what is said of its instance is said by what is around it.
    const bool is_module = stretch.components.begin == component ||
                           std::any_of(plant.components.begin() + static_cast<std::ptrdiff_t>(stretch.components.begin),
                                       plant.components.begin() + static_cast<std::ptrdiff_t>(component),
                                       [&](const Component& inner) { return inner.name != name; });
    const auto take = [&](std::size_t& begin, std::size_t count, const auto& belongs) {
      Range taken{begin, begin};
      while (is_module && taken.end < count && belongs(taken.end)) ++taken.end;
      begin = taken.end;
      return taken;
    };
    stretch.interconnections = take(own.interconnections, plant.interconnections.size(),
                                    [&](std::size_t q) { return stretch.has(plant.interconnections[q].constraint); });
    stretch.controls = take(own.controls, plant.controls.size(),
                            [&](std::size_t c) { return stretch.has(plant.controls[c].variable); });
    stretch.observables = take(own.observables, plant.observables.size(),
                               [&](std::size_t o) { return stretch.has(plant.observables[o]); });
    division.stretches.push_back(std::move(stretch));
  }
  if (component < plant.components.size()) return std::nullopt;
  return division;
}

/// The part that stands in a stretch, as `instantiate` would take it.
Plant cut(const Plant& plant, const Stretch& stretch) {
  const std::size_t prefix = stretch.name.size() + 1;
  const auto local = [&](const std::string& name) { return name.size() < prefix ? "" : name.substr(prefix); };
  Plant part;
  append(part, plant, stretch, local);
  return part;
}

class Outliner {
 public:
  PlantOutline run(const Plant& plant) {
    outline_.whole = parts_of(plant, 0);
    return std::move(outline_);
  }

 private:
  PlantParts parts_of(const Plant& plant, std::size_t depth) {
    PlantParts all;
    all.variables = plant.variables.size();
    all.components = plant.components.size();
    auto division = depth < depth_limit ? division_of(plant) : std::nullopt;
    if (!division) return all;
    for (const Stretch& stretch : division->stretches) {
      division->own.instances.push_back(instance_of(cut(plant, stretch), stretch.name, depth));
    }
    return std::move(division->own);
  }

  PlantInstance instance_of(Plant part, const std::string& name, std::size_t depth) {
    const std::uint64_t hash = Print(part).hash();
    for (const std::size_t type : by_hash_[hash]) {
      const Plant& known = outline_.types[type].plant;
      std::optional<std::vector<double>> initial;
      if (part.components.size() == 1 && known.components.size() == 1 &&
          part.components[0].initial != known.components[0].initial) {
        initial = std::exchange(part.components[0].initial, known.components[0].initial);
      }
      const bool progress = part.components.size() == 1 && known.components.size() == 1 &&
                            part.components[0].progress && !known.components[0].progress;
      if (progress) part.components[0].progress = false;
      if (part == known) return {name, type, std::move(initial), progress};
      if (initial) part.components[0].initial = std::move(*initial);
      if (progress) part.components[0].progress = true;
    }
    PlantParts parts = parts_of(part, depth + 1);
    const bool is_component = part.components.size() == 1 && part.components[0].name.empty();
    const std::string& wanted = is_component ? part.components[0].type : name;
    by_hash_[hash].push_back(outline_.types.size());
    outline_.types.push_back({new_name(wanted), std::move(part), std::move(parts)});
    return {name, outline_.types.size() - 1, std::nullopt, false};
  }

  std::string new_name(const std::string& wanted) {
    const auto [known, fresh] = names_.emplace(wanted, 1);
    std::size_t& times = known->second;
    std::string name = wanted;
    if (fresh) return name;
    do {
      name = wanted + "-" + std::to_string(++times);
    } while (!names_.emplace(name, 1).second);
    return name;
  }

  PlantOutline outline_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> by_hash_;  ///< types
  std::unordered_map<std::string, std::size_t> names_;                   ///< of types, and the last number behind it
};

}  // namespace

PlantOutline outline_of(const Plant& plant) { return Outliner().run(plant); }

}  // namespace rmpl::automata
