// The frame of the page, filled.
// SPDX-License-Identifier: MIT
#include <utility>

#include "base/check.hpp"
#include "runtime/report/page.hpp"
#include "runtime/report/page_parts.hpp"

namespace rmpl::runtime {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace

std::string to_html(const Report& report) {
  const std::string data = to_json(report);
  const std::string title = escaped(report.title);
  std::string scripts;
  for (const std::string_view script : page_scripts) {
    scripts += script;
  }
  const std::pair<std::string_view, std::string_view> parts[] = {
      {"<!--title-->", title}, {"/*style*/", page_style}, {"<!--data-->", data}, {"/*script*/", scripts}};
  std::string html;
  std::string_view rest = page_frame;
  for (const auto& [mark, part] : parts) {
    const std::size_t at = rest.find(mark);
    CHECK(at != std::string_view::npos && "the frame has a place for every part, in this order");
    html += rest.substr(0, at);
    html += part;
    rest.remove_prefix(at + mark.size());
  }
  return html.append(rest);
}

}  // namespace rmpl::runtime
