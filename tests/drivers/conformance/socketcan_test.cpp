#include <atomic>
#include <optional>

#include "config/drives/drive_table.hpp"
#include "config/resources.hpp"
#include "config/text/file_text.hpp"
#include "drivers/socketcan/can_rig.hpp"
#include "mrroc/testing/driver.hpp"
#include "robots/polycrank/polycrank_model.hpp"

namespace mrroc::driver_test {
namespace {

constexpr int kGlances = 40;
constexpr std::uint32_t kLowestAnswer = 0x180;  // TPDO 1 of node 0: every set-point of the master is a later RPDO

/// CiA 402 drives of a Polycrank on a hub, and a CiA 401 node.
class Drives final : public StandIn {
 public:
  std::string keys() const override {
    return "interface = \"unix:" + path() + "\"\ndrives = \"" + patient_drives_.string() + "\"\nio = \"" +
           terminals_.string() + "\"";
  }
  void start(const JointVector&) override {
    stop();
    silent_ = loses_ = false;
    bus_.emplace([this](can::Frame& frame) { return passes(frame); });
    bus_name_ = bus_->name();
    std::filesystem::create_symlink(bus_name_.substr(5), path());
    rack_.emplace(table_, *model_, *bus_, true, edp::kCanPeriod, io_);
  }
  void stop() override {
    rack_.reset();
    bus_.reset();
    std::filesystem::remove(path());
  }
  /// Waits for the drives' cycle of the tick before: their time is that of the SYNC.
  void advance(Tick) override {
    const std::uint64_t before = std::exchange(cycles_, rack_->cycles());
    for (int i = 0; i < kGlances && rack_->cycles() == before; ++i) ::usleep(50);
  }
  JointVector shafts() override { return rack_->shafts(); }
  bool has(Trouble trouble) const override {
    return trouble == Trouble::silence || trouble == Trouble::loss || trouble == Trouble::drive_fault ||
           trouble == Trouble::restart || trouble == Trouble::no_power;
  }
  void set(Trouble trouble, bool on) override {
    if (trouble == Trouble::silence) silent_ = on;
    if (trouble == Trouble::loss) loses_ = on;
    const auto nodes_time = static_cast<std::int64_t>(rack_->cycles()) * std::llround(edp::kCanPeriod * 1e9);
    rack_->with([&](std::vector<sim::DriveNode>& nodes) {
      sim::DriveNode& node = nodes.front();
      if (trouble == Trouble::no_power) node.hold_back(on);
      if (trouble == Trouble::restart && on) node.boot(nodes_time);
      if (trouble == Trouble::drive_fault) {
        node.keep_fault(on);
        if (on) node.fail(0x7305);
      }
    });
  }

 private:
  std::string path() const { return (folder_.path() / "bus").string(); }
  /// The hub's thread. Frames of the drives are those of node ids: answers, heartbeats, errors.
  bool passes(const can::Frame& frame) {
    const std::uint32_t function = frame.id & 0x780;
    const bool of_drive = function == 0x080 ? (frame.id & 0x7f) != 0
                                            : function == 0x180 || function == 0x280 || function == 0x580 ||
                                                  (frame.id >= 0x701 && frame.id <= 0x707);
    if (!of_drive) return true;
    if (silent_) return false;
    return !(loses_ && function == kLowestAnswer && ++answers_ % 5 == 0);
  }

  task_test::ScratchFolder folder_;
  std::shared_ptr<const RobotModel> model_ = load_polycrank().front();
  /// The type's own table, but drives may answer as late as that goes: the machine may be busy.
  std::filesystem::path patient_drives_ = folder_.write(
      "drives.toml", "answer_time = 0.9\nmissed_max = 20\n" +
                         config::read_file(config::type_file("robots", "polycrank", "polycrank_drives.toml")));
  config::DriveTable table_ = config::read_drive_table(patient_drives_, model_->parameters());
  std::filesystem::path terminals_ =
      folder_.write("io.toml", "[[nodes]]\nnode = 40\neds = \"cia401.eds\"\ndigital_inputs = 8\ndigital_outputs = 8\n");
  config::IoTable io_ = config::read_io_table(terminals_, table_);
  std::atomic<bool> silent_{false}, loses_{false};
  int answers_ = 0;
  std::uint64_t cycles_ = 0;
  std::string bus_name_;
  std::optional<edp::TestBus> bus_;
  std::optional<edp::Rack> rack_;
};

}  // namespace
}  // namespace mrroc::driver_test

MRROC_DRIVER_TEST(mrroc::driver_test::Drives, mrroc::load_polycrank)
