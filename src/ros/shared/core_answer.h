// What the core answers to a service: waited for on the thread of such services, and put into the response.
#pragma once

#include <chrono>
#include <cstdint>
#include <future>
#include <optional>
#include <string>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {

/// Far more than a core, and a controller, take that work. Meanwhile no other service of that thread is
/// served.
inline constexpr std::chrono::milliseconds kCorePatience(500);
inline constexpr const char* kCoreClosed = "the command layer is shutting down";
inline constexpr const char* kCoreBusy = "the command layer is busy and has not answered yet: call again";

/// Nothing: it has not arrived, and `why` gives the reason: `busy` if it takes longer than `patience`,
/// `closed` if there will be none.
template <class Answer>
[[nodiscard]] std::optional<Answer> answerOf(std::optional<std::future<Answer>> asked, std::string& why,
                                             const char* busy = kCoreBusy,
                                             std::chrono::milliseconds patience = kCorePatience,
                                             const char* closed = kCoreClosed) {
  try {
    if (asked && asked->wait_for(patience) == std::future_status::ready) return asked->get();
    why = asked ? busy : closed;
  } catch (const std::future_error&) {  // it was closed before it came to it
    why = closed;
  }
  return std::nullopt;
}

/// What all services have whose answers have it.
template <class Response, class Answer>
void fill(Response& response, const Answer& answer) {
  response.success = static_cast<std::uint8_t>(answer.success);
  response.error_id = answer.error_id;
  response.message = forPeople(answer.message);
}

}  // namespace cobot_command::ros_adapter
