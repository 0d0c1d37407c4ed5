#include "cooperative_transfer/report/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "cli/trace/reader.hpp"
#include "cooperative_transfer/transfer_path.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/cooperation/object_path.hpp"

namespace mrroc::transfer {

namespace {

constexpr double kServoPeriod = 0.002;                            // s, the deployment's
constexpr double kToolMass = 2.04;                                // kg, of gripper and adapter by their MJCF
constexpr std::array<double, 2> kToolCentre{0.002157, 0.002059};  // m, x and y, in the wrist's frame

template <class Entry>
const Entry& entry_of(const std::vector<Entry>& entries, const std::string& name) {
  for (const Entry& entry : entries)
    if (entry.name == name) return entry;
  throw std::runtime_error("a step without " + name);
}

Pose pose_of(const cli::trace::Numbers& v) {
  if (v.size() < 7) throw std::runtime_error("a step without a pose");
  Pose pose = Pose::Identity();
  pose.translation() << v[0], v[1], v[2];
  pose.linear() = Eigen::Quaterniond(v[3], v[4], v[5], v[6]).toRotationMatrix();
  return pose;
}

/// The bar's wrench on an arm's grip, in the world's axes (those of both bases), without the tool's weight.
Wrench wrench_of(const cli::trace::Line& line, const std::string& arm, const Arms& arms) {
  const Eigen::Matrix3d axes = pose_of(entry_of(line.robots, arm).pose).linear();
  const Eigen::Vector3d weight(0, 0, -9.81 * kToolMass);
  const Eigen::Vector3d centre(kToolCentre[0], kToolCentre[1], arms.tool_centre - arms.grip);
  const cli::trace::Numbers& v = entry_of(line.sensors, arm + "_wrist").values;
  if (v.size() != 6) throw std::runtime_error("a step without a wrench");
  const Eigen::Vector3d force(v[0], v[1], v[2]), torque(v[3], v[4], v[5]);
  Wrench wrench;
  wrench << axes * force - weight,
      axes * (torque - arms.grip * Eigen::Vector3d::UnitZ().cross(force)) - (axes * centre).cross(weight);
  return wrench;
}

double angle(const Pose& a, const Pose& b) { return rotation_vector(a.linear().transpose() * b.linear()).norm(); }

template <class Value>
double worst(const std::vector<ReportStep>& steps, Value&& value) {
  double most = 0;
  for (const ReportStep& step : steps) most = std::max(most, value(step));
  return most;
}

}  // namespace

Report read_report(const std::filesystem::path& trace, const Arms& arms) {
  struct Part {
    std::vector<Pose> poses;
    const CooperativeLimits* limits;
  };
  const std::vector<Part> parts{
      {way::lift(), &kNear}, {way::carry(arms), &kFree}, {way::lower(), &kNear}, {way::put_down(), &kTouch}};
  Report report;
  cli::trace::Reader reader(trace);
  std::uint64_t last = 0;
  std::size_t moves = 0;  // cooperative ones
  std::optional<ObjectPath> path;
  Tick begin = 0, first = 0;
  Pose held = Pose::Identity();
  for (auto item = reader.next(); !std::holds_alternative<std::monostate>(item); item = reader.next()) {
    const auto* const line = std::get_if<cli::trace::Line>(&item);
    if (line == nullptr || line->process != "mp") continue;
    report.skew = std::max(report.skew, line->skew.value_or(0));
    if (!line->is_move || line->name != "CooperativeMotion") continue;
    const cli::trace::SensorEntry& tracker = entry_of(line->sensors, "tracker");
    const Tick tick = tracker.tick;
    if (line->instruction != last) {
      last = line->instruction;
      ++moves;
      path.reset();
      if (moves < 2 || moves - 2 >= parts.size()) continue;  // the first one holds the bar where it is
      path.emplace(parts[moves - 2].poses, *parts[moves - 2].limits);
      const auto& command = line->robots.at(0).command;
      if (!command || command->start_tick == 0) throw std::runtime_error("a motion without a start");
      begin = command->start_tick;
      if (moves == 2) {
        first = begin;
        held = parts[0].poses.front().inverse() * pose_of(tracker.values);
      }
    }
    if (!path) continue;
    report.complete = moves == 1 + parts.size() && line->ends();
    const double time = (static_cast<double>(tick) - static_cast<double>(begin)) * kServoPeriod;
    const Pose there = path->at(time), bar = pose_of(tracker.values);
    const Pose wanted = there * held;
    ReportStep step;
    step.tick = tick;
    step.time = (static_cast<double>(tick) - static_cast<double>(first)) * kServoPeriod;
    if (moves < parts.size() + 1) {  // not while it is put down: the stands stop it
      step.way = (bar.translation() - wanted.translation()).norm();
      step.turn = angle(bar, wanted);
      step.way_off = (bar.translation() - there.translation()).norm();
      step.turn_off = angle(bar, there);
    }
    const Wrench left = wrench_of(*line, "left", arms), right = wrench_of(*line, "right", arms);
    step.internal = bar.linear().transpose() * (left - right).head<3>() / 2;
    step.internal_torque = bar.linear().transpose() * (left - right).tail<3>() / 2;
    step.weight = -left.z() - right.z();
    report.steps.push_back(step);
  }
  if (report.steps.empty()) throw std::runtime_error(trace.string() + ": no bar is carried");
  return report;
}

double Report::worst_way() const {
  return worst(steps, [](const ReportStep& s) { return s.way; });
}
double Report::worst_turn() const {
  return worst(steps, [](const ReportStep& s) { return s.turn; });
}
double Report::worst_way_off() const {
  return worst(steps, [](const ReportStep& s) { return s.way_off; });
}
double Report::worst_turn_off() const {
  return worst(steps, [](const ReportStep& s) { return s.turn_off; });
}
double Report::worst_internal() const {
  return worst(steps, [](const ReportStep& s) { return s.internal.norm(); });
}
double Report::worst_internal_torque() const {
  return worst(steps, [](const ReportStep& s) { return s.internal_torque.norm(); });
}
double Report::rms_internal() const {
  double sum = 0;
  for (const ReportStep& step : steps) sum += step.internal.squaredNorm();
  return std::sqrt(sum / static_cast<double>(steps.size()));
}

}  // namespace mrroc::transfer
