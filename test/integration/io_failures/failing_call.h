// System calls that are counted, and one of them fails: this program's connect(), send() and so on are our
// own, and hand over to the system's.
#pragma once

#include <ostream>
#include <vector>

namespace cobot_command::runtime {

enum class Call { Socket, Connect, Accept, Send, Receive, Poll, EpollControl, SetOption };

/// A call, and what it fails with.
struct Failure {
  const char* name;
  Call call;
  int error;
};
inline void PrintTo(const Failure& failure, std::ostream* out) {
  *out << failure.name;
}

class FailingCall {
 public:
  /// The n-th of these calls from now on, from 1, in any thread, fails. One at a time in the program.
  FailingCall(const Failure& failure, int n);
  ~FailingCall();
  FailingCall(const FailingCall&) = delete;
  FailingCall& operator=(const FailingCall&) = delete;

  [[nodiscard]] bool happened() const;
};

}  // namespace cobot_command::runtime
