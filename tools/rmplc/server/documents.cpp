// Opening, changing and closing documents.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/documents.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "tools/rmplc/server/positions.hpp"
#include "tools/rmplc/server/uri.hpp"

namespace rmpl::tools {
namespace {

/// A path for what is no file, with the ending of its language.
std::string made_up_path(std::string uri, const std::string& language) {
  std::replace(uri.begin(), uri.end(), '/', '_');
  std::replace(uri.begin(), uri.end(), '\0', '_');
  return "/" + uri + "/unsaved." + (language.empty() ? "rmpl" : language);
}

/// The text with one change made to it; without a range the change is all of the text.
std::string changed(const grammar::SourceFile& source, const Json& change) {
  std::string text = text_member(change, "text");
  if (!change.contains("range") || change["range"].is_null()) return text;
  const Json& range = change["range"];
  const std::uint32_t begin = offset_of(source, member(range, "start"));
  const std::uint32_t end = offset_of(source, member(range, "end"));
  if (end < begin) throw RpcError(RpcCode::invalid_params, "`range`: its end is before its start");
  std::string whole(source.text().substr(0, begin));
  whole += text;
  whole += source.text().substr(end);
  return whole;
}

std::int64_t version_of(const Json& document) {
  const auto version = document.find("version");
  return version != document.end() && version->is_number_integer() ? version->get<std::int64_t>() : 0;
}

}  // namespace

const OpenDocument& Documents::open(const Json& params) {
  const Json& given = member(params, "textDocument");
  OpenDocument document;
  document.uri = text_member(given, "uri");
  const auto path = path_of_uri(document.uri);
  document.is_file = path.has_value();
  const auto language = given.find("languageId");
  const bool named = language != given.end() && language->is_string();
  document.path = path ? *path : made_up_path(document.uri, named ? language->get<std::string>() : "");
  document.version = version_of(given);
  std::string text = text_member(given, "text");
  uri_by_source_[texts_.identity(document.path)] = document.uri;  // throws where no file can have the name
  OpenDocument& kept = open_[document.uri] = std::move(document);
  keep(kept, std::make_shared<grammar::SourceFile>(kept.path, std::move(text)));
  return kept;
}

const OpenDocument& Documents::change(const Json& params) {
  OpenDocument& document = open_.at(of(params).uri);
  const Json& changes = member(params, "contentChanges");
  if (!changes.is_array()) throw RpcError(RpcCode::invalid_params, "`contentChanges`: expected an array");
  std::shared_ptr<const grammar::SourceFile> source = document.source;
  for (const Json& change : changes)
    source = std::make_shared<grammar::SourceFile>(document.path, changed(*source, change));
  document.version = version_of(member(params, "textDocument"));
  keep(document, std::move(source));
  return document;
}

void Documents::close(const Json& params) {
  const OpenDocument& document = of(params);
  texts_.remove(document.path);
  uri_by_source_.erase(texts_.identity(document.path));
  open_.erase(std::string(document.uri));
}

const OpenDocument& Documents::of(const Json& params) const {
  const std::string uri = text_member(member(params, "textDocument"), "uri");
  const auto found = open_.find(uri);
  if (found == open_.end()) throw RpcError(RpcCode::invalid_params, uri + ": the document is not open");
  return found->second;
}

std::string Documents::uri_of(const std::string& path) const {
  const auto known = uri_by_source_.find(texts_.identity(path));
  return known != uri_by_source_.end() ? known->second : uri_of_path(path);
}

void Documents::keep(OpenDocument& document, std::shared_ptr<const grammar::SourceFile> source) {
  document.source = std::move(source);
  texts_.put(document.path, std::string(document.source->text()));
}

}  // namespace rmpl::tools
