#include "tables/table_services.h"

#include <chrono>
#include <utility>

#include "tables/table_messages.h"
#include <fmt/format.h>

#include "cobot_command/ReadFrame.h"
#include "cobot_command/ReadLoad.h"
#include "cobot_command/ReadTool.h"
#include "cobot_command/WriteFrame.h"
#include "cobot_command/WriteLoad.h"
#include "cobot_command/WriteTool.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

/// Far more than a disk takes that works. Meanwhile no other service of tables is served.
constexpr std::chrono::milliseconds kPatience(500);

struct OfTools {
  using Read = cobot_command::ReadTool;
  using Write = cobot_command::WriteTool;
  static constexpr tables::Kind kKind = tables::Kind::Tool;
  static const auto& table(const tables::DataTables& all) { return all.entries().tools; }
  static auto& data(Read::Response& response) { return response.tool; }
  static const auto& data(const Write::Request& request) { return request.tool; }
};

struct OfFrames {
  using Read = cobot_command::ReadFrame;
  using Write = cobot_command::WriteFrame;
  static constexpr tables::Kind kKind = tables::Kind::Frame;
  static const auto& table(const tables::DataTables& all) { return all.entries().frames; }
  static auto& data(Read::Response& response) { return response.frame; }
  static const auto& data(const Write::Request& request) { return request.frame; }
};

struct OfLoads {
  using Read = cobot_command::ReadLoad;
  using Write = cobot_command::WriteLoad;
  static constexpr tables::Kind kKind = tables::Kind::Load;
  static const auto& table(const tables::DataTables& all) { return all.entries().loads; }
  static auto& data(Read::Response& response) { return response.load; }
  static const auto& data(const Write::Request& request) { return request.load; }
};

template <class Response>
void fill(Response& response, const tables::Refusal& refusal) {
  response.error_id = refusal.error_id;
  response.message = forPeople(describe(refusal));
}

int indexError(tables::Kind kind) {
  return kind == tables::Kind::Tool    ? tables::table_error::kToolIndex
         : kind == tables::Kind::Frame ? tables::table_error::kFrameIndex
                                       : tables::table_error::kLoadIndex;
}

}  // namespace

TableServices::TableServices(const ros::NodeHandle& node, const tables::DataTables& tables,
                             TableWriter::Core core, TableWriter::Keep keep)
    : board_(tables), writer_(tables, std::move(core), std::move(keep)) {
  topic_ = OwnHandle(node).advertise<cobot_command::DataTables>("data_tables", 1, true);
  topic_.publish(toMessage(tables, ros::Time()));
  serve<OfTools>(node);
  serve<OfFrames>(node);
  serve<OfLoads>(node);
}

template <class Of>
void TableServices::serve(OwnHandle node) {
  const std::string kind(toString(Of::kKind));
  services_.push_back(node.advertiseService("read_" + kind, &TableServices::read<Of>, this));
  services_.push_back(node.advertiseService("write_" + kind, &TableServices::write<Of>, this));
}

void TableServices::take(const tables::DataTables& tables) {
  // The core's thread and that of the services may tell of one change both: the first one does.
  const std::lock_guard<std::mutex> lock(telling_);
  const ros::Time now = ros::Time::now();
  if (!board_.take(tables, now)) return;
  topic_.publish(toMessage(tables, now));
  writer_.keep(tables);
}

template <class Of>
bool TableServices::read(typename Of::Read::Request& request, typename Of::Read::Response& response) {
  if (!tables::isIndex(request.index)) {
    fill(response,
         tables::Refusal{indexError(Of::kKind), Of::kKind, request.index, "there is no such number",
                         fmt::format("0 to {}", tables::kEntryCount - 1), "Give a number of that range"});
    return true;
  }
  response.success = true;
  Of::data(response) =
      toMessage(request.index, Of::table(board_.tables())[static_cast<std::size_t>(request.index)]);
  response.stamp = board_.changeOf(Of::kKind, request.index);
  response.data_changed = board_.hasChangedSinceRead(Of::kKind, request.index);
  return true;
}

command::TableAnswer TableServices::written(const command::TableWrite& write) {
  auto answer = writer_.write(write);
  if (answer.wait_for(kPatience) == std::future_status::ready) return answer.get();
  return refuse(
      tables::Refusal{tables::table_error::kNotKept, static_cast<tables::Kind>(write.entry.index()),
                      write.index, fmt::format("its file was not written within {} ms", kPatience.count()),
                      "a disk that responds in time", "It can still be written later: read it again"});
}

template <class Of>
bool TableServices::write(typename Of::Write::Request& request, typename Of::Write::Response& response) {
  const auto write = toWrite(Of::data(request));
  if (!write) {
    fill(response, write.error());
    return true;
  }
  const auto answer = written(*write);
  if (!answer) {
    fill(response, answer.error());
    return true;
  }
  take(answer->tables);
  response.success = true;
  response.data_changed = answer->changed;
  response.stamp = board_.changeOf(Of::kKind, write->index);
  return true;
}

}  // namespace cobot_command::ros_adapter
