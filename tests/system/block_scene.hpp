#pragma once

namespace mrroc::test {

/// A block whose top is 40 mm below the tip of the arm at home.
inline constexpr const char* kBlockScene = R"(<mujoco>
  <compiler angle="radian"/>
  <worldbody>
    <geom name="floor" type="plane" size="4 4 0.1"/>
    <geom name="block" type="box" size="0.1 0.1 0.33" pos="0.75 0 0.33"/>
  </worldbody>
</mujoco>
)";

}  // namespace mrroc::test
