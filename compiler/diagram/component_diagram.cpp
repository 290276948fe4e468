// Modes to nodes, transitions to edges; what `any` wrote many times is folded again.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/component_diagram.hpp"

#include <algorithm>
#include <vector>

#include "compiler/diagram/dot.hpp"
#include "compiler/diagram/numbers.hpp"
#include "compiler/diagram/own_names.hpp"
#include "compiler/diagram/style.hpp"

namespace rmpl::compiler {
namespace {

using automata::Component;
using automata::Formula;
using automata::Mode;
using automata::ModeId;
using automata::Plant;
using automata::Transition;
using style::Align;

constexpr std::size_t constraint_width = 36;  // characters of a line in a mode
constexpr std::size_t guard_width = 30;       // and on an arrow

/// Transitions that are drawn as one arrow.
struct Bundle {
  enum class From { mode, any, any_nominal };
  From from = From::mode;
  std::vector<std::size_t> transitions;  ///< positions, rising
};

/// Whether two transitions between modes differ in where they begin only.
bool alike(const Transition& a, const Transition& b) {
  return a.from != a.to && b.from != b.to && a.to == b.to && a.guard == b.guard && a.timing == b.timing &&
         a.weight == b.weight;
}

class ComponentDiagram {
 public:
  ComponentDiagram(const Plant& plant, const Component& component, std::string_view name)
      : component_(component), variables_(own_names(plant, component.name)), dot_(style::begin(name, "TB")) {}
  std::string run(std::string_view name, std::string_view kind);

 private:
  [[nodiscard]] std::vector<Bundle> bundles() const;
  [[nodiscard]] Bundle::From sources(const std::vector<std::size_t>& transitions) const;
  [[nodiscard]] std::string label(const Mode& mode) const;
  [[nodiscard]] std::string label(const Transition& transition) const;
  void draw_mode(std::size_t position);
  void draw_initial();
  void draw(const Bundle& bundle);

