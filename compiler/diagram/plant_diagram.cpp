// Blocks to nodes, open modules to clusters, interconnections to lines and notes.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/plant_diagram.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "compiler/diagram/blocks.hpp"
#include "compiler/diagram/dot.hpp"
#include "compiler/diagram/flow.hpp"
#include "compiler/diagram/own_names.hpp"
#include "compiler/diagram/style.hpp"

namespace rmpl::compiler {
namespace {

using automata::Formula;
using automata::Plant;
using automata::VariableId;
using style::Align;

constexpr std::size_t constraint_width = 44;  // characters of a line of a constraint

/// A line between two ports, for all interconnections of just these two.
struct Line {
  std::vector<std::size_t> interconnections;
  std::vector<std::string> texts;  ///< of those that are no equality
};

class PlantDiagram {
 public:
  PlantDiagram(const Plant& plant, std::string_view inside, std::optional<std::size_t> depth);
  std::string run(std::string_view inside);

 private:
  enum class Side { left, right };

  void sort_interconnections();
  void find_marks();
  void use(VariableId variable, Side side);
  [[nodiscard]] bool is_hidden(const Formula& constraint) const;
  [[nodiscard]] std::string text(const Formula& constraint) const;
  [[nodiscard]] std::string end_of(VariableId variable, Side side) const;
  [[nodiscard]] std::string with_marks(VariableId variable, const std::string& name) const;
  [[nodiscard]] std::string port_name(VariableId variable, const Block& block) const;
  [[nodiscard]] std::string port_rows(std::size_t block) const;
  [[nodiscard]] std::string rest_of(std::size_t block) const;
  [[nodiscard]] std::string port_cell(VariableId variable, const Block& block, Side side) const;
  void draw_block(std::size_t block);
  void draw_module(const std::string& path, std::set<std::size_t>& drawn);
  void draw_ports_of(const std::string& module);
  void draw_outside();
  void draw_lines();
  void draw_notes();

