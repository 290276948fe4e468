// What a file holds: by its name, or by its first words.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rmpl::compiler {

/// What a file holds, told by its extension; of standard input, by its content.
enum class Kind { program, plant, scenario, properties, monitors, document };

/// The kind of a file by its extension: `.rmpl`, `.tcca`, `.scn`, `.props`, `.mon`, `.json`. Nothing for any other.
std::optional<Kind> kind_by_name(const std::string& path);
/// What to say of a file of another kind than models have.
std::string not_a_model(const std::string& path);
/// The kind of a text: `{` opens a document; `scenario`, `channel "`, `property "` or a setting of properties,
/// `component`, `module`, `domain` or `plant` say what they are; all else is a program.
Kind kind_by_content(std::string_view text);

}  // namespace rmpl::compiler
