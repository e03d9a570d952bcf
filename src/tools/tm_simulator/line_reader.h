// Lines of a file descriptor, read on a thread of its own that can be ended at any moment.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <thread>

namespace cobot_command::tools {

/// The descriptor stays as it is: what shares a terminal with it must not become non-blocking.
class LineReader {
 public:
  using Use = std::function<void(std::string line)>;

  /// `use` gets each line without its end, on the reader's thread; also a last one without an end.
  /// Precondition: the descriptor stays open as long as the reader.
  LineReader(int descriptor, Use use);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

 private:
  void run();
  [[nodiscard]] bool waitForInput() const;
  void take(const char* bytes, std::size_t count);

  int descriptor_;
  Use use_;
  std::string line_;
  std::array<int, 2> end_{-1, -1};  // a pipe: closed at its writing end, it ends the thread
  std::thread thread_;
};

}  // namespace cobot_command::tools
