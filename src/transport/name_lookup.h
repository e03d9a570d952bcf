// Resolves a host name without ever making anybody wait for the name server.
//
// The system's resolver cannot be interrupted, and Asio's own asynchronous resolver joins its thread when the
// io_context is destroyed: a silent name server would hold up the end of the program for many seconds. Here
// the question runs on a thread of its own that is let go when nobody wants the answer any more.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <boost/asio/ip/tcp.hpp>

namespace cobot_command::transport {

class NameLookup {
 public:
  using Endpoints = std::vector<boost::asio::ip::tcp::endpoint>;
  using Done = std::function<void(const boost::system::error_code&, const Endpoints&)>;

  /// `done` is called once, from the running io_context, unless the lookup is destroyed before. An address
  /// in numbers needs no resolver and no thread.
  NameLookup(boost::asio::io_context& context, const std::string& host, std::uint16_t port, Done done);
  ~NameLookup();
  NameLookup(const NameLookup&) = delete;
  NameLookup& operator=(const NameLookup&) = delete;

 private:
  struct Question;
  std::shared_ptr<Question> question_;
};

}  // namespace cobot_command::transport