  const Plant& plant_;
  Blocks blocks_;
  automata::Variables names_;
  std::map<VariableId, Side> ports_;  ///< what is drawn, and at which side of its block
  std::set<VariableId> commanded_, observed_;
  std::map<std::pair<VariableId, VariableId>, Line> lines_;
  std::vector<std::pair<VariableId, VariableId>> line_order_;
  std::vector<std::pair<std::size_t, Flow>> notes_;
  DotText dot_;
};

PlantDiagram::PlantDiagram(const Plant& plant, std::string_view inside, std::optional<std::size_t> depth)
    : plant_(plant),
      blocks_(plant, inside, depth),
      names_(own_names(plant, inside)),
      dot_(style::begin(inside.empty() ? std::string_view(plant.name) : inside, "LR")) {
  sort_interconnections();
  find_marks();
}

void PlantDiagram::use(VariableId variable, Side side) { ports_.emplace(variable, side); }

/// Whether an interconnection is of no concern here: it has no end inside, or all in one folded module.
bool PlantDiagram::is_hidden(const Formula& constraint) const {
  const auto variables = automata::variables_of(constraint);
  if (std::none_of(variables.begin(), variables.end(), [&](VariableId v) { return blocks_.is_inside(v); })) return true;
  const auto first = blocks_.block_of(variables.front());
  return first && blocks_.all()[*first].component == nullptr &&
         std::all_of(variables.begin(), variables.end(), [&](VariableId v) { return blocks_.block_of(v) == first; });
}

/// `open1 <-> open` where it is clear from the ports what has these values, else all of it.
std::string PlantDiagram::text(const Formula& constraint) const {
  const auto is_assignment = [](const Formula& f) { return f.kind == Formula::Kind::member && f.values.size() == 1; };
  const auto& sides = constraint.operands;
  if (constraint.kind == Formula::Kind::equivalence && is_assignment(sides[0]) && is_assignment(sides[1])) {
    return names_.value({sides[0].variable, sides[0].values[0]}) + " <-> " +
           names_.value({sides[1].variable, sides[1].values[0]});
  }
  return to_text(constraint, names_);
}

void PlantDiagram::sort_interconnections() {
  const std::vector<bool> read = read_variables(plant_);
  for (std::size_t q = 0; q < plant_.interconnections.size(); ++q) {
    const Formula& constraint = plant_.interconnections[q].constraint;
    if (is_hidden(constraint)) continue;
    Flow flow = flow_of(constraint, read);
    for (const VariableId variable : flow.from) use(variable, Side::right);
    for (const VariableId variable : flow.to) use(variable, Side::left);
    if (flow.from.size() != 1 || flow.to.size() != 1) {
      notes_.emplace_back(q, std::move(flow));
      continue;
    }
    const std::pair ends(flow.from.front(), flow.to.front());
    const auto [at, fresh] = lines_.try_emplace(ends);
    if (fresh) line_order_.push_back(ends);
    at->second.interconnections.push_back(q);
    if (constraint.kind != Formula::Kind::equality) at->second.texts.push_back(text(constraint));
  }
}

void PlantDiagram::find_marks() {
  const auto is_drawn = [&](VariableId variable) {
    if (!blocks_.is_inside(variable)) return false;
    const auto block = blocks_.block_of(variable);
    return !block || blocks_.all()[*block].component != nullptr;
  };
  for (const automata::Control& control : plant_.controls) {
    commanded_.insert(control.variable);
    if (is_drawn(control.variable)) use(control.variable, Side::left);
  }
  for (const VariableId observable : plant_.observables) {
    observed_.insert(observable);
    if (is_drawn(observable)) use(observable, Side::right);
  }
}

std::string PlantDiagram::run(std::string_view inside) {
  const bool module = !inside.empty();
  style::caption(dot_, module ? inside : std::string_view(plant_.name),
                 std::string(module ? "module" : "plant") + " · ▸ commanded · ◉ observed");
  dot_.set({{"nodesep", dot_value("0.25")}, {"ranksep", dot_value("0.7")}});
  dot_.defaults("edge", {{"dir", dot_value("none")}});
  std::set<std::size_t> drawn;
  draw_module(std::string(inside), drawn);
  draw_outside();
  draw_notes();
  draw_lines();
  return dot_.finish();
}

std::string PlantDiagram::with_marks(VariableId variable, const std::string& name) const {
  std::string markup = escaped(name);
  if (commanded_.contains(variable)) markup = style::in_font("▸ " + markup, style::command, 9);
  if (observed_.contains(variable)) markup += style::in_font(" ◉", style::sensor, 9);
  return markup;
}

std::string PlantDiagram::port_name(VariableId variable, const Block& block) const {
  const std::string& name = plant_.variables.name(variable);
  return name == block.path ? "mode" : name.substr(block.path.size() + 1);
}

std::string PlantDiagram::port_cell(VariableId variable, const Block& block, Side side) const {
  return "<TD PORT=\"p" + std::to_string(variable.index() + 1) + "\" ALIGN=\"" +
         (side == Side::left ? "LEFT" : "RIGHT") + "\">" +
         style::in_font(with_marks(variable, port_name(variable, block)), style::ink, 9) + "</TD>";
}

std::string PlantDiagram::port_rows(std::size_t block) const {
  std::vector<std::string> left;
  std::vector<std::string> right;
  for (const auto& [variable, side] : ports_) {
    if (blocks_.block_of(variable) != block) continue;
    (side == Side::left ? left : right).push_back(port_cell(variable, blocks_.all()[block], side));
  }
  std::string rows;
  for (std::size_t row = 0; row < std::max(left.size(), right.size()); ++row) {
    rows += "<TR>" + (row < left.size() ? left[row] : "<TD></TD>") + (row < right.size() ? right[row] : "<TD></TD>") +
            "</TR>";
  }
  return rows;
}

/// What is counted of a block and not drawn; empty where there is nothing.
std::string PlantDiagram::rest_of(std::size_t block) const {
  const auto of_block = [&](VariableId v) { return blocks_.block_of(v) == block; };
  const auto number = [](auto count, const char* what) {
    return count == 0 ? std::string() : std::to_string(count) + " " + what;
  };
  if (blocks_.all()[block].component == nullptr) {
    const std::string commands = number(std::count_if(commanded_.begin(), commanded_.end(), of_block), "commanded");
    const std::string readings = number(std::count_if(observed_.begin(), observed_.end(), of_block), "observed");
    return commands + (commands.empty() || readings.empty() ? "" : ", ") + readings;
  }
  std::size_t inner = 0;
  for (std::size_t v = 0; v < plant_.variables.size(); ++v) {
    const VariableId variable(v);
    if (plant_.variables.name(variable) == blocks_.all()[block].path || ports_.contains(variable)) continue;
    if (of_block(variable)) ++inner;
  }
  return number(inner, "more");
}

void PlantDiagram::draw_block(std::size_t position) {
  const Block& block = blocks_.all()[position];
  const bool folded = block.component == nullptr;
  const std::string_view own = std::string_view(block.path).substr(block.path.rfind('.') + 1);
  const std::string type = folded ? std::to_string(block.components) + " components" : block.component->type;
  std::string rows = R"(<TR><TD COLSPAN="2">)" + style::in_font("<B>" + escaped(own) + "</B>", style::ink, 11) +
                     "<BR/>" + style::in_font(escaped(type), style::faint, 9) + "</TD></TR>" + port_rows(position);
  if (const std::string rest = rest_of(position); !rest.empty()) {
    rows += R"(<TR><TD COLSPAN="2">)" + style::in_font(rest, style::faint, 8) + "</TD></TR>";
  }
  const std::string table = std::string("<TABLE BORDER=\"") + (folded ? "2" : "1") +
                            R"(" CELLBORDER="0" CELLSPACING="0" CELLPADDING="3" STYLE="ROUNDED" COLOR=")" +
                            std::string(style::line) + "\" BGCOLOR=\"" +
                            std::string(folded ? style::shade : style::paper) + "\">" + rows + "</TABLE>";
  dot_.node("b" + std::to_string(position + 1),
            {{"shape", dot_value("plain")}, {"label", dot_label(table)}, {"tooltip", dot_value(block.path)}});
}

void PlantDiagram::draw_ports_of(const std::string& module) {
  for (const auto& [variable, side] : ports_) {
    if (!blocks_.is_inside(variable) || blocks_.block_of(variable) || blocks_.module_of(variable) != module) continue;
    const std::string& name = plant_.variables.name(variable);
    const std::string own = module.empty() ? name : name.substr(module.size() + 1);
    dot_.node("v" + std::to_string(variable.index() + 1),
              {{"shape", dot_value("box")},
               {"style", dot_value("rounded,filled")},
               {"fillcolor", dot_value(style::paper)},
               {"margin", dot_value("0.06,0.02")},
               {"height", dot_value("0.2")},
               {"width", dot_value("0.2")},
               {"label", dot_label(style::in_font(with_marks(variable, own), style::ink, 9))}});
  }
}

/// What is inside of a module: its ports, its blocks, and the modules in it that are open, each in a box.
void PlantDiagram::draw_module(const std::string& path, std::set<std::size_t>& drawn) {
  draw_ports_of(path);
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
    const std::string name = module.substr(path.empty() ? 0 : path.size() + 1);
    dot_.open_cluster("b" + std::to_string(b + 1),
                      {{"style", dot_value("rounded,filled")},
                       {"fillcolor", dot_value(style::shade)},
                       {"color", dot_value(style::line)},
                       {"labeljust", dot_value("l")},
                       {"label", dot_label("<B>" + style::in_font(escaped(name), style::ink, 11) + "</B>")}});
    draw_module(module, drawn);
    dot_.close_cluster();
  }
}

void PlantDiagram::draw_outside() {
  for (const auto& [variable, side] : ports_) {
    if (blocks_.is_inside(variable)) continue;
    dot_.node("x" + std::to_string(variable.index() + 1),
              {{"shape", dot_value("plaintext")},
               {"height", dot_value("0.2")},
               {"margin", dot_value("0.04,0.02")},
               {"label", dot_label(style::in_font(escaped(plant_.variables.name(variable)), style::faint, 9))}});
  }
}

std::string PlantDiagram::end_of(VariableId variable, Side side) const {
  const std::string number = std::to_string(variable.index() + 1);
  if (!blocks_.is_inside(variable)) return "x" + number;
  const auto block = blocks_.block_of(variable);
  if (!block) return "v" + number;
  const auto port = ports_.find(variable);
  const bool left = (port == ports_.end() ? side : port->second) == Side::left;
  return "b" + std::to_string(*block + 1) + ":p" + number + (left ? ":w" : ":e");
}

void PlantDiagram::draw_lines() {
  for (const auto& ends : line_order_) {
    const Line& line = lines_.at(ends);
    std::string id = "q";
    for (const std::size_t q : line.interconnections) id += (id.size() > 1 ? "_" : "") + std::to_string(q + 1);
    DotAttributes attributes{{"id", dot_value(id)}};
    std::vector<std::string> texts;
    for (const std::string& text : line.texts) {
      for (std::string& part : style::wrapped(text, constraint_width)) texts.push_back(std::move(part));
    }
    if (!texts.empty()) {
      attributes.push_back({"label", dot_label(style::beside_arrow(style::lines(texts, Align::left)))});
    }
    dot_.edge(end_of(ends.first, Side::right), end_of(ends.second, Side::left), attributes);
  }
}

void PlantDiagram::draw_notes() {
  for (const auto& [q, flow] : notes_) {
    const std::string note = "q" + std::to_string(q + 1);
    const auto text = style::wrapped(to_text(plant_.interconnections[q].constraint, names_), constraint_width);
    dot_.node(note, {{"shape", dot_value("box")},
                     {"style", dot_value("dotted,filled")},
                     {"fillcolor", dot_value(style::paper)},
                     {"margin", dot_value("0.06,0.04")},
                     {"height", dot_value("0.2")},
                     {"fontsize", dot_value("9")},
                     {"label", dot_label(style::lines(text, Align::left))}});
    for (const VariableId variable : flow.from) dot_.edge(end_of(variable, Side::right), note, {});
    for (const VariableId variable : flow.to) dot_.edge(note, end_of(variable, Side::left), {});
  }
}

}  // namespace

std::string plant_diagram(const Plant& plant, std::string_view inside, std::optional<std::size_t> depth) {
  return PlantDiagram(plant, inside, depth).run(inside);
}

}  // namespace rmpl::compiler
