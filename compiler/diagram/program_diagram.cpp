// Locations to nodes and clusters, arcs to edges; hierarchy is nesting.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/program_diagram.hpp"

#include <algorithm>
#include <vector>

#include "compiler/diagram/dot.hpp"
#include "compiler/diagram/style.hpp"

namespace rmpl::compiler {
namespace {

using automata::Arc;
using automata::Condition;
using automata::Location;
using automata::LocationId;
using automata::Program;
using style::Align;

constexpr std::size_t line_width = 28;  // characters of a line on an arrow
constexpr std::size_t box_width = 60;   // and in the top of a box
constexpr std::size_t goal_width = 14;  // and in a circle

class ProgramDiagram {
 public:
  ProgramDiagram(const Program& program, std::optional<std::size_t> depth, const Look& look);
  std::string run();

 private:
  using Children = std::vector<LocationId>;

  void find_shown(std::optional<std::size_t> depth);
  void find_lowest();
  [[nodiscard]] const Location& at(LocationId id) const { return program_.locations[id.index()]; }
  [[nodiscard]] bool is_open(LocationId id) const { return open_[id.index()]; }
  [[nodiscard]] bool is_shown(LocationId id) const { return shown_[id.index()] == id; }
  [[nodiscard]] bool is_within(LocationId inner, LocationId outer) const;
  /// The node of a location that an arrow can begin at: of a composite one that is low in its box.
  [[nodiscard]] std::string tail(LocationId id) const;
  [[nodiscard]] std::string head(LocationId id) const { return (is_open(id) ? "s" : "l") + number(id); }
  [[nodiscard]] static std::string number(LocationId id) { return std::to_string(id.index() + 1); }
  [[nodiscard]] std::string condition(const Condition& condition, std::size_t width, Align align) const;
  [[nodiscard]] std::string place(const Location& location) const;

  void draw(LocationId id);
  void draw_primitive(LocationId id);
  void draw_folded(LocationId id);
  void draw_composite(LocationId id);
  void draw_start(LocationId id);
  void draw_arc(LocationId from, std::size_t position);
  void draw_choice(LocationId id, const std::vector<DrawnFunction>& functions);
  void draw_functions(LocationId id, const std::vector<DrawnFunction>& functions);
  void draw_from_dot(const std::string& dot, LocationId choice, LocationId to, const std::string& guard, bool counts);
  /// Whether a box points to it: a choice that is drawn before time 0 is one, too.
  [[nodiscard]] bool is_start(LocationId id) const {
    const auto choice = look_.choices.find(id);
    return at(id).start || (choice != look_.choices.end() && choice->second.front().before_start);
  }
  [[nodiscard]] bool is_hidden(LocationId id) const { return !look_.hidden.empty() && look_.hidden[id.index()]; }
  [[nodiscard]] std::string guard(const std::vector<Condition>& conditions) const;
  [[nodiscard]] std::string box_top(LocationId id) const;

