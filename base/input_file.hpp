// Reading: every byte of a file, or the reason why not.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>

namespace rmpl::base {

/// What may be read at once, in bytes: a file that is read whole, a line of one that is read line by line. 1 GiB unless
/// it is set. What is longer is an InputError, so that a wrong file name does not end in a lack of memory.
void limit_inputs(std::size_t bytes);

/// Once `ended` says so, a file that is read whole and is not there yet (a pipe, a terminal) is a LimitError. To be set
/// before anything is read; asked while it waits.
void end_inputs_when(std::function<bool()> ended);

/// The whole of a file; `-` is standard input. Throws InputError with the reason where a byte of it cannot be read, and
/// LimitError as above.
std::string read_file(const std::string& path);

/// The same of what is a regular file of at most `most` bytes: for names that nobody has typed just now, but that stand
/// in a text or were found beside one. Never waits: a pipe may have no writer, and a device no end.
std::string read_regular_file(const std::string& path, std::size_t most = static_cast<std::size_t>(-1));

/// A file as a stream; `-` is standard input. What cannot be read is an InputError with the reason, thrown where the
/// stream is opened, or out of what reads from it.
class InputFile {
 public:
  enum class Accept { anything, regular_files };  ///< of the latter `-` is one by that name

  /// While it waits for more, `stop` is asked whether that is the end.
  explicit InputFile(const std::string& path, std::function<bool()> stop = {}, Accept accept = Accept::anything);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  [[nodiscard]] std::istream& stream() { return stream_; }
  /// For messages: the path, or `standard input`.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  class Buffer;
  std::string name_;
  std::unique_ptr<Buffer> buffer_;
  std::istream stream_;
};

/// Whether a second reading gives the same: so it is with a file on the disk, and not with a pipe or standard input.
bool is_read_again(const std::string& path);

/// The name of the file that this process has read so far and that `path` leads to, if there is one: writing there
/// would destroy an input. Throws InputError where that cannot be told.
std::optional<std::string> input_at(const std::string& path);

}  // namespace rmpl::base