  const Component& component_;
  automata::Variables variables_;
  DotText dot_;
};

std::string ComponentDiagram::run(std::string_view name, std::string_view kind) {
  style::caption(dot_, name, kind);
  dot_.set({{"nodesep", dot_value("0.4")}, {"ranksep", dot_value("0.4")}});
  draw_initial();
  for (std::size_t m = 0; m < component_.modes.size(); ++m) draw_mode(m);
  for (const Bundle& bundle : bundles()) draw(bundle);
  return dot_.finish();
}

void ComponentDiagram::draw_initial() {
  dot_.node("initial", {{"shape", dot_value("point")}, {"width", dot_value("0.08")}});
  for (std::size_t m = 0; m < component_.initial.size(); ++m) {
    const double probability = component_.initial[m];
    if (probability <= 0) continue;
    DotAttributes attributes{{"id", dot_value("initial_" + std::to_string(m + 1))}};
    if (probability < 1) attributes.push_back({"label", dot_label(style::beside_arrow(shortest(probability)))});
    dot_.edge("initial", "m" + std::to_string(m + 1), attributes);
  }
}

std::string ComponentDiagram::label(const Mode& mode) const {
  const std::string_view color = mode.fault ? style::fault : style::ink;
  std::string rows = "<TR><TD>" + style::in_font("<B>" + escaped(mode.name) + "</B>", color, 11) + "</TD></TR>";
  if (!mode.constraint.is_true()) {
    const std::string text = to_text(mode.constraint, variables_);
    rows += R"(<HR/><TR><TD ALIGN="LEFT" BALIGN="LEFT">)" +
            style::lines(style::wrapped(text, constraint_width), Align::left) + "</TD></TR>";
  }
  if (mode.reward != 0) {
    rows +=
        R"(<TR><TD ALIGN="RIGHT">)" + style::in_font("reward " + shortest(mode.reward), style::faint, 9) + "</TD></TR>";
  }
  return R"(<TABLE BORDER="0" CELLBORDER="0" CELLSPACING="0" CELLPADDING="3">)" + rows + "</TABLE>";
}

void ComponentDiagram::draw_mode(std::size_t position) {
  const Mode& mode = component_.modes[position];
  dot_.node("m" + std::to_string(position + 1),
            {{"shape", dot_value("box")},
             {"style", dot_value(mode.fault ? "rounded,filled,dashed" : "rounded,filled")},
             {"color", dot_value(mode.fault ? style::fault : style::line)},
             {"fillcolor", dot_value(mode.fault ? style::fault_shade : style::paper)},
             {"margin", dot_value("0.06,0.03")},
             {"label", dot_label(label(mode))},
             {"tooltip", dot_tooltip(mode.name + style::place_in_parentheses(mode.origin))}});
}

/// Whether the sources are all modes but the target, or all nominal ones but the target, each once.
Bundle::From ComponentDiagram::sources(const std::vector<std::size_t>& transitions) const {
  const auto& all = component_.transitions;
  const ModeId to = all[transitions.front()].to;
  std::vector<std::size_t> times(component_.modes.size(), 0);
  for (const std::size_t t : transitions) ++times[all[t].from.index()];
  bool any = transitions.size() > 1;
  bool nominal = any;
  for (std::size_t m = 0; m < times.size(); ++m) {
    const bool target = ModeId(m) == to;
    any = any && times[m] == (target ? 0U : 1U);
    nominal = nominal && times[m] == (target || component_.modes[m].fault ? 0U : 1U);
  }
  return any ? Bundle::From::any : nominal ? Bundle::From::any_nominal : Bundle::From::mode;
}

std::vector<Bundle> ComponentDiagram::bundles() const {
  const auto& all = component_.transitions;
  std::vector<bool> taken(all.size(), false);
  std::vector<Bundle> result;
  for (std::size_t t = 0; t < all.size(); ++t) {
    if (taken[t]) continue;
    Bundle bundle;
    bundle.transitions.push_back(t);
    for (std::size_t other = t + 1; other < all.size(); ++other) {
      if (!taken[other] && alike(all[t], all[other])) bundle.transitions.push_back(other);
    }
    bundle.from = sources(bundle.transitions);
    if (bundle.from == Bundle::From::mode) bundle.transitions.resize(1);
    for (const std::size_t member : bundle.transitions) taken[member] = true;
    result.push_back(std::move(bundle));
  }
  return result;
}

std::string ComponentDiagram::label(const Transition& transition) const {
  std::vector<std::string> texts;
  if (!transition.guard.is_true()) texts = style::wrapped(to_text(transition.guard, variables_), guard_width);
  if (transition.restart) texts.insert(texts.begin(), "restart");
  if (transition.timing) texts.push_back(to_text(*transition.timing));
  if (transition.weight.kind != automata::Weight::Kind::none) texts.push_back(to_text(transition.weight));
  return style::lines(texts, Align::left);
}

void ComponentDiagram::draw(const Bundle& bundle) {
  const Transition& transition = component_.transitions[bundle.transitions.front()];
  std::string id = "t";
  for (const std::size_t t : bundle.transitions) id += (id.size() > 1 ? "_" : "") + std::to_string(t + 1);
  std::string from = "m" + std::to_string(transition.from.index() + 1);
  if (bundle.from != Bundle::From::mode) {
    from = "any_" + std::to_string(bundle.transitions.front() + 1);
    dot_.node(from,
              {{"shape", dot_value("plaintext")},
               {"margin", dot_value("0.03,0.02")},
               {"height", dot_value("0.2")},
               {"fontcolor", dot_value(style::faint)},
               {"label", dot_label(bundle.from == Bundle::From::any ? "<I>any mode</I>" : "<I>any nominal mode</I>")}});
  }
  DotAttributes attributes{{"id", dot_value(id)}};
  if (const std::string text = label(transition); !text.empty()) {
    attributes.push_back({"label", dot_label(style::beside_arrow(text))});
  }
  if (component_.is_fault(transition)) {
    attributes.push_back({"style", dot_value("dashed")});
    attributes.push_back({"color", dot_value(style::fault)});
    attributes.push_back({"fontcolor", dot_value(style::fault)});
  }
  dot_.edge(from, "m" + std::to_string(transition.to.index() + 1), attributes);
}

}  // namespace

std::string component_diagram(const Plant& plant, const Component& component, std::string_view name,
                              std::string_view kind) {
  return ComponentDiagram(plant, component, name).run(name, kind);
}

}  // namespace rmpl::compiler
