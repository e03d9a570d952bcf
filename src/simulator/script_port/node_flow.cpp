#include "script_port/node_flow.h"

#include <array>

namespace cobot_command::simulator {

namespace {

struct Row {
  FlowState from;
  FlowEvent event;
  FlowState to;
};

constexpr std::array<Row, 7> kTable{{
    {FlowState::Stopped, FlowEvent::Run, FlowState::Listening},
    {FlowState::Listening, FlowEvent::Exit, FlowState::Leaving},
    {FlowState::Leaving, FlowEvent::Done, FlowState::Elsewhere},
    {FlowState::Elsewhere, FlowEvent::Reenter, FlowState::Listening},
    {FlowState::Listening, FlowEvent::Stop, FlowState::Stopped},
    {FlowState::Leaving, FlowEvent::Stop, FlowState::Stopped},
    {FlowState::Elsewhere, FlowEvent::Stop, FlowState::Stopped},
}};

}  // namespace

FlowState after(FlowState state, FlowEvent event) {
  for (const Row& row : kTable) {
    if (row.from == state && row.event == event) return row.to;
  }
  return state;
}

}  // namespace cobot_command::simulator
