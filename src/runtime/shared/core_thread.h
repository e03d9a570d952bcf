// The one thread that owns a core: an io_context, run until it is finished.
#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>

namespace cobot_command::runtime {

/// Thread-safe but for start(); destroy it after whatever lives on its context.
class CoreThread {
 public:
  using Task = std::function<void()>;

  CoreThread();
  ~CoreThread();
  CoreThread(const CoreThread&) = delete;
  CoreThread& operator=(const CoreThread&) = delete;

  [[nodiscard]] boost::asio::io_context& context() { return context_; }
  void start();

  /// Runs the task on the thread, after those posted before. False, and it never runs, once finish() has
  /// begun.
  bool post(Task task) { return post(std::move(task), tasks_); }
  /// The same, before all tasks that are not urgent, and wait.
  bool postUrgent(Task task) { return post(std::move(task), urgent_); }

  /// Runs `last` after all posted tasks, then ends the thread: nothing runs on it any more when this returns.
  /// Further calls only wait for that. Not from the thread itself.
  void finish(Task last);

 private:
  using Tasks = std::deque<Task>;
  bool post(Task task, Tasks& tasks);
  void runNext();

  boost::asio::io_context context_{1};  ///< run by one thread: what that posts to itself wakes nobody
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_;
  std::mutex posting_;
  Tasks tasks_;
  Tasks urgent_;
  bool open_ = true;
  std::mutex joining_;
  std::thread thread_;
};

}  // namespace cobot_command::runtime
