// Blocks to nodes, open modules to clusters, wiring to edges.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/plant_diagram.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "compiler/diagram/blocks.hpp"
#include "compiler/diagram/dot.hpp"
#include "compiler/diagram/own_names.hpp"
#include "compiler/diagram/style.hpp"
#include "compiler/diagram/wiring.hpp"

namespace rmpl::compiler {
namespace {

using automata::Formula;
using automata::Plant;
using automata::VariableId;
using style::Align;
using Side = Wiring::Side;

constexpr std::size_t label_width = 44;    // characters of a line of a constraint
constexpr std::size_t between_width = 30;  // likewise, where the constraint stands in a line between two blocks
constexpr std::size_t name_size = 11;      // points
constexpr std::size_t port_size = 10;
constexpr std::size_t rest_size = 9;
constexpr std::size_t half_badge = 8;
constexpr std::size_t badge_letter = 6;  // about as wide as any letter of a badge

class PlantDiagram {
 public:
  PlantDiagram(const Plant& plant, std::string_view inside, std::optional<std::size_t> depth, Badges badges);
  std::string run();

 private:
  [[nodiscard]] std::string text(const Formula& constraint, const Line& line) const;
  [[nodiscard]] std::string end_of(VariableId variable) const;
  [[nodiscard]] std::string with_marks(VariableId variable, std::string_view name) const;
  [[nodiscard]] std::string port_rows(const Block& block) const;
  [[nodiscard]] std::string rest_of(const Block& block) const;
  [[nodiscard]] std::string badge_row(const Block& block) const;
  [[nodiscard]] bool is_constrained(const Line& line) const;
  [[nodiscard]] std::vector<std::string> constraints_of(const Line& line) const;
  void draw_block(std::size_t position);
  void draw_ports_of(const std::string& module);
  void draw_notes_of(const std::string& module);
  void draw_constraints_of(const std::string& module);
  void draw_module(const std::string& path, std::set<std::size_t>& drawn);
  void draw_outside();
  void draw_lines();
  void line_up_the_unconnected();

