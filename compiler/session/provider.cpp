// Sources from the disk, from memory, and from memory over the disk.
// SPDX-License-Identifier: MIT
#include "compiler/session/provider.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/error.hpp"

namespace rmpl::compiler {

namespace {

/// A descriptor that is closed at the end; standard input stays open.
class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : number_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ > STDIN_FILENO) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail(const std::string& path, int reason) {
  throw base::InputError((path == "-" ? "standard input" : path) + ": " + std::strerror(reason));
}

}  // namespace

std::string Disk::read(const std::string& path) {
  if (path.empty()) throw base::InputError("'' is no name of a file");
  const Descriptor file(path);
  if (file.number() < 0) fail(path, errno);
  std::string text;
  std::array<char, 65536> block{};
  for (;;) {
    const ssize_t count = ::read(file.number(), block.data(), block.size());
    if (count == 0) return text;
    if (count > 0) text.append(block.data(), static_cast<std::size_t>(count));
    if (count < 0 && errno == EISDIR) throw base::InputError(path + ": is a directory, expected a file");
    if (count < 0 && errno != EINTR) fail(path, errno);
  }
}

std::string Disk::identity(const std::string& path) const {
  if (path == "-") return path;
  std::error_code error;
  const auto resolved = std::filesystem::weakly_canonical(path, error);
  return error ? path : resolved.string();
}

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

std::string Overlay::identity(const std::string& path) const { return below_.identity(path); }

}  // namespace rmpl::compiler
