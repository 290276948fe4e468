// Where sources come from: the disk, memory, or texts in memory that lie over others, as an editor has them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace rmpl::compiler {

/// Gives the texts of a compilation by the names that the user, an import or a scenario has for them.
class Provider {
 public:
  Provider() = default;
  Provider(const Provider&) = delete;
  Provider& operator=(const Provider&) = delete;
  virtual ~Provider() = default;

  /// The whole text. Throws base::InputError with the reason where there is none, or not all of it can be read.
  [[nodiscard]] virtual std::string read(const std::string& path) = 0;
  /// The same of a path that a text names, and not the user: an import, the plant of a scenario.
  [[nodiscard]] virtual std::string read_named(const std::string& path) = 0;
  /// The same for two paths only where both name the same source.
  [[nodiscard]] virtual std::string identity(const std::string& path) const = 0;
};

/// Files, and standard input for `-`. What the user names may be a pipe or a device, as `<(…)` of a shell is; what a
/// text names is a regular file.
class Disk final : public Provider {
 public:
  [[nodiscard]] std::string read(const std::string& path) override;
  [[nodiscard]] std::string read_named(const std::string& path) override;
  [[nodiscard]] std::string identity(const std::string& path) const override;
};

/// Files of people at work, whatever names them: regular ones, of at most so many bytes each. Never waits.
class RegularFiles final : public Provider {
 public:
  explicit RegularFiles(std::size_t most) : most_(most) {}

  [[nodiscard]] std::string read(const std::string& path) override;
  [[nodiscard]] std::string read_named(const std::string& path) override { return read(path); }
  [[nodiscard]] std::string identity(const std::string& path) const override;

 private:
  std::size_t most_;
};

/// Texts that were put here, by the paths that they were given, normalised.
class Memory final : public Provider {
 public:
  void put(const std::string& path, std::string text);
  [[nodiscard]] std::string read(const std::string& path) override;
  [[nodiscard]] std::string read_named(const std::string& path) override { return read(path); }
  [[nodiscard]] std::string identity(const std::string& path) const override;

 private:
  std::map<std::string, std::string> texts_;
};

/// Texts that take the place of those of another provider: files that are open in an editor, over the disk.
class Overlay final : public Provider {
 public:
  /// `below` must live as long as the overlay.
  explicit Overlay(Provider& below) : below_(below) {}

  void put(const std::string& path, std::string text);
  /// From now on the text below is seen again.
  void remove(const std::string& path);
  [[nodiscard]] std::string read(const std::string& path) override;
  [[nodiscard]] std::string read_named(const std::string& path) override;
  [[nodiscard]] std::string identity(const std::string& path) const override;

 private:
  Provider& below_;
  std::map<std::string, std::string> texts_;  ///< by identity
};

}  // namespace rmpl::compiler
