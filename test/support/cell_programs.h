// The programs of the cells that the contract describes, without geometry.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cobot_command/cell/model/cell_program.h"

namespace cobot_command::test_support {

inline cell::ZoneStep book(std::vector<cell::ZoneIndex> zones) {
  return {true, std::move(zones), false};
}
inline cell::ZoneStep release(cell::ZoneIndex zone) {
  return {false, {zone}, false};
}

/// From HOME to another station and back.
inline cell::RobotProgram thereAndBack(std::string name, const std::string& station,
                                       std::vector<cell::ZoneStep> there, std::vector<cell::ZoneStep> back) {
  cell::RobotProgram robot;
  robot.name = std::move(name);
  robot.stations = {"HOME", station};
  robot.paths = {{station, 0, 1, std::move(there)}, {"HOME", 1, 0, std::move(back)}};
  return robot;
}

inline cell::CellProgram handover() {
  const auto robot = [](const char* name) { return thereAndBack(name, "T1", {book({0})}, {release(0)}); };
  return {"A1", {"Z"}, {robot("RA"), robot("RB")}};
}

inline cell::CellProgram headOn() {
  return {"A2a",
          {"Z1", "Z2"},
          {thereAndBack("RA", "W", {book({0}), book({1})}, {release(1), release(0)}),
           thereAndBack("RB", "W", {book({1}), book({0})}, {release(0), release(1)})}};
}

/// A robot, and a pallet that enters the zone by itself once it is let go.
inline cell::CellProgram pallet() {
  cell::CellProgram program{"A4",
                            {"Z"},
                            {thereAndBack("RA", "T1", {book({0})}, {release(0)}),
                             thereAndBack("PALLET", "IN", {book({0})}, {release(0)})}};
  program.robots[1].paths[0].steps[0].uncontrollable = true;
  return program;
}

/// A3 is that of three.
inline cell::CellProgram iris(std::size_t robots = 3) {
  cell::CellProgram program;
  program.name = "A3";
  for (std::size_t own = 0; own < robots; ++own) {
    const std::size_t next = (own + 1) % robots;
    program.zones.push_back("Z" + std::to_string(own + 1));
    program.robots.push_back(thereAndBack("R" + std::to_string(own + 1), "W", {book({own}), book({next})},
                                          {release(next), release(own)}));
  }
  return program;
}

}  // namespace cobot_command::test_support