  const Plant& plant_;
  Blocks blocks_;
  automata::Variables names_;
  Wiring wiring_;
  Badges badges_;
  std::size_t modules_ = 0;  ///< drawn so far
  DotText dot_;
};

PlantDiagram::PlantDiagram(const Plant& plant, std::string_view inside, std::optional<std::size_t> depth, Badges badges)
    : plant_(plant),
      blocks_(plant, inside, depth),
      names_(own_names(plant, inside)),
      wiring_(wiring_of(plant, blocks_)),
      badges_(badges),
      dot_(style::begin(inside.empty() ? std::string_view(plant.name) : inside, "LR")) {}

std::string number(std::size_t position) { return std::to_string(position + 1); }
std::string number(VariableId variable) { return number(variable.index()); }

/// `q1_2_5` of interconnections.
std::string id_of(const std::vector<std::size_t>& interconnections) {
  std::string id;
  for (const std::size_t q : interconnections) id += (id.empty() ? "q" : "_") + number(q);
  return id;
}

/// The name of something in a module, without the module's path.
std::string_view within(std::string_view name, std::string_view module) {
  return module.empty() ? name : name.substr(module.size() + 1);
}

std::string PlantDiagram::run() {
  const bool module = !blocks_.inside().empty();
  style::caption(dot_, module ? blocks_.inside() : plant_.name,
                 std::string(module ? "module" : "plant") + " · ▸ commanded · ◉ observed");
  // What is connected is laid out by itself, one group below the other: Graphviz turns its rows to columns with `LR`.
  const bool dense = 2 * wiring_.lines.size() > 3 * blocks_.all().size();  // lines side by side need room
  dot_.set({{"nodesep", dot_value("0.2")},
            {"ranksep", dot_value(dense ? "0.7" : "0.3")},
            {"pack", dot_value("12")},
            {"packmode", dot_value("array_c1")}});
  dot_.defaults("edge", {{"dir", dot_value("none")}});
  std::set<std::size_t> drawn;
  draw_module(blocks_.inside(), drawn);
  draw_outside();
  draw_lines();
  line_up_the_unconnected();
  return dot_.finish();
}

/// The formula over two variables alone, the ends of the line.
Formula over_ends(Formula formula, const Line& line) {
  const auto end = [&](VariableId variable) { return VariableId(variable == line.from ? 0 : 1); };
  if (formula.kind == Formula::Kind::member || formula.kind == Formula::Kind::equality) {
    formula.variable = end(formula.variable);
  }
  if (formula.kind == Formula::Kind::equality) formula.other = end(formula.other);
  for (Formula& operand : formula.operands) operand = over_ends(std::move(operand), line);
  return formula;
}

/// `open1 <-> open` where it is clear from the ports what has these values; else with the names of the ports, without
/// the blocks' where that tells them apart.
std::string PlantDiagram::text(const Formula& constraint, const Line& line) const {
  const auto is_assignment = [](const Formula& f) { return f.kind == Formula::Kind::member && f.values.size() == 1; };
  const auto& sides = constraint.operands;
  if (constraint.kind == Formula::Kind::equivalence && is_assignment(sides[0]) && is_assignment(sides[1])) {
    const std::string first = names_.value({sides[0].variable, sides[0].values[0]});
    const std::string second = names_.value({sides[1].variable, sides[1].values[0]});
    return sides[0].variable == line.from ? first + " <-> " + second : second + " <-> " + first;
  }
  automata::Variables ends;
  for (const VariableId variable : {line.from, line.to}) {
    automata::Variable end = plant_.variables[variable];
    const auto block = blocks_.block_of(variable);
    if (!block || !is_of(end.name, blocks_.all()[*block].path)) return to_text(constraint, names_);
    end.name = within(end.name, blocks_.all()[*block].path);
    if (ends.find(end.name)) return to_text(constraint, names_);
    ends.add(std::move(end));
  }
  return to_text(over_ends(constraint, line), ends);
}

std::string PlantDiagram::with_marks(VariableId variable, std::string_view name) const {
  std::string markup = escaped(name);
  if (wiring_.commanded[variable.index()]) markup = style::in_font("▸ " + markup, style::command, port_size);
  if (wiring_.observed[variable.index()]) markup += style::in_font(" ◉", style::sensor, port_size);
  return style::in_font(markup, style::ink, port_size);
}

std::string PlantDiagram::port_rows(const Block& block) const {
  std::vector<std::string> left;
  std::vector<std::string> right;
  const auto add = [&](VariableId variable, std::string_view name) {
    const auto port = wiring_.ports.find(variable);
    if (port == wiring_.ports.end()) return;
    const bool at_left = port->second == Side::left;
    (at_left ? left : right)
        .push_back("<TD PORT=\"p" + number(variable) + "\" ALIGN=\"" + (at_left ? "LEFT" : "RIGHT") + "\">" +
                   with_marks(variable, name) + "</TD>");
  };
  if (block.component != nullptr) add(block.component->mode, "mode");
  for (const VariableId variable : block.variables) add(variable, within(plant_.variables.name(variable), block.path));
  std::string rows;
  for (std::size_t row = 0; row < std::max(left.size(), right.size()); ++row) {
    rows += "<TR>" + (row < left.size() ? left[row] : "<TD></TD>") + (row < right.size() ? right[row] : "<TD></TD>") +
            "</TR>";
  }
  return rows;
}

/// What is counted of a block and not drawn; empty where there is nothing.
std::string PlantDiagram::rest_of(const Block& block) const {
  const auto count = [&](const auto& has, const char* what) {
    const auto found = std::count_if(block.variables.begin(), block.variables.end(), has);
    return found == 0 ? std::string() : std::to_string(found) + " " + what;
  };
  if (block.component != nullptr) return count([&](VariableId v) { return !wiring_.ports.contains(v); }, "more");
  const std::string commands = count([&](VariableId v) { return wiring_.commanded[v.index()]; }, "commanded");
  const std::string readings = count([&](VariableId v) { return wiring_.observed[v.index()]; }, "observed");
  return commands + (commands.empty() || readings.empty() ? "" : ", ") + readings;
}

/// Room for the upper half of a badge on the lower edge, as wide as the longest name of a mode.
std::string PlantDiagram::badge_row(const Block& block) const {
  if (badges_ == Badges::none) return {};
  std::size_t letters = 0;
  if (block.component != nullptr) {
    for (const automata::Mode& mode : block.component->modes) letters = std::max(letters, mode.name.size());
  }
  return R"(<TR><TD COLSPAN="2" HEIGHT=")" + std::to_string(half_badge) + R"(" WIDTH=")" +
         std::to_string((letters + 2) * badge_letter) + R"("></TD></TR>)";
}

