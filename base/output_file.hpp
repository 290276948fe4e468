// Writing a result: the whole of it, or nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rmpl::base {

/// A file that is being written. Until it is kept it has a random name beside its target, and the target is as it was;
/// then it is flushed to the disk and takes the target's name, with the mode that the target had, so that no reader
/// ever sees a part. Symbolic links are followed. What is no regular file (a terminal, a pipe, /dev/null) is written in
/// place.
class OutputFile {
 public:
  /// Throws InputError with the reason where the file cannot be written, is one that was read, or is being written by
  /// another one.
  explicit OutputFile(std::string path);
  /// What was not kept is removed.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Throws InputError with the reason where it cannot be written.
  void write(std::string_view text);
  /// The file is complete, and stands under its name. Throws as `write` does; then the target is as it was.
  void keep();

 private:
  /// The right to write to a target, of which one file has it at a time.
  class Claim {
   public:
    Claim(const std::string& path, const std::string& target);
    ~Claim();
    Claim(const Claim&) = delete;
    Claim& operator=(const Claim&) = delete;

   private:
    std::string name_;
  };

  static constexpr std::size_t no_slot = static_cast<std::size_t>(-1);

  void open_in_place();
  void open_beside(bool replaces);
  void flush();
  [[noreturn]] void fail(int reason) const;

  std::string path_;    ///< as the user named it, for messages
  std::string target_;  ///< behind all links
  std::optional<Claim> claim_;
  std::string temporary_;  ///< empty where the target is written in place, and once it is kept
  std::size_t slot_ = no_slot;
  int file_ = -1;
  std::string pending_;
};

/// Writes a text as a file: all of the above at once.
void write_file(const std::string& path, std::string_view text);

/// Removes what an earlier run left at `path`, for this one has nothing to write there: whether there was a regular
/// file. Throws InputError with the reason where it cannot be removed, or is one that was read.
bool remove_stale_file(const std::string& path);

/// Removes what was begun and not kept. For the end of a process by a signal: only calls what a handler may call.
void remove_unfinished_files() noexcept;

}  // namespace rmpl::base
