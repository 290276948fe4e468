// The files of `runtime/report/page`, as they were when this was built.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace rmpl::runtime {

extern const std::string_view page_frame;                     ///< report.html
extern const std::string_view page_style;                     ///< report.css
extern const std::span<const std::string_view> page_scripts;  ///< the scripts, in the order in which they run

}  // namespace rmpl::runtime
