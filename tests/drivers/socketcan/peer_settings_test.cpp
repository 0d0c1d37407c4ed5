// Settings that the driver writes at the start, read back from drives of python-canopen by a second participant of the
// bus.
#include "canopen/sdo_client.hpp"
#include "clock/wall/monotonic.hpp"
#include "peer_rig.hpp"

namespace mrroc::edp {
namespace {

using canopen::DriveMode;
using canopen::Object;

class PeerSettings : public testing::TestWithParam<DriveMode> {};

TEST_P(PeerSettings, DrivesHaveTheSettingsOfTheirTables) {
  const TwoSlides model;
  config::DriveTable table = table_for(model.parameters(), GetParam());
  table.absolute_encoders = true;
  table.heartbeat = kHeartbeat;
  constexpr Object kQuickStopDeceleration{0x6085};
  for (config::DriveEntry& drive : table.drives)
    drive.settings.push_back({kQuickStopDeceleration, "Quick stop deceleration", 700'000 + drive.node, 4});
  const TestBus bus;
  const Peer peer(bus.name());
  // no set-point is sent: the mode is that of the set-up
  CanHardware hardware(table, model.parameters(), kPeerPeriod, bus.opener(), kPeerTiming, true);
  hardware.open();

  const auto second = bus.open();
  canopen::SdoClient client(*second, clock::kSecond);
  for (const config::DriveEntry& drive : table.drives) {
    const auto number = [&](Object object, std::size_t size) {
      const std::vector<std::uint8_t> value = client.upload(drive.node, object);
      EXPECT_EQ(value.size(), size) << std::hex << object.index;
      return can::sign_extended(can::get(value, 0, value.size()), value.size());
    };
    EXPECT_EQ(number(kQuickStopDeceleration, 4), 700'000 + drive.node);
    EXPECT_EQ(number(canopen::kConsumerHeartbeat, 4), 127 << 16 | static_cast<int>(3000 * kHeartbeat));
    EXPECT_EQ(number(canopen::kProducerHeartbeat, 2), 1000 * kHeartbeat);
    EXPECT_EQ(number(canopen::kInterpolationTime, 1), 10) << "of 1 ms";
    EXPECT_EQ(number(canopen::kInterpolationExponent, 1), -3);
    EXPECT_EQ(number(canopen::kMode, 1), static_cast<int>(GetParam()));
  }
}

INSTANTIATE_TEST_SUITE_P(Can, PeerSettings, every_mode(), name_of_mode);

}  // namespace
}  // namespace mrroc::edp
