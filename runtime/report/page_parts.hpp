// The files of `runtime/report/page`, as they were when this was built.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace rmpl::runtime {

extern const std::string_view page_frame;   ///< report.html
extern const std::string_view page_style;   ///< report.css
extern const std::string_view page_script;  ///< all scripts, one after the other

}  // namespace rmpl::runtime
