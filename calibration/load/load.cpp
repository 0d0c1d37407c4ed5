#include <algorithm>
#include <cstdio>
#include <map>
#include <mrroc/ecp.hpp>
#include <mrroc/sensors/force_torque.hpp>

#include "calibration/common/any_robot.hpp"
#include "calibration/common/report.hpp"
#include "calibration/load/calibrate_load.hpp"
#include "calibration/load_fit.hpp"
#include "calibration/postures.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::calibration {
namespace {

constexpr double kSettling = 0.6;   // s of rest before a reading
constexpr double kMeasuring = 0.5;  // s over which it is averaged

/// Identifies the load behind a wrist sensor, and the sensor's zero, from its readings in several orientations.
class LoadCalibration : public ecp::Task {
  AnyRobot arm{*this};
  std::map<std::string, ForceTorque> sensors;

  /// What the deployment already takes out of the reading: added again, so that the whole load is found.
  struct Deployed {
    Load tool;
    Wrench zero = Wrench::Zero();
    Eigen::Matrix3d mount = Eigen::Matrix3d::Identity();  ///< of the sensor frame in the flange frame
    Eigen::Vector3d gravity = standard_gravity();
  };

  Deployed deployed(const std::string& sensor) const {
    const config::SensorEntry& entry = process().deployment().sensor(sensor);
    Deployed known;
    const auto vector = [&entry](const char* key) { return Eigen::Vector3d(entry.numbers.at(key).data()); };
    known.tool = {entry.numbers.at("tool_mass").front(), vector("tool_centre")};
    known.zero = Eigen::Map<const Wrench>(entry.numbers.at("zero").data());
    known.mount = pose_from_rpy(Eigen::Vector3d::Zero(), vector("rotation")).linear();
    known.gravity = vector("gravity");
    return known;
  }

  ForceTorque& sensor(const std::string& name) {
    const auto found = sensors.find(name);
    if (found == sensors.end())
      throw NonFatalError(ErrorCode::invalid_argument, "CalibrateLoad: sensor '" + name +
                                                           "' is no force_torque sensor of robot '" + arm.name() + "'");
    return found->second;
  }

  /// The mean of the readings at rest.
  Wrench measure(ForceTorque& wrist) {
    Move({arm}, {}, Hold{arm, kSettling});
    Wrench sum = Wrench::Zero();
    int count = 0;
    Move({arm}, {wrist}, Hold{arm, kMeasuring}.until(When{"never", [&] {
                                                            if (wrist.fresh()) {
                                                              sum += wrist.wrench();
                                                              ++count;
                                                            }
                                                            return false;
                                                          }}));
    if (count == 0) throw NonFatalError("sensor '" + wrist.name() + "' has given no reading in 0.5 s");
    return sum / count;
  }

  void calibrate(const CalibrateLoad& order) {
    ForceTorque& wrist = sensor(std::string(order.sensor.view()));
    const Deployed known = deployed(wrist.name());
    Move({arm}, {}, Hold{arm, 0.1});
    const JointVector start = arm.state().desired_joints;
    std::vector<WrenchReading> readings;
    for (const JointVector& posture : gravity_postures(*arm.models().front(), {start, order.reach},
                                                       static_cast<std::size_t>(std::max(order.postures, 0)))) {
      Move({arm}, {}, JointLine{arm, posture, order.speed});
      WrenchReading reading;
      reading.wrench = measure(wrist);
      reading.rotation = arm.state().pose.linear() * arm.state().tool.linear().transpose() * known.mount;
      reading.wrench += known.zero + weight_of(known.tool, reading.rotation, known.gravity);
      reading.time = static_cast<double>(tick()) * servo_period();
      readings.push_back(reading);
    }
    Move({arm}, {}, JointLine{arm, start, order.speed});
    report(order, wrist.name(), fit_load(readings, known.gravity));
  }

  void report(const CalibrateLoad& order, const std::string& sensor, const LoadFit& fit) const {
    for (std::size_t k = 0; k < fit.force_residuals.size(); ++k)
      std::printf("posture %2zu: residual %.3f N, %.4f N m\n", k + 1, fit.force_residuals[k], fit.torque_residuals[k]);
    const Eigen::Vector3d mm = 1000 * fit.load.centre;
    std::printf("mass %.4f kg +- %.4f\n", fit.load.mass, fit.mass_deviation);
    std::printf("centre (%.2f, %.2f, %.2f) mm +- %.2f, in the frame of %s\n", mm.x(), mm.y(), mm.z(),
                1000 * fit.centre_deviation, sensor.c_str());
    std::printf("zero (%.3f, %.3f, %.3f) N, (%.4f, %.4f, %.4f) N m\n", fit.zero[0], fit.zero[1], fit.zero[2],
                fit.zero[3], fit.zero[4], fit.zero[5]);
    const std::vector<Bound> bounds{
        {"force residual", "N", *std::max_element(fit.force_residuals.begin(), fit.force_residuals.end()),
         order.force_bound},
        {"torque residual", "N m", *std::max_element(fit.torque_residuals.begin(), fit.torque_residuals.end()),
         order.torque_bound},
        {"deviation of the mass", "kg", fit.mass_deviation, std::max(0.02 * fit.load.mass, 0.005)},
        {"deviation of the centre", "m", fit.centre_deviation, 0.003}};
    judge(bounds);
    write_calibration(std::string(order.into.view()), "load", "sensor '" + sensor + "' of robot '" + arm.name() + "'",
                      bounds,
                      "[sensors." + sensor + "]\ntool_mass = " + shown_number(std::max(fit.load.mass, 0.0)) +
                          "  # kg\ntool_centre = " + toml_list(fit.load.centre) +
                          "  # m, in the sensor frame\nzero = " + toml_list(fit.zero) + "  # N, N m\n");
  }

 public:
  LoadCalibration() {
    for (const config::SensorEntry* entry : sensors_on(process().deployment(), arm.name(), "force_torque"))
      sensors.try_emplace(entry->name, *this, entry->name);
    on<CalibrateLoad>([this](const CalibrateLoad& order) { calibrate(order); });
  }
};

}  // namespace
}  // namespace mrroc::calibration

MRROC_ECP(mrroc::calibration::LoadCalibration)
