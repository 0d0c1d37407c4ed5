#include "links/ros2/ros_names.hpp"

#include <gtest/gtest.h>

namespace mrroc::ros2::ros_names_test {
namespace {

TEST(RosNames, OfTopicsAndServicesOnDds) {
  EXPECT_EQ(dds_topic("/joint_states"), "rt/joint_states");
  EXPECT_EQ(dds_request_topic("/mrroc_press/start"), "rq/mrroc_press/startRequest");
  EXPECT_EQ(dds_reply_topic("/mrroc_press/start"), "rr/mrroc_press/startReply");
}

TEST(RosNames, OfThePartsOfAnAction) { EXPECT_EQ(action_name("/arm/move", "status"), "/arm/move/_action/status"); }

TEST(RosNames, OfTypesOnDds) {
  EXPECT_EQ(dds_type("sensor_msgs/msg/JointState"), "sensor_msgs::msg::dds_::JointState_");
  EXPECT_EQ(dds_type("std_srvs/srv/Trigger_Request"), "std_srvs::srv::dds_::Trigger_Request_");
}

TEST(RosNames, AreMadeOfAnyText) {
  EXPECT_EQ(ros_name("press"), "press");
  EXPECT_EQ(ros_name("a b-c"), "a_b_c");
  EXPECT_EQ(ros_name("2arms"), "_2arms");
  EXPECT_EQ(ros_name(""), "_");
}

TEST(RosNames, InANamespace) {
  EXPECT_EQ(in_namespace("/", "arm"), "/arm");
  EXPECT_EQ(in_namespace("/lab", "arm"), "/lab/arm");
}

}  // namespace
}  // namespace mrroc::ros2::ros_names_test