void PlantDiagram::draw_block(std::size_t position) {
  const Block& block = blocks_.all()[position];
  const bool folded = block.component == nullptr;
  const std::string type = folded ? std::to_string(block.components) + " components" : block.component->type;
  const std::string below = type.empty() ? "" : "<BR/>" + style::in_font(escaped(type), style::faint, port_size);
  std::string rows =
      R"(<TR><TD COLSPAN="2">&#160;)" +
      style::in_font("<B>" + escaped(within(block.path, parent_of(block.path))) + "</B>", style::ink, name_size) +
      "&#160;" + below + "</TD></TR>" + port_rows(block);
  if (const std::string rest = rest_of(block); !rest.empty()) {
    rows += R"(<TR><TD COLSPAN="2">)" + style::in_font(rest, style::faint, rest_size) + "</TD></TR>";
  }
  rows += badge_row(block);
  const std::string table = std::string("<TABLE BORDER=\"") + (folded ? "2" : "1") +
                            R"(" CELLBORDER="0" CELLSPACING="0" CELLPADDING="3" STYLE="ROUNDED" COLOR=")" +
                            std::string(style::line) + "\" BGCOLOR=\"" +
                            std::string(folded ? style::shade : style::paper) + "\">" + rows + "</TABLE>";
  dot_.node("b" + number(position),
            {{"shape", dot_value("plain")}, {"label", dot_label(table)}, {"tooltip", dot_tooltip(block.path)}});
}

void PlantDiagram::draw_ports_of(const std::string& module) {
  for (const auto& [variable, side] : wiring_.ports) {
    if (!blocks_.is_inside(variable) || blocks_.block_of(variable)) continue;
    if (blocks_.module_of({variable}) != module) continue;
    dot_.node("v" + number(variable),
              {{"shape", dot_value("box")},
               {"style", dot_value("rounded,filled")},
               {"fillcolor", dot_value(style::paper)},
               {"margin", dot_value("0.06,0.02")},
               {"height", dot_value("0.2")},
               {"width", dot_value("0.2")},
               {"label", dot_label(with_marks(variable, within(plant_.variables.name(variable), module)))}});
  }
}

void PlantDiagram::draw_notes_of(const std::string& module) {
  for (const Note& note : wiring_.notes) {
    std::vector<VariableId> ends = note.flow.from;
    ends.insert(ends.end(), note.flow.to.begin(), note.flow.to.end());
    if (blocks_.module_of(ends) != module) continue;
    std::string rows;
    for (const std::size_t q : note.interconnections) {
      const auto text = style::wrapped(to_text(plant_.interconnections[q].constraint, names_), label_width);
      rows += std::string(rows.empty() ? "" : "<HR/>") + R"(<TR><TD BALIGN="LEFT" ALIGN="LEFT">)" +
              style::lines(text, Align::left) + "</TD></TR>";
    }
    const std::string table =
        R"(<TABLE BORDER="0" CELLBORDER="0" CELLSPACING="0" CELLPADDING="2">)" + rows + "</TABLE>";
    dot_.node(id_of(note.interconnections), {{"shape", dot_value("box")},
                                             {"style", dot_value("dotted,filled")},
                                             {"fillcolor", dot_value(style::paper)},
                                             {"margin", dot_value("0.06,0.04")},
                                             {"height", dot_value("0.2")},
                                             {"fontsize", dot_value(std::to_string(port_size))},
                                             {"label", dot_label(table)}});
  }
}

/// Whether a line says more than that its ends are equal.
bool PlantDiagram::is_constrained(const Line& line) const {
  return !std::all_of(line.interconnections.begin(), line.interconnections.end(), [&](std::size_t q) {
    return plant_.interconnections[q].constraint.kind == Formula::Kind::equality;
  });
}

/// What it says beside that.
std::vector<std::string> PlantDiagram::constraints_of(const Line& line) const {
  std::vector<std::string> texts;
  for (const std::size_t q : line.interconnections) {
    const Formula& constraint = plant_.interconnections[q].constraint;
    if (constraint.kind == Formula::Kind::equality) continue;
    for (std::string& part : style::wrapped(text(constraint, line), between_width)) texts.push_back(std::move(part));
  }
  return texts;
}

/// The constraints of lines stand in them, as nodes: labels beside them would lie under other lines.
void PlantDiagram::draw_constraints_of(const std::string& module) {
  for (const Line& line : wiring_.lines) {
    if (!is_constrained(line) || blocks_.module_of({line.from, line.to}) != module) continue;
    dot_.node(id_of(line.interconnections),
              {{"shape", dot_value("plain")},
               {"fontsize", dot_value(std::to_string(port_size))},
               {"label", dot_label(style::beside_arrow(style::lines(constraints_of(line), Align::left)))}});
  }
}

