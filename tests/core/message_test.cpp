#include "mrroc/message.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cstring>

#include "mrroc/errors.hpp"

namespace mrroc {
namespace {

struct Everything {
  double number = 0;
  float small = 0;
  int integer = 0;
  std::uint8_t byte = 0;
  Tick tick = 0;
  bool truth = false;
  FixedText<7> text;
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  Wrench wrench = Wrench::Zero();
  JointVector joints;
  Pose pose = Pose::Identity();
};
MRROC_MESSAGE(Everything, number, small, integer, byte, tick, truth, text, vector, wrench, joints, pose)

struct Nothing {};
MRROC_MESSAGE(Nothing)

struct Sixteen {
  bool a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p;
};
MRROC_MESSAGE(Sixteen, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p)

// a later version of the header
namespace later {
struct Nothing {
  int something = 0;
};
MRROC_MESSAGE(Nothing, something)
}  // namespace later

double any_double() {
  return std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());  // NaN and infinity too
}

template <class Matrix>
bool same_bits(const Matrix& a, const Matrix& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

TEST(Message, RoundTrips) {
  EXPECT_TRUE(rc::check([] {
    Everything sent;
    sent.number = any_double();
    sent.small = *rc::gen::arbitrary<float>();
    sent.integer = *rc::gen::arbitrary<int>();
    sent.byte = *rc::gen::arbitrary<std::uint8_t>();
    sent.tick = *rc::gen::arbitrary<Tick>();
    sent.truth = *rc::gen::arbitrary<bool>();
    sent.text.assign(*rc::gen::string<std::string>());
    for (double& value : sent.vector) value = any_double();
    for (double& value : sent.wrench) value = any_double();
    sent.joints.resize(*rc::gen::inRange(0, kMaxJoints + 1));
    for (double& value : sent.joints) value = any_double();
    for (int i = 0; i < 12; ++i) sent.pose.affine().data()[i] = any_double();
    const Everything got = unpack<Everything>(pack(sent));
    RC_ASSERT(std::memcmp(&got.number, &sent.number, sizeof(double)) == 0);
    RC_ASSERT(std::memcmp(&got.small, &sent.small, sizeof(float)) == 0);
    RC_ASSERT(got.integer == sent.integer);
    RC_ASSERT(got.byte == sent.byte);
    RC_ASSERT(got.tick == sent.tick);
    RC_ASSERT(got.truth == sent.truth);
    RC_ASSERT(got.text == sent.text);
    RC_ASSERT(same_bits(got.vector, sent.vector));
    RC_ASSERT(same_bits(got.wrench, sent.wrench));
    RC_ASSERT(same_bits(got.joints, sent.joints));
    RC_ASSERT(
        same_bits(Eigen::Matrix<double, 3, 4>(got.pose.affine()), Eigen::Matrix<double, 3, 4>(sent.pose.affine())));
  }));
}

TEST(Message, SchemaDescribesItsFields) {
  const MessageSchema schema = schema_of<Everything>();
  EXPECT_EQ(schema.label, "Everything");
  ASSERT_EQ(schema.fields.size(), 11U);
  EXPECT_EQ(schema.fields[0], (MessageFieldEntry{"number", FieldKind::number, 8}));
  EXPECT_EQ(schema.fields[6], (MessageFieldEntry{"text", FieldKind::text, 8}));
  EXPECT_EQ(schema.fields[8], (MessageFieldEntry{"wrench", FieldKind::vector, 48}));
  EXPECT_EQ(schema.fields[10], (MessageFieldEntry{"pose", FieldKind::pose, 96}));
  EXPECT_EQ(schema.fingerprint(), pack(Everything{}).fingerprint);
  EXPECT_EQ(schema_of<Sixteen>().fields.size(), 16U);
  EXPECT_EQ(schema_of<Sixteen>().fields.back().name, "p");
  EXPECT_EQ(pack(Nothing{}).size, 0);
}

TEST(Message, RefusesAnotherTypeWithTheExpectedOne) {
  try {
    unpack<later::Nothing>(pack(Nothing{}));
    FAIL() << "taken";
  } catch (const NonFatalError& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_NE(
        text.find("a message 'Nothing' of 0 bytes came where 'Nothing' was expected: something (integer); the two "
                  "programs were built with different versions of it"),
        std::string::npos)
        << text;
  }
  EXPECT_THROW(unpack<Everything>(pack(Nothing{})), NonFatalError);
}

}  // namespace
}  // namespace mrroc
