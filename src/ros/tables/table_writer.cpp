#include "tables/table_writer.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>

#include <ros/console.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/overloaded.h"
#include "cobot_command/tables/table_text.h"

namespace cobot_command::ros_adapter {
namespace {

using command::TableAnswer;
using command::TableWrite;
using tables::Refusal;

/// Far more than the core takes to come to it.
constexpr std::chrono::seconds kPatience(10);

tables::Kind kindOf(const TableWrite& write) {
  return static_cast<tables::Kind>(write.entry.index());
}
static_assert(static_cast<int>(tables::Kind::Tool) == 0 && static_cast<int>(tables::Kind::Frame) == 1 &&
              static_cast<int>(tables::Kind::Load) == 2);

Refusal notKept(const TableWrite& write, const std::string& why) {
  return {tables::table_error::kNotKept,
          kindOf(write),
          write.index,
          "it cannot be stored: " + foreignText(why),
          "a file that can be written",
          "Check ~tables_file: its folder, its permissions, the free space on its disk"};
}

Refusal closing(const TableWrite& write) {
  return {tables::table_error::kShutDown,
          kindOf(write),
          write.index,
          "the command layer is shutting down",
          "a write while the command layer runs",
          "Start the command layer again"};
}

}  // namespace

/// Outlives the object: a disk that hangs cannot be waited for.
class TableWriter::Desk {
 public:
  Desk(tables::DataTables tables, Core core, Keep keep)
      : kept_(std::move(tables)), core_(std::move(core)), keep_(std::move(keep)) {}

  std::future<TableAnswer> add(TableWrite write) {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_.emplace_back(Write{std::move(write), {}});
    changed_.notify_all();
    return std::get<Write>(jobs_.back()).answer.get_future();
  }

  void add(tables::DataTables changed) {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_.emplace_back(std::move(changed));
    changed_.notify_all();
  }

  void serve() {
    while (auto job = next()) {
      std::visit(Overloaded{[this](Write& write) { write.answer.set_value(answerTo(write.write)); },
                            [this](const tables::DataTables& changed) { keep(changed); }},
                 *job);
    }
  }

  /// The core is asked before this returns, or not at all. What it has changed last is kept still.
  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_open_ = false;
    std::optional<tables::DataTables> last;
    for (Job& job : jobs_) {
      if (auto* const write = std::get_if<Write>(&job)) {
        write->answer.set_value(refuse(closing(write->write)));
      } else {
        last = std::get<tables::DataTables>(job);
      }
    }
    jobs_.clear();
    if (last) jobs_.emplace_back(*std::move(last));
    changed_.notify_all();
  }

 private:
  struct Write {
    TableWrite write;
    std::promise<TableAnswer> answer;
  };
  using Job = std::variant<Write, tables::DataTables>;

  std::optional<Job> next() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return !is_open_ || !jobs_.empty(); });
    if (jobs_.empty()) return std::nullopt;
    std::optional<Job> job(std::move(jobs_.front()));
    jobs_.pop_front();
    return job;
  }

  TableAnswer answerTo(const TableWrite& write) {
    TableAnswer tried = ask(core_.tried, write);
    if (!tried || !tried->changed) return tried;
    if (const auto why_not = keep_(tried->tables)) return refuse(notKept(write, *why_not));
    TableAnswer written = ask(core_.written, write);
    if (written) {
      kept_ = tried->tables;
      keep(written->tables);  // something else may have changed meanwhile
    } else {
      // Somebody has begun to use it meanwhile: the file goes back to what rules.
      static_cast<void>(keep_(kept_));
    }
    return written;
  }

  void keep(const tables::DataTables& changed) {
    if (changed.revision() < kept_.revision()) return;
    const bool is_other = toFile(changed) != toFile(kept_);
    if (const auto why_not = is_other ? keep_(changed) : std::nullopt) {
      ROS_ERROR_STREAM(
          "the tables were changed, but the change is not in ~tables_file: " << forPeople(*why_not));
      return;
    }
    kept_ = changed;
  }

  TableAnswer ask(const Ask& core, const TableWrite& write) {
    std::optional<std::future<TableAnswer>> answer;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (is_open_) answer = core(write);
    }
    if (!answer || answer->wait_for(kPatience) != std::future_status::ready) return refuse(closing(write));
    try {
      return answer->get();
    } catch (const std::future_error&) {  // the core was closed before it came to it
      return refuse(closing(write));
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  bool is_open_ = true;
  tables::DataTables kept_;  ///< of the thread alone, as what follows
  const Core core_;
  const Keep keep_;
};

TableWriter::TableWriter(tables::DataTables tables, Core core, Keep keep)
    : desk_(std::make_shared<Desk>(std::move(tables), std::move(core), std::move(keep))) {
  std::thread([desk = desk_] { desk->serve(); }).detach();
}

TableWriter::~TableWriter() {
  close();
}

void TableWriter::close() {
  desk_->close();
}

void TableWriter::keep(tables::DataTables tables) {
  desk_->add(std::move(tables));
}

std::future<TableAnswer> TableWriter::write(TableWrite write) {
  return desk_->add(std::move(write));
}

}  // namespace cobot_command::ros_adapter