  const Program& program_;
  const Look& look_;
  std::vector<LocationId> shown_;
  std::vector<bool> open_;  ///< a box that is drawn with what is inside
  std::vector<Children> children_;
  std::vector<std::size_t> height_;  ///< of what a location holds, in steps
  std::vector<LocationId> lowest_;   ///< the primitive location at the bottom of a box; of others themselves
  DotText dot_;
};

ProgramDiagram::ProgramDiagram(const Program& program, std::optional<std::size_t> depth, const Look& look)
    : program_(program),
      look_(look),
      children_(program.locations.size()),
      height_(program.locations.size(), 1),
      dot_(style::begin(program.name, "TB")) {
  find_shown(depth);
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    const auto parent = program.locations[l].parent;
    if (parent && is_shown(LocationId(l)) && !is_hidden(LocationId(l))) children_[parent->index()].emplace_back(l);
  }
  find_lowest();
}

/// What each location is drawn as: itself, or the folded box that it is in.
void ProgramDiagram::find_shown(std::optional<std::size_t> depth) {
  std::vector<std::size_t> level(program_.locations.size(), 0);
  for (std::size_t l = 0; l < program_.locations.size(); ++l) {
    const auto parent = program_.locations[l].parent;
    if (parent) level[l] = level[parent->index()] + 1;
    shown_.push_back(parent && !open_[parent->index()] ? shown_[parent->index()] : LocationId(l));
    open_.push_back(program_.locations[l].composite && (!depth || level[l] < *depth));
  }
}

void ProgramDiagram::find_lowest() {
  const std::size_t count = program_.locations.size();
  for (std::size_t l = 0; l < count; ++l) lowest_.emplace_back(l);
  // A child comes after its parent: from the last to the first, what is inside is known before what holds it.
  std::vector<std::size_t> depth(count, 0);
  for (std::size_t l = count; l-- > 0;) {
    std::size_t deepest = 0;
    for (const LocationId child : children_[l]) depth[child.index()] = height_[child.index()];
    for (const LocationId child : children_[l]) {
      for (const Arc& arc : at(child).arcs) {
        if (!is_shown(arc.target) || arc.target <= child || at(arc.target).parent != at(child).parent) continue;
        std::size_t& reached = depth[arc.target.index()];
        reached = std::max(reached, depth[child.index()] + height_[arc.target.index()]);
      }
      if (depth[child.index()] <= deepest) continue;
      deepest = depth[child.index()];
      lowest_[l] = lowest_[child.index()];
    }
    height_[l] += deepest;
  }
}

std::string ProgramDiagram::run() {
  dot_.set({{"nodesep", dot_value("0.35")}, {"ranksep", dot_value("0.32")}});
  for (std::size_t l = 0; l < program_.locations.size(); ++l) {
    if (!program_.locations[l].parent) draw(LocationId(l));
  }
  for (std::size_t l = 0; l < program_.locations.size(); ++l) {
    if (const auto choice = look_.choices.find(LocationId(l)); choice != look_.choices.end()) {
      draw_functions(LocationId(l), choice->second);
      continue;
    }
    for (std::size_t a = 0; a < program_.locations[l].arcs.size(); ++a) draw_arc(LocationId(l), a);
  }
  return dot_.finish();
}

bool ProgramDiagram::is_within(LocationId inner, LocationId outer) const {
  while (inner > outer && at(inner).parent) inner = *at(inner).parent;
  return inner == outer;
}

std::string ProgramDiagram::tail(LocationId id) const {
  const LocationId low = lowest_[id.index()];
  return (is_open(low) ? "s" : "l") + number(low);
}

std::string ProgramDiagram::condition(const Condition& condition, std::size_t width, Align align) const {
  const std::string text = to_text(condition.constraint, program_.variables, program_.clocks);
  return style::lines(style::wrapped(text, width), align, condition.entailed ? "" : "O");
}

std::string ProgramDiagram::place(const Location& location) const {
  return location.label + style::place_in_parentheses(location.origin);
}

void ProgramDiagram::draw(LocationId id) {
  if (is_open(id)) return draw_composite(id);
  if (at(id).composite) return draw_folded(id);
  if (const auto choice = look_.choices.find(id); choice != look_.choices.end()) return draw_choice(id, choice->second);
  draw_primitive(id);
}

void ProgramDiagram::draw_primitive(LocationId id) {
  const Location& location = at(id);
  std::string label = "<B>" + number(id) + "</B>";
  for (const automata::Assignment& goal : location.goal) {
    const auto name = style::broken_name(program_.variables.name(goal.variable) + " =", goal_width);
    const auto value = style::broken_name(program_.variables.value(goal), goal_width);
    label += "<BR/>" + style::lines(name, Align::center) + "<BR/>" + style::lines(value, Align::center);
  }
  for (const automata::Formula& constraint : location.goal_constraints) {
    const std::string text = automata::to_text(constraint, program_.variables);
    label += "<BR/>" + style::lines(style::wrapped(text, line_width), Align::center);
  }
  const bool tells = !look_.told.empty() && !look_.told[id.index()].empty();
  if (tells) label += "<BR/>" + style::lines(style::wrapped(look_.told[id.index()], line_width), Align::center);
  if (location.clock_start) label += "<BR/>" + escaped(program_.clocks[location.clock_start->index()]) + " = 0";
  if (!location.maintenance.is_trivial()) {
    label += "<BR/>MAINTAIN<BR/>" + condition(location.maintenance, line_width, Align::center);
  }
  const std::string_view fill = location.has_goal() || tells ? style::goal
                                : location.clock_start       ? style::clock
                                                             : style::paper;
  dot_.node("l" + number(id), {{"shape", dot_value(tells ? "ellipse" : "circle")},
                               {"style", dot_value("filled")},
                               {"fillcolor", dot_value(fill)},
                               {"margin", dot_value("0.01")},
                               {"width", dot_value("0.3")},
                               {"label", dot_label(label)},
                               {"tooltip", dot_tooltip(place(location))}});
}

std::string ProgramDiagram::box_top(LocationId id) const {
  const Location& location = at(id);
  std::string rows = "<TR><TD ALIGN=\"LEFT\"><B>" + number(id) + "</B></TD><TD ALIGN=\"LEFT\" BALIGN=\"LEFT\">";
  if (location.maintenance.is_trivial()) {
    rows += style::lines(style::wrapped(location.label, box_width), Align::left);
  } else {
    rows +=
        "MAINTAIN</TD><TD ALIGN=\"LEFT\" BALIGN=\"LEFT\">" + condition(location.maintenance, box_width, Align::left);
  }
  rows += "</TD></TR>";
  std::string clocks;
  for (const automata::ClockId clock : location.own_clocks) {
    clocks += (clocks.empty() ? "clock " : ", ") + program_.clocks[clock.index()];
  }
  if (!clocks.empty()) {
    rows += "<TR><TD></TD><TD ALIGN=\"LEFT\">" + escaped(clocks) + "</TD></TR>";
  }
  return R"(<TABLE BORDER="0" CELLBORDER="0" CELLSPACING="0" CELLPADDING="2">)" + rows + "</TABLE>";
}

void ProgramDiagram::draw_folded(LocationId id) {
  dot_.node("l" + number(id), {{"shape", dot_value("box")},
                               {"style", dot_value("rounded,filled,bold")},
                               {"fillcolor", dot_value(style::shade)},
                               {"label", dot_label(box_top(id))},
                               {"tooltip", dot_tooltip(place(at(id)))}});
}

void ProgramDiagram::draw_composite(LocationId id) {
  dot_.open_cluster("l" + number(id), {{"style", dot_value("rounded,filled")},
                                       {"fillcolor", dot_value(style::paper)},
                                       {"color", dot_value(style::line)},
                                       {"labeljust", dot_value("l")},
                                       {"label", dot_label(box_top(id))},
                                       {"tooltip", dot_tooltip(place(at(id)))}});
  draw_start(id);
  for (const LocationId child : children_[id.index()]) draw(child);
  dot_.close_cluster();
}

/// The dot of a box, and its arrows; where nothing in the box starts it is not seen, and arrows to the box aim at it.
void ProgramDiagram::draw_start(LocationId id) {
  const Children& inside = children_[id.index()];
  const bool starts = std::any_of(inside.begin(), inside.end(), [&](LocationId child) { return is_start(child); });
  DotAttributes attributes{{"shape", dot_value("point")}, {"width", dot_value("0.08")}};
  if (!starts) attributes.push_back({"style", dot_value("invis")});
  dot_.node("s" + number(id), attributes);
  for (const LocationId child : inside) {
    if (!is_start(child)) continue;
    DotAttributes edge{{"id", dot_value("start_" + number(child))}};
    if (is_open(child)) edge.push_back({"lhead", dot_value("cluster_l" + number(child))});
    dot_.edge("s" + number(id), head(child), edge);
  }
}

void ProgramDiagram::draw_arc(LocationId from, std::size_t position) {
  const Arc& arc = at(from).arcs[position];
  const LocationId shown_from = shown_[from.index()];
  const LocationId to = shown_[arc.target.index()];
  if (shown_from == to && !(is_shown(from) && is_shown(arc.target))) return;  // inside a folded box
  DotAttributes attributes{{"id", dot_value("arc_" + number(from) + "_" + std::to_string(position + 1))}};
  std::string label;
  if (!arc.guard.is_trivial()) label = condition(arc.guard, line_width, Align::left);
  // Graphviz draws no arrow between a box and what is inside it: one to an outer box ends at that box's dot, which is
  // where the box starts again, and one from a box into itself begins inside, and says where it comes from.
  const bool inward = is_open(shown_from) && is_within(to, shown_from);
  const bool outward = is_within(shown_from, to);
  if (inward) label = "<B>" + number(from) + "</B>: " + label;
  if (!label.empty()) attributes.push_back({"label", dot_label(style::beside_arrow(label))});
  if (is_open(shown_from) && !inward) attributes.push_back({"ltail", dot_value("cluster_l" + number(shown_from))});
  if (is_open(to) && !outward) attributes.push_back({"lhead", dot_value("cluster_l" + number(to))});
  if (to < shown_from) attributes.push_back({"constraint", dot_value("false")});
  dot_.edge(tail(shown_from), head(to), attributes);
}

/// A diamond, and a dot for each function: in the box of the choice.
void ProgramDiagram::draw_choice(LocationId id, const std::vector<DrawnFunction>& functions) {
  dot_.node("l" + number(id), {{"shape", dot_value("diamond")},
                               {"style", dot_value("filled")},
                               {"fillcolor", dot_value(style::clock)},
                               {"margin", dot_value("0.01")},
                               {"label", dot_label("<B>" + number(id) + "</B>")},
                               {"tooltip", dot_tooltip(place(at(id)))}});
  for (std::size_t f = 0; f < functions.size(); ++f) {
    dot_.node("f" + number(id) + "_" + std::to_string(f + 1),
              {{"shape", dot_value("point")}, {"width", dot_value("0.06")}});
  }
}

std::string ProgramDiagram::guard(const std::vector<Condition>& conditions) const {
  std::string text;
  for (const Condition& one : conditions)
    text += (text.empty() ? "" : "<BR/>") + condition(one, line_width, Align::left);
  return text;
}

void ProgramDiagram::draw_functions(LocationId id, const std::vector<DrawnFunction>& functions) {
  if (!is_shown(id)) return;
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const std::string dot = "f" + number(id) + "_" + std::to_string(f + 1);
    dot_.edge("l" + number(id), dot,
              {{"id", dot_value("function_" + number(id) + "_" + std::to_string(f + 1))},
               {"arrowhead", dot_value("none")},
               {"label", dot_label(style::beside_arrow(escaped(functions[f].probability)))}});
    for (const automata::GuardedArc& arc : functions[f].arcs)
      draw_from_dot(dot, id, arc.target, guard(arc.guard), false);
    for (const LocationId begun : functions[f].beginning) draw_from_dot(dot, id, begun, "", !functions[f].before_start);
  }
}

/// `counts`: the target is not entered, but counts as started while the choice is drawn.
void ProgramDiagram::draw_from_dot(const std::string& dot, LocationId choice, LocationId to, const std::string& guard,
                                   bool counts) {
  const LocationId shown = shown_[to.index()];
  DotAttributes attributes;
  if (!guard.empty()) attributes.push_back({"label", dot_label(style::beside_arrow(guard))});
  if (counts) attributes.push_back({"style", dot_value("dashed")});
  if (is_open(shown) && !is_within(choice, shown))
    attributes.push_back({"lhead", dot_value("cluster_l" + number(shown))});
  if (shown < choice) attributes.push_back({"constraint", dot_value("false")});
  dot_.edge(dot, head(shown), attributes);
}

}  // namespace

std::string program_diagram(const Program& program, std::optional<std::size_t> depth, const Look& look) {
  return ProgramDiagram(program, depth, look).run();
}

}  // namespace rmpl::compiler
