// Sources from the disk, from memory, and from memory over the disk.
// SPDX-License-Identifier: MIT
#include "compiler/session/provider.hpp"

#include <filesystem>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"

namespace rmpl::compiler {

namespace {

std::string canonical(const std::string& path) {
  if (path == "-") return path;
  std::error_code error, ignored;
  const auto resolved = std::filesystem::weakly_canonical(path, error);
  // A pipe of a shell, `<(…)`, leads to no name; it is read once, under the name that it was given.
  if (error && std::filesystem::is_fifo(std::filesystem::status(path, ignored))) return path;
  // A file that goes by two names would be two files, and what it defines would be there twice.
  if (error) throw base::InputError(path + ": " + error.message());
  return resolved.string();
}

}  // namespace

std::string Disk::read(const std::string& path) { return base::read_file(path); }

std::string Disk::read_named(const std::string& path) {
  return base::read_regular_file(path, std::numeric_limits<std::size_t>::max());
}

std::string Disk::identity(const std::string& path) const { return canonical(path); }

std::string RegularFiles::read(const std::string& path) { return base::read_regular_file(path, most_); }

std::string RegularFiles::identity(const std::string& path) const { return canonical(path); }

void Memory::put(const std::string& path, std::string text) {
  texts_.insert_or_assign(identity(path), std::move(text));
}

std::string Memory::read(const std::string& path) {
  const auto text = texts_.find(identity(path));
  if (text == texts_.end()) throw base::InputError(path + ": there is no such text");
  return text->second;
}

std::string Memory::identity(const std::string& path) const {
  return std::filesystem::path(path).lexically_normal().string();
}

void Overlay::put(const std::string& path, std::string text) {
  texts_.insert_or_assign(identity(path), std::move(text));
}

void Overlay::remove(const std::string& path) { texts_.erase(identity(path)); }

std::string Overlay::read(const std::string& path) {
  const auto text = texts_.find(identity(path));
  return text == texts_.end() ? below_.read(path) : text->second;
}

std::string Overlay::read_named(const std::string& path) {
  const auto text = texts_.find(identity(path));
  return text == texts_.end() ? below_.read_named(path) : text->second;
}

std::string Overlay::identity(const std::string& path) const { return below_.identity(path); }

}  // namespace rmpl::compiler
