// A project to begin with: a plant, a program, flights and claims that hold together.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rmpl::tools {

/// Makes the folder with all that is in it, at once, or nothing. The project is called as the folder is. Throws
/// base::InputError where something of that name is there, or it cannot be made.
void make_project(const std::string& folder);

}  // namespace rmpl::tools
