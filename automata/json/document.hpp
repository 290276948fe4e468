// The automata as JSON and back: same automata, same bytes. Schema: grammar/schema/document.schema.json.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "automata/json/node.hpp"
#include "automata/scenario.hpp"

namespace rmpl::automata {

/// The document as JSON. Times are whole nanoseconds or "inf"; modes, values and variables are named, not numbered;
/// locations have their printed numbers, from 1.
Json to_json(const Document& document);
/// The bytes that `rmplc compile` writes: as `laid_out` has it, one final newline.
std::string to_text(const Document& document);

/// Reads a compiled document. Throws base::InputError that names the JSON path at fault; nothing is half accepted.
Document document_from_json(const Json& json);
/// The document of a text that is one, read a type at a time, so that what is parsed is never held as a whole. Nothing
/// where something is wrong with it, or written other than plainly (scan_json): `parse_json` and `document_from_json`
/// tell what, or read it.
std::optional<Document> read_plain_document(std::string_view text);
/// Parses, then reads. `name` is the file's name, for messages.
Document read_document(std::string_view text, const std::string& name);

/// A formula as a tree over names: true, false, {"variable", "in": […]}, {"variable", "equals": …},
/// {"clock", "is": "<|<=|>|>=", "bound"}, {"not"}, {"and": […]}, {"or": […]}, {"implies": [a, b]}, {"iff": [a, b]}.
Json to_json(const Formula& formula, const Variables& variables, std::span<const std::string> clocks = {});
Formula formula_from_json(const Node& node, const Variables& variables, std::span<const std::string> clocks = {});

/// A variable as {"name", "values": […]}, and a table of them as an array, and back; names and values are unique.
Json to_json(const Variable& variable);
Variable variable_from_json(const Node& node);
Json to_json(const Variables& variables);
Variables variables_from_json(const Node& node);

/// `variable = value` as the pair [variable, value], and back.
Json to_json(const Assignment& assignment, const Variables& variables);
Assignment assignment_from_json(const Node& node, const Variables& variables);

/// A plant by its outline: "types", each a plant with names relative to itself, and "instances" of them, in the plant
/// and in types; what is left is written out. PlantReader reads it back.
Json to_json(const Plant& plant);
/// A program; where its variables are those of one of `plants`, it names the first such by its number, as "plant".
Json to_json(const Program& program, std::span<const Plant> plants = {});
Program program_from_json(const Node& node, std::span<const Plant> plants);
Json to_json(const Scenario& scenario, const Document& document);
Scenario scenario_from_json(const Node& node, const Document& document);

/// `file:line:column`.
Json to_json(const Origin& origin);
Origin origin_from_json(const Node& node);
/// Whole nanoseconds, or "inf".
Json to_json(Ticks time);

}  // namespace rmpl::automata
