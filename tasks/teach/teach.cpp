#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mrroc/conditions/digital_input.hpp>
#include <mrroc/ecp.hpp>
#include <mrroc/generators/lead_through.hpp>
#include <mrroc/generators/replay.hpp>
#include <mrroc/generators/teach_in.hpp>
#include <mrroc/generators/together.hpp>
#include <mrroc/generators/weight_measurement.hpp>
#include <mrroc/robots/irb6.hpp>
#include <mrroc/sensors/operator_input.hpp>

using namespace mrroc;

/// A folder of this run alone, also with other teaching runs on this machine; removed at its end.
struct OwnFolder {
  OwnFolder() {
    if (::mkdtemp(path.data()) == nullptr) throw SystemError(ErrorCode::resources, path + ": cannot be created");
  }
  ~OwnFolder() { std::filesystem::remove_all(path); }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  std::string path = std::filesystem::temp_directory_path() / "mrroc_teach_XXXXXX";
};

/// Teaches an arm twice: positions by jog, with distances from the operator; a path by leading the tool by its handle.
/// Both are saved, loaded and replayed.
class Teach : public ecp::Task {
  Irb6 arm{*this};
  OperatorInput axis{*this, "axis"};      // 1, 2, 3: along x, y, z of the tool; 4: turn about z; 0: store; -1: done
  OperatorInput amount{*this, "amount"};  // mm or degrees

  static constexpr int kLamp = 0, kButton = 0;  // terminals of the arm's controller
  const OwnFolder folder;

  /// Executes the operator's requests until the operator is done.
  TaughtPath jog() {
    TaughtPath places;
    for (int number = 1; number >= 0;) {
      number = static_cast<int>(ask(axis));
      if (number == 0) places.add(arm);
      if (number <= 0) continue;
      const double way = ask(amount);
      Pose target = arm.state().desired_pose;
      if (number <= 3)
        target.translate(0.001 * way * Eigen::Vector3d::Unit(number - 1));
      else
        target.rotate(Eigen::AngleAxisd(way * 0.0174533, Eigen::Vector3d::UnitZ()));
      Move({arm}, {}, JointLine{arm, target, 0.7});
    }
    return places;
  }

  /// Weighs the handle and its load, so that their weight does not lead the tool.
  Load weigh() {
    std::vector<JointVector> postures;
    for (const auto& [pitch, roll] : {std::pair{0.0, 0.0}, {0.5, 0.0}, {0.0, 0.6}, {-0.4, -0.5}}) {
      postures.push_back(arm.parameters().home);
      postures.back()[3] += pitch;
      postures.back()[4] += roll;
    }
    WeightMeasurement scale{arm, postures};
    Move({arm}, {}, scale);
    const LoadEstimate found = scale.estimate();
    std::printf("the handle weighs %.3f kg, within %.3f\n", found.load.mass, 3 * found.mass_deviation);
    return found.load;
  }

  void set_lamp(bool on) {
    ControllerIo outputs;
    outputs.set(kLamp, on);
    arm.set_outputs(outputs);
  }

  /// Records the led motion, from the lamp to the button.
  TaughtPath lead(const Guidance& guidance) {
    TaughtPath way;
    set_lamp(true);
    Move({arm}, {}, Together{LeadThrough{arm, guidance}, TeachIn{arm, way, 0.1}}.until(DigitalInput{arm, kButton}));
    set_lamp(false);
    return way;
  }

  void run() override {
    arm.set_tool(Pose(Eigen::Translation3d(0.25, 0, 0.25)));  // the handle
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
    save(jog(), arm, folder.path + "/teach_places.csv");

    Guidance guidance;
    guidance.damping = 100;
    guidance.angular_damping = 5;
    guidance.load = weigh();
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
    Move({arm}, {}, Hold{arm, 0.5});
    save(lead(guidance), arm, folder.path + "/teach_way.csv");

    Move({arm}, {}, Replay{arm, load_taught_path(folder.path + "/teach_places.csv", arm), 0.8});
    Replay way{arm, load_taught_path(folder.path + "/teach_way.csv", arm)};
    Move({arm}, {}, way);
    std::printf("replayed at %.2f of the taught speed\n", way.rate());
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(Teach)
