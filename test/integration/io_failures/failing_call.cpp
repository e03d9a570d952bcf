#include "failing_call.h"

#include <atomic>
#include <cerrno>

#include <dlfcn.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/socket.h>

namespace cobot_command::runtime {
namespace {

// They are there before the first constructor runs.
std::atomic<int> failing_call{-1};
std::atomic<int> failing_with{0};
std::atomic<int> until_failure{0};
std::atomic<bool> has_failed{false};

/// Is it the turn of this one? Then errno is set.
bool fails(Call call) {
  if (failing_call != static_cast<int>(call) || --until_failure != 0) {
    return false;
  }
  has_failed = true;
  errno = failing_with;
  return true;
}

/// The system's own.
template <class Function>
Function* systemCall(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

FailingCall::FailingCall(const Failure& failure, int n) {
  has_failed = false;
  failing_with = failure.error;
  until_failure = n;
  failing_call = static_cast<int>(failure.call);
}

FailingCall::~FailingCall() {
  failing_call = -1;
}

bool FailingCall::happened() const {
  return has_failed;
}

}  // namespace cobot_command::runtime

using cobot_command::runtime::Call;
using cobot_command::runtime::fails;
using cobot_command::runtime::systemCall;

// NOLINTBEGIN(readability-identifier-naming): the system's names
extern "C" {

int socket(int domain, int type, int protocol) noexcept {
  static auto* const system = systemCall<int(int, int, int)>("socket");
  return fails(Call::Socket) ? -1 : system(domain, type, protocol);
}

int connect(int fd, const sockaddr* address, socklen_t size) {
  static auto* const system = systemCall<int(int, const sockaddr*, socklen_t)>("connect");
  return fails(Call::Connect) ? -1 : system(fd, address, size);
}

int accept(int fd, sockaddr* address, socklen_t* size) {
  static auto* const system = systemCall<int(int, sockaddr*, socklen_t*)>("accept");
  return fails(Call::Accept) ? -1 : system(fd, address, size);
}

ssize_t send(int fd, const void* bytes, size_t size, int flags) {
  static auto* const system = systemCall<ssize_t(int, const void*, size_t, int)>("send");
  return fails(Call::Send) ? -1 : system(fd, bytes, size, flags);
}

ssize_t sendmsg(int fd, const msghdr* message, int flags) {
  static auto* const system = systemCall<ssize_t(int, const msghdr*, int)>("sendmsg");
  return fails(Call::Send) ? -1 : system(fd, message, flags);
}

ssize_t recv(int fd, void* bytes, size_t size, int flags) {
  static auto* const system = systemCall<ssize_t(int, void*, size_t, int)>("recv");
  return fails(Call::Receive) ? -1 : system(fd, bytes, size, flags);
}

ssize_t recvmsg(int fd, msghdr* message, int flags) {
  static auto* const system = systemCall<ssize_t(int, msghdr*, int)>("recvmsg");
  return fails(Call::Receive) ? -1 : system(fd, message, flags);
}

int poll(pollfd* fds, nfds_t count, int timeout) {
  static auto* const system = systemCall<int(pollfd*, nfds_t, int)>("poll");
  return fails(Call::Poll) ? -1 : system(fds, count, timeout);
}

int epoll_ctl(int epoll, int operation, int fd, epoll_event* event) noexcept {
  static auto* const system = systemCall<int(int, int, int, epoll_event*)>("epoll_ctl");
  // Only what is added needs memory of the system; what was added can always be changed or taken out.
  const bool may_fail = operation == EPOLL_CTL_ADD;
  return may_fail && fails(Call::EpollControl) ? -1 : system(epoll, operation, fd, event);
}

int setsockopt(int fd, int level, int name, const void* value, socklen_t size) noexcept {
  static auto* const system = systemCall<int(int, int, int, const void*, socklen_t)>("setsockopt");
  return fails(Call::SetOption) ? -1 : system(fd, level, name, value, size);
}
}
// NOLINTEND(readability-identifier-naming)
