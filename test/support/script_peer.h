// A robot of the least kind: it takes every script at once, tells when, and can flood both ports with frames.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "event_log.h"
#include "status_frames.h"
#include <boost/asio/io_context.hpp>
#include <gtest/gtest.h>

#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/runtime/simulation/simulator_runtime.h"
#include "cobot_command/script/script_command.h"
#include "cobot_command/transport/tcp_server.h"

namespace cobot_command::runtime {

inline constexpr const char* kStop = "StopAndClearBuffer";

/// A script that came, and when its last byte was read.
struct HeardScript {
  std::chrono::steady_clock::time_point time;
  std::string text;
};

class ScriptPeer {
 public:
  ScriptPeer()
      : script_(context_, {[this](auto client) { greet(client); },
                           [this](auto client, auto bytes) { hear(client, bytes); },
                           [this](auto client, const auto&) { decoders_.erase(client); }}),
        status_(context_,
                {[this](auto client) { stream(client); }, [](auto, auto) {}, [](auto, const auto&) {}}) {
    ports_ = {serve(script_), serve(status_)};
    thread_ = std::thread([this] { run(); });
  }
  ~ScriptPeer() {
    ended_ = true;
    thread_.join();
  }
  ScriptPeer(const ScriptPeer&) = delete;
  ScriptPeer& operator=(const ScriptPeer&) = delete;

  [[nodiscard]] SimulatorPorts ports() const { return ports_; }
  /// From now on both ports send without end; true when the other side has been sent a good deal already.
  [[nodiscard]] bool floods() {
    const auto before = floods_seen_.events().size();
    floods_ = true;
    return floods_seen_.waitUntil([&](const auto& seen) { return seen.size() > before; });
  }
  void endFlood() { floods_ = false; }
  /// From now on scripts that hold `text` get no answer before letAnswersGo().
  void holdAnswersTo(std::string text) {
    const std::lock_guard<std::mutex> lock(answering_);
    held_text_ = std::move(text);
  }
  void letAnswersGo() { holdAnswersTo({}); }
  /// From now on each script is answered so late.
  void answerAfter(std::chrono::steady_clock::duration delay) {
    const std::lock_guard<std::mutex> lock(answering_);
    delay_ = delay;
  }
  /// Whether a script that holds `text` came by now.
  [[nodiscard]] bool hasHeard(const std::string& text) const {
    const auto scripts = heard_.events();
    return std::any_of(scripts.begin(), scripts.end(),
                       [&](const HeardScript& one) { return one.text.find(text) != std::string::npos; });
  }
  /// When the n-th script that holds `text` came, from 0; waits for it.
  [[nodiscard]] std::optional<std::chrono::steady_clock::time_point> timeOf(const std::string& text,
                                                                            std::size_t n) {
    std::optional<std::chrono::steady_clock::time_point> time;
    EXPECT_TRUE(heard_.waitUntil([&](const std::vector<HeardScript>& scripts) {
      std::size_t seen = 0;
      for (const auto& script : scripts) {
        if (script.text.find(text) != std::string::npos && seen++ == n) {
          time = script.time;
        }
      }
      return time.has_value();
    })) << text
        << " was not sent";
    return time;
  }

 private:
  static constexpr std::size_t kBacklog = std::size_t{128} * 1024;
  static constexpr std::size_t kFlood = std::size_t{512} * 1024;
  static constexpr auto kStreamPeriod = std::chrono::milliseconds(15);

  static int serve(transport::TcpServer& server) {
    const auto port = server.bind("127.0.0.1", 0);
    EXPECT_TRUE(port.has_value());
    EXPECT_TRUE(server.open().has_value());
    return port.value_or(0);
  }

