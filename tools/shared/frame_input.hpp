// Frames from standard input.
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/shared/framing.hpp"

namespace rmpl::tools {

/// Whether bytes, or their end, can be had from standard input without waiting.
bool input_is_ready();
/// Feeds what there is, waiting for the first byte. False at the end. Throws base::InputError where it cannot be read.
bool read_some(Frames& frames);

}  // namespace rmpl::tools
