// A guide with a program of one frame, which is permitted at once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/programs/program_guide.h"

namespace cobot_command::testing {

class OneFrame final : public blocks::ProgramGuide {
 public:
  [[nodiscard]] std::optional<blocks::Failure> objectionTo(
      const blocks::ProgramRequest& /*request*/) const override {
    return unknown;
  }
  [[nodiscard]] std::optional<blocks::Failure> begin(const blocks::ProgramRequest& /*request*/,
                                                     Instant /*now*/) override {
    is_done_ = is_sent_ = false;
    return refusal;
  }
  [[nodiscard]] const blocks::ProgramFrame* permitted() const override {
    return is_sent_ || !is_permitted ? nullptr : &frame;
  }
  void sent(Instant /*now*/) override { is_sent_ = true; }
  void refused(Instant /*now*/) override { is_permitted = is_permitted && !ends_with_refusal; }
  void done(Instant /*now*/) override { is_done_ = true; }
  [[nodiscard]] bool isOver() const override { return is_done_; }
  [[nodiscard]] const std::optional<blocks::Failure>& failure() const override { return failed; }
  [[nodiscard]] bool stopsRobot() const override { return stops_robot; }
  void finish() override { is_done_ = true; }
  std::vector<Duration> end(Instant /*now*/) override {
    ++ends;
    return waited;
  }
  [[nodiscard]] blocks::ProgramStand stand(Instant /*now*/) const override {
    blocks::ProgramStand stand;
    stand.place = is_done_ ? "T1" : "HOME";
    stand.cycles_done = is_done_ ? 1 : 0;
    return stand;
  }
  [[nodiscard]] std::optional<Instant> nextDeadline() const override { return std::nullopt; }

  blocks::ProgramFrame frame{{"PTP(\"JPP\",0,0,90,0,90,0,30,200,0,false)"}, true, {}, {}, 0};
  bool is_permitted = true;
  bool ends_with_refusal = false;  ///< its permit was gone already when the gate looked
  bool stops_robot = false;
  std::optional<blocks::Failure> unknown;
  std::optional<blocks::Failure> refusal;
  std::optional<blocks::Failure> failed;
  int ends = 0;
  std::vector<Duration> waited;

 private:
  bool is_sent_ = false;
  bool is_done_ = false;
};

}  // namespace cobot_command::testing
