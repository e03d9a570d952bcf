#include "pvt/pvt_knots.h"

#include <algorithm>
#include <cmath>

#include "pvt/pvt_phases.h"

#include "cobot_command/common/units.h"
#include "cobot_command/motion/pvt_leads.h"

namespace cobot_command::path {
namespace {

/// As it is sent: five decimals of a degree.
double sentDegrees(double radians) {
  constexpr double kDecimals = 1e5;
  return std::round(radToDeg(radians) * kDecimals) / kDecimals;
}

arm::JointVector asSent(const arm::JointVector& joints) {
  return joints.unaryExpr([](double radians) { return degToRad(sentDegrees(radians)); });
}

arm::JointVector speedAt(const PlannedPoint& point, Duration time) {
  return point.motion->at(time - point.start).velocity;
}

/// Of the motion to one point, at the knots around and within it.
void addLeads(const PathPlan& plan, std::size_t own, std::vector<PvtKnot>& knots) {
  const PlannedPoint& point = plan.points()[own];
  if (point.motion->duration() == Duration::zero()) return;
  const auto is_before = [](const PvtKnot& knot, Duration time) { return knot.time < time; };
  const auto within = std::lower_bound(knots.begin(), knots.end(), point.start + Duration(1), is_before);
  const auto end = std::lower_bound(within, knots.end(), point.end(), is_before);
  std::vector<Duration> times;
  for (auto knot = within - 1; knot <= end; ++knot) times.push_back(knot->time - point.start);
  const std::vector<double> leads = motion::leadsAt(point.command, *point.motion, times);
  auto lead = leads.begin();
  for (auto knot = within; knot != end; ++knot) {
    (knot->begun == own ? knot->lead : knot->lead_before) = *++lead;
  }
}

}  // namespace

std::vector<PvtKnot> knotsOf(const PathPlan& plan, std::size_t first, std::size_t last, Duration segment) {
  std::vector<PvtKnot> knots{{plan.points()[first].start, first, first}};
  std::size_t begun = first;
  for (const PvtPhase& phase : phasesOf(plan, first, last, segment)) {
    for (const Duration time : segmentsOf(phase, segment)) {
      while (begun < last && plan.points()[begun + 1].start <= time) ++begun;
      knots.push_back({time, phase.point, begun});
    }
  }
  for (std::size_t point = first; point <= last; ++point) addLeads(plan, point, knots);
  return knots;
}

arm::JointVector leadAt(const PathPlan& plan, const PvtKnot& knot) {
  arm::JointVector ahead = arm::JointVector::Zero();
  const auto& points = plan.points();
  if (knot.lead != 0.0) ahead += knot.lead * speedAt(points[knot.begun], knot.time);
  if (knot.lead_before != 0.0) ahead += knot.lead_before * speedAt(points[knot.begun - 1], knot.time);
  return ahead;
}

motion::PvtJointPoint pvtPointAt(const PathPlan& plan, Duration before, const PvtKnot& knot) {
  const motion::JointState state = plan.at(knot.time);
  return {asSent(state.position + leadAt(plan, knot)), asSent(state.velocity), toSeconds(knot.time - before)};
}

}  // namespace cobot_command::path