/// What is inside of a module: its ports, its blocks, and the modules in it that are open, each in a box.
void PlantDiagram::draw_module(const std::string& path, std::set<std::size_t>& drawn) {
  draw_ports_of(path);
  draw_notes_of(path);
  draw_constraints_of(path);
  for (std::size_t b = 0; b < blocks_.all().size(); ++b) {
    const std::string& block = blocks_.all()[b].path;
    if (drawn.contains(b) || !is_of(block, path)) continue;
    const std::size_t end = block.find('.', path.empty() ? 0 : path.size() + 1);
    if (end == std::string::npos) {
      drawn.insert(b);
      draw_block(b);
      continue;
    }
    const std::string module = block.substr(0, end);
    const std::string name = "<B>" + escaped(within(module, path)) + "</B>";
    dot_.open_cluster("m" + number(modules_++), {{"style", dot_value("rounded,filled")},
                                                 {"fillcolor", dot_value(style::shade)},
                                                 {"color", dot_value(style::line)},
                                                 {"labeljust", dot_value("l")},
                                                 {"label", dot_label(style::in_font(name, style::ink, name_size))}});
    draw_module(module, drawn);
    dot_.close_cluster();
  }
}

void PlantDiagram::draw_outside() {
  for (const auto& [variable, side] : wiring_.ports) {
    if (blocks_.is_inside(variable)) continue;
    const std::string name = escaped(plant_.variables.name(variable));
    dot_.node("x" + number(variable), {{"shape", dot_value("plaintext")},
                                       {"height", dot_value("0.2")},
                                       {"margin", dot_value("0.04,0.02")},
                                       {"label", dot_label(style::in_font(name, style::faint, port_size))}});
  }
}

std::string PlantDiagram::end_of(VariableId variable) const {
  if (!blocks_.is_inside(variable)) return "x" + number(variable);
  const auto block = blocks_.block_of(variable);
  if (!block) return "v" + number(variable);
  return "b" + number(*block) + ":p" + number(variable) + (wiring_.ports.at(variable) == Side::left ? ":w" : ":e");
}

void PlantDiagram::draw_lines() {
  for (const Line& line : wiring_.lines) {
    const std::string id = id_of(line.interconnections);
    if (is_constrained(line)) {
      dot_.edge(end_of(line.from), id + ":w", {});
      dot_.edge(id + ":e", end_of(line.to), {});
    } else {
      dot_.edge(end_of(line.from), end_of(line.to), {{"id", dot_value(id)}});
    }
  }
  for (const Note& note : wiring_.notes) {
    const std::string node = id_of(note.interconnections);
    for (const VariableId variable : note.flow.from) dot_.edge(end_of(variable), node, {});
    for (const VariableId variable : note.flow.to) dot_.edge(node, end_of(variable), {});
  }
}

/// Blocks that nothing connects would stand in one long column: edges that are not seen put them into rows.
void PlantDiagram::line_up_the_unconnected() {
  std::set<std::size_t> connected;
  const auto connect = [&](VariableId variable) {
    if (const auto block = blocks_.block_of(variable)) connected.insert(*block);
  };
  for (const Line& line : wiring_.lines) {
    connect(line.from);
    connect(line.to);
  }
  for (const Note& note : wiring_.notes) {
    std::for_each(note.flow.from.begin(), note.flow.from.end(), connect);
    std::for_each(note.flow.to.begin(), note.flow.to.end(), connect);
  }
  std::vector<std::size_t> alone;
  for (std::size_t b = 0; b < blocks_.all().size(); ++b) {
    if (!connected.contains(b) && parent_of(blocks_.all()[b].path) == blocks_.inside()) alone.push_back(b);
  }
  std::size_t row = 1;
  while (row * row < alone.size()) ++row;
  for (std::size_t i = 1; i < alone.size(); ++i) {
    DotAttributes attributes{{"style", dot_value("invis")}};
    if (i % row == 0) attributes.push_back({"constraint", dot_value("false")});
    dot_.edge("b" + number(alone[i % row == 0 ? i - row : i - 1]), "b" + number(alone[i]), attributes);
  }
}

}  // namespace

std::string plant_diagram(const Plant& plant, std::string_view inside, std::optional<std::size_t> depth,
                          Badges badges) {
  return PlantDiagram(plant, inside, depth, badges).run();
}

}  // namespace rmpl::compiler
