// The automata as JSON and back: same automata, same bytes. Schema: grammar/schema/document.schema.json.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "automata/json/node.hpp"
#include "automata/scenario.hpp"

namespace rmpl::automata {

/// The document as JSON. Times are whole nanoseconds or "inf"; modes, values and variables are named, not numbered;
/// locations have their printed numbers, from 1.
Json to_json(const Document& document);
/// The bytes that `rmplc compile` writes: indented by two, one final newline.
std::string to_text(const Document& document);

/// Reads a compiled document. Throws base::InputError that names the JSON path at fault; nothing is half accepted.
Document document_from_json(const Json& json);
/// Parses, then reads. `name` is the file's name, for messages.
Document read_document(std::string_view text, const std::string& name);

/// A formula as a tree over names: true, false, {"variable", "in": […]}, {"variable", "equals": …},
/// {"clock", "is": "<|<=|>|>=", "bound"}, {"not"}, {"and": […]}, {"or": […]}, {"implies": [a, b]}, {"iff": [a, b]}.
Json to_json(const Formula& formula, const Variables& variables, std::span<const std::string> clocks = {});
Formula formula_from_json(const Node& node, const Variables& variables, std::span<const std::string> clocks = {});

/// A table of variables as [{"name", "values": […]}, …], and back; names and values are unique.
Json to_json(const Variables& variables);
Variables variables_from_json(const Node& node);

/// `variable = value` as the pair [variable, value], and back.
Json to_json(const Assignment& assignment, const Variables& variables);
Assignment assignment_from_json(const Node& node, const Variables& variables);

Json to_json(const Plant& plant);
Plant plant_from_json(const Node& node);
Json to_json(const Program& program);
Program program_from_json(const Node& node);
Json to_json(const Scenario& scenario, const Document& document);
Scenario scenario_from_json(const Node& node, const Document& document);

Json to_json(const Origin& origin);
Origin origin_from_json(const Node& node);
/// Whole nanoseconds, or "inf".
Json to_json(Ticks time);

}  // namespace rmpl::automata
