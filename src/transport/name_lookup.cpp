#include "name_lookup.h"

#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>

namespace cobot_command::transport {
namespace asio = boost::asio;
using boost::asio::ip::tcp;
using boost::system::error_code;

/// Shared by the asking side and the resolving thread; `context` is null once nobody asks any more.
struct NameLookup::Question : std::enable_shared_from_this<Question> {
  std::mutex mutex;
  asio::io_context* context = nullptr;
  Done done;

  void answer(const error_code& code, Endpoints endpoints) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (context == nullptr) {
      return;
    }
    asio::post(*context, [self = shared_from_this(), code, endpoints = std::move(endpoints)] {
      if (self->stillAsked()) {
        self->done(code, endpoints);
      }
    });
  }

  bool stillAsked() {
    const std::lock_guard<std::mutex> lock(mutex);
    return context != nullptr;
  }
};

namespace {

NameLookup::Endpoints resolve(const std::string& host, std::uint16_t port, error_code& code) {
  asio::io_context context;
  NameLookup::Endpoints endpoints;
  for (const auto& entry :
       tcp::resolver(context).resolve(host, std::to_string(port), tcp::resolver::numeric_service, code)) {
    endpoints.push_back(entry.endpoint());
  }
  return endpoints;
}

}  // namespace

NameLookup::NameLookup(asio::io_context& context, const std::string& host, std::uint16_t port, Done done)
    : question_(std::make_shared<Question>()) {
  question_->context = &context;
  question_->done = std::move(done);
  error_code not_numeric;
  const auto address = asio::ip::make_address(host, not_numeric);
  if (!not_numeric) {
    question_->answer({}, {tcp::endpoint(address, port)});
    return;
  }
  if (host.empty()) {  // the system would take it for this machine
    question_->answer(asio::error::host_not_found, {});
    return;
  }
  try {
    std::thread([question = question_, host, port] {
      error_code code;
      auto endpoints = resolve(host, port, code);
      question->answer(code, std::move(endpoints));
    }).detach();
  } catch (const std::system_error& no_thread) {
    question_->answer(error_code(no_thread.code().value(), boost::system::system_category()), {});
  }
}

NameLookup::~NameLookup() {
  const std::lock_guard<std::mutex> lock(question_->mutex);
  question_->context = nullptr;
}

}  // namespace cobot_command::transport
