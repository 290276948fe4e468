// Diagnostics as JSON.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "grammar/source/render.hpp"

namespace rmpl::grammar {
namespace {

using Json = nlohmann::ordered_json;

void put_place(Json& object, Span span, const Sources& sources) {
  const SourceFile& file = sources[span.file];
  const Place begin = file.place(span.begin);
  const Place end = file.place(span.end);
  object["file"] = file.name();
  object["line"] = begin.line;
  object["column"] = begin.column;
  object["end_line"] = end.line;
  object["end_column"] = end.column;
}

}  // namespace

std::string render_json(std::span<const Diagnostic> diagnostics, const Sources& sources) {
  Json list = Json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    Json object;
    object["code"] = to_string(diagnostic.code);
    object["severity"] = to_string(diagnostic.severity);
    put_place(object, diagnostic.span, sources);
    object["message"] = diagnostic.message;
    object["notes"] = Json::array();
    for (const Note& note : diagnostic.notes) {
      Json entry;
      put_place(entry, note.span, sources);
      entry["message"] = note.message;
      object["notes"].push_back(std::move(entry));
    }
    object["suggestion"] = diagnostic.suggestion ? Json(*diagnostic.suggestion) : Json(nullptr);
    object["fix"] = Json::array();
    for (const Edit& edit : diagnostic.fix) {
      Json entry;
      put_place(entry, edit.span, sources);
      entry["text"] = edit.text;
      object["fix"].push_back(std::move(entry));
    }
    list.push_back(std::move(object));
  }
  // A file name or a message may hold any bytes: what is no UTF-8 is replaced.
  return list.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string render_json(const Findings& findings) {
  return render_json(findings.diagnostics.sorted(), findings.sources);
}

}  // namespace rmpl::grammar