  void run() {
    while (!ended_) {
      if (floods_) {
        flood();
        context_.poll();
      } else {
        context_.run_one_for(answers_.empty() ? kStreamPeriod : kLookPeriod);
        streamInTime();
        answerInTime();
      }
      context_.restart();
    }
  }
  /// As much as the other side takes.
  void flood() {
    static const std::string kNoise = protocol::encode(protocol::ListenData{90, std::string(40, 'x')});
    for (int i = 0; i < 100; ++i) {
      for (const auto& [client, decoder] : decoders_) {
        if (script_.backlog() < kBacklog) {
          script_.send(client, kNoise);
          flooded_ += kNoise.size();
        }
      }
      if (watcher_ && status_.backlog() < kBacklog) {
        stream(*watcher_);
      }
    }
    if (flooded_ >= kFlood) {
      flooded_ = 0;
      floods_seen_.add(0);
    }
  }
  void streamInTime() {
    const auto now = std::chrono::steady_clock::now();
    if (watcher_ && now >= next_stream_) {
      next_stream_ = now + kStreamPeriod;
      stream(*watcher_);
    }
  }

  void greet(transport::ClientId client) {
    decoders_[client];
    script_.send(client, protocol::encode(protocol::ListenNodeEntered{"Listen1"}));
  }
  void stream(transport::ClientId client) {
    static const std::string kFrame =
        protocol::encode(protocol::StatusFrame{"0", 1, protocol::encodeBinaryItems(testing::StatusFrames())});
    watcher_ = client;
    status_.send(client, kFrame);
  }
  void hear(transport::ClientId client, std::string_view bytes) {
    auto& decoder = decoders_[client];
    decoder.feed(bytes);
    while (const auto event = decoder.next()) {
      const auto message = protocol::parseClientMessage(std::get<protocol::Frame>(*event));
      if (!message) continue;
      if (const auto* const script = std::get_if<protocol::ScriptRequest>(&*message)) {
        heard_.add({std::chrono::steady_clock::now(), script->script});
        answers_.push_back({client, script->id, script->script, std::chrono::steady_clock::now()});
        answerInTime();
      } else if (std::holds_alternative<protocol::ListenNodeQuery>(*message)) {
        script_.send(client, protocol::encode(protocol::ListenNodeState{true, "Listen1"}));
      }
    }
  }

  /// In the order in which they came.
  void answerInTime() {
    const std::lock_guard<std::mutex> lock(answering_);
    const auto now = std::chrono::steady_clock::now();
    const auto is_due = [&](const Answer& answer) {
      const bool is_held = !held_text_.empty() && answer.script.find(held_text_) != std::string::npos;
      return !is_held && now >= answer.came + delay_;
    };
    for (auto answer = answers_.begin(); answer != answers_.end();) {
      if (!is_due(*answer)) {
        ++answer;
        continue;
      }
      script_.send(answer->client, protocol::encode(protocol::ScriptReply{answer->id, true, {}}));
      answer = answers_.erase(answer);
    }
  }

  struct Answer {
    transport::ClientId client;
    std::string id;
    std::string script;
    std::chrono::steady_clock::time_point came;
  };
  static constexpr auto kLookPeriod = std::chrono::milliseconds(1);

  boost::asio::io_context context_;
  transport::TcpServer script_;
  transport::TcpServer status_;
  std::map<transport::ClientId, protocol::FrameDecoder> decoders_;
  std::optional<transport::ClientId> watcher_;
  std::chrono::steady_clock::time_point next_stream_;
  SimulatorPorts ports_;
  testing::EventLog<HeardScript> heard_;
  std::deque<Answer> answers_;  ///< that are not out yet; of the peer's thread
  std::mutex answering_;        ///< guards the next two
  std::string held_text_;
  std::chrono::steady_clock::duration delay_{};
  std::atomic<bool> ended_{false};
  std::atomic<bool> floods_{false};
  std::size_t flooded_ = 0;             ///< bytes to the script port
  testing::EventLog<int> floods_seen_;  ///< each kFlood of them
  std::thread thread_;
};

}  // namespace cobot_command::runtime
