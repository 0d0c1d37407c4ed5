// Values of an EDS or DCF in the forms that CiA 306 allows and manufacturers write.
#include <gtest/gtest.h>

#include "canopen/default_value.hpp"
#include "canopen/eds_text.hpp"

namespace mrroc::canopen {
namespace {

TEST(EdsValues, DefaultMayContainTheNodeNumber) {
  const auto number = [](const std::string& text) {
    ObjectEntry entry;
    entry.default_value = text;
    entry.type = text.starts_with('-') ? DataType::integer16 : DataType::unsigned32;
    return default_number(entry, 5);
  };
  EXPECT_EQ(number("0x180"), 0x180);
  EXPECT_EQ(number("-5"), -5);
  EXPECT_EQ(number("$NODEID"), 5);
  EXPECT_EQ(number("$NODEID+0x180"), 0x185);
  EXPECT_EQ(number("$NODEID + 384"), 0x185);
  EXPECT_EQ(number("0x40000180+$NODEID"), 0x40000185);
  for (const char* const same :
       {"$NodeID + 0x380", "0x380+$NODEID", "$nodeid+896", "0X380 +\t$NodeId", "$NODEID+01600", "0x300+$NODEID+0x80",
        "0x400 - 0x80 + $NODEID", "+$NODEID+0x380", "$NODEID+0x380;comment"})
    EXPECT_EQ(number(same), 0x385) << same;
  EXPECT_FALSE(number(""));
  for (const char* const wrong : {"Servo", "0x180+", "$NODEID+$", "$NODEID 0x380", "$NODEID*2", "NODEID+1", "0x180h",
                                  "0180", "0x 380", "12 34", "1.5", "$NODEID+0xFFFFFFFF", "4294967296", "$NODE"})
    EXPECT_THROW(number(wrong), std::invalid_argument) << wrong;
}

/// The object 2000h of this type with a line, and its value as it is read.
ObjectEntry with_default(const std::string& type, const std::string& line) {
  return *parse("[2000]\nParameterName=Value\nDataType=" + type + "\nAccessType=rw\n" + line + "\n").find({0x2000, 0});
}

TEST(EdsValues, ReadsValuesOfEveryType) {
  const auto number = [](const std::string& type, const std::string& value) {
    return default_number(with_default(type, "DefaultValue=" + value), 5);
  };
  EXPECT_EQ(number("0x0002", "0xFF"), -1) << "the bits of an INTEGER8";
  EXPECT_EQ(number("0x0003", "-32768"), -32768);
  EXPECT_EQ(number("0x0004", "0xFFFFFF9C"), -100);
  EXPECT_EQ(number("0x0007", "-1"), 0xffffffff);
  EXPECT_EQ(number("0x001b", "0xFFFFFFFFFFFFFFFF"), -1) << "all bits of an UNSIGNED64";
  EXPECT_EQ(number("0x0001", "TRUE"), 1);
  EXPECT_EQ(number("0x0001", "0x0"), 0);
  EXPECT_EQ(number("0x0007", "\"0x180\""), 0x180);
  EXPECT_EQ(number("0x0007", "\"$NODEID+0x180\" ; of the drive"), 0x185);
  EXPECT_EQ(number("0x0007", " 0x180 ; of the drive"), 0x180);
  EXPECT_EQ(number("0x0007", "010"), 8);
  EXPECT_EQ(number("7", "; nothing"), std::nullopt);
  EXPECT_EQ(configured_number(with_default("7", "DefaultValue=1\nParameterValue=$NODEID+2"), 5), 7) << "of a DCF";
  EXPECT_EQ(default_number(with_default("7", "DefaultValue=1\nParameterValue=2"), 5), 1);
  const auto bytes = [](const std::string& type, const std::string& value) {
    return configured_bytes(with_default(type, "DefaultValue=" + value), 5);
  };
  using Bytes = std::vector<std::uint8_t>;
  EXPECT_EQ(bytes("0x0008", "1.5"), (Bytes{0, 0, 0xc0, 0x3f}));
  EXPECT_EQ(bytes("0x0008", "+15e-1"), (Bytes{0, 0, 0xc0, 0x3f}));
  EXPECT_EQ(bytes("0x0008", "0x00000000"), Bytes(4));
  EXPECT_EQ(bytes("0x0008", "0x437A0000"), (Bytes{0, 0, 0x7a, 0x43})) << "the bits of 250.0";
  EXPECT_EQ(bytes("0x0009", "a;b"), (Bytes{'a', ';', 'b'}));
  EXPECT_EQ(bytes("0x0009", "\"a ;b\" ; a name"), (Bytes{'a', ' ', ';', 'b'}));
  EXPECT_EQ(bytes("0x0009", "$NODEID"), (Bytes{'$', 'N', 'O', 'D', 'E', 'I', 'D'}));
  EXPECT_EQ(bytes("0x0005", "0x12"), Bytes{0x12});
  EXPECT_EQ(bytes("0x000f", "01 02"), Bytes{});
}

TEST(EdsValues, RefusesAnUnreadableValue) {
  const auto of = [](const std::string& type, const std::string& line) {
    return mistake("[2000]\nParameterName=Value\nDataType=" + type + "\nAccessType=rw\n" + line + "\n");
  };
  const std::string number = " bits such as 384, 0x180 or $NODEID+0x180";
  EXPECT_EQ(of("7", "DefaultValue=$NODE+0x380"),
            "drive.eds:5: 2000: DefaultValue: '$NODE+0x380', expected a number of 32" + number);
  EXPECT_EQ(of("7", "ParameterValue=0x180h"),
            "drive.eds:5: 2000: ParameterValue: '0x180h', expected a number of 32" + number);
  EXPECT_EQ(of("5", "DefaultValue=256"), "drive.eds:5: 2000: DefaultValue: '256', expected a number of 8" + number);
  EXPECT_EQ(of("2", "DefaultValue=-129"), "drive.eds:5: 2000: DefaultValue: '-129', expected a number of 8" + number);
  EXPECT_EQ(of("2", "DefaultValue=$NODEID+129"),
            "drive.eds:5: 2000: DefaultValue: '$NODEID+129', expected a number of 8" + number)
      << "too large for node 127";
  EXPECT_EQ(of("7", "DefaultValue=0180"), "drive.eds:5: 2000: DefaultValue: '0180', expected a number of 32" + number);
  EXPECT_EQ(of("7", "DefaultValue=1\xA0"),
            "drive.eds:5: 2000: DefaultValue: '1\\xA0', expected a number of 32" + number);
  EXPECT_EQ(
      of("8", "DefaultValue=1,5"),
      "drive.eds:5: 2000: DefaultValue: '1,5', expected a decimal number of 32 bits, such as -0.25, or its bits, as "
      "0xBE800000");
  EXPECT_NE(of("8", "DefaultValue=0x7F800000"), "") << "infinite";
  EXPECT_NE(of("8", "DefaultValue=0x1437A0000"), "") << "more than 32 bits";
  EXPECT_EQ(of("1", "DefaultValue=maybe"), "drive.eds:5: 2000: DefaultValue: 'maybe', expected 0 or 1");
  EXPECT_EQ(of("7", "PDOMapping=yes"), "drive.eds:5: 2000: PDOMapping: 'yes', expected a number up to 1");
  EXPECT_EQ(of("7", "ObjectType=VAR"), "drive.eds:5: 2000: ObjectType: 'VAR', expected a number up to 9");
  EXPECT_EQ(of("7", "SubNumber=few"), "drive.eds:5: 2000: SubNumber: 'few', expected a number up to 255");
  EXPECT_EQ(of("7", "datatype=8"), "drive.eds:5: 2000: datatype: '8', but '7' in line 3, expected each key once");
  EXPECT_EQ(of("7", "[2000]\nParameterName=Again"),
            "drive.eds:5: 2000: the object has a section in line 1 already, expected one section for each");
  EXPECT_EQ(mistake("[2000]\nParameterName=a\nAccessType=rw\n"),
            "drive.eds:1: 2000: no DataType, expected a type's number, as 0x0007");
  EXPECT_EQ(mistake("[2000]\nParameterName=a\nDataType=7\n"),
            "drive.eds:1: 2000: no AccessType, expected ro, wo, rw, rwr, rww or const");
  EXPECT_EQ(mistake("[2000]\nParameterName=a\nDataType=7\nAccessType=\n"),
            "drive.eds:4: 2000: AccessType: '', expected ro, wo, rw, rwr, rww or const");
  EXPECT_EQ(mistake("[2000] x\n"), "drive.eds:1: '[2000] x' has more behind its end, expected [NAME]");
  EXPECT_EQ(mistake("\xFF\xFE["),
            "drive.eds:1: the file is in UTF-16, expected UTF-8 (choose it when the file is saved)");
  EXPECT_EQ(
      mistake(
          "[1003]\nParameterName=E\nObjectType=8\nDataType=5\nAccessType=ro\nCompactSubObj=2\n[1003Value]\n2=300\n"),
      "drive.eds:8: 1003: 2: '300', expected a number of 8" + number);
}

TEST(EdsValues, IgnoresTypeAndAccessOfARecord) {
  const std::string part =
      "\n[1018sub1]\nParameterName=Vendor-ID\nObjectType=0x7\nDataType=7\nAccessType=ro\nDefaultValue=5\n";
  for (const char* const own :
       {"", "AccessType=", "AccessType=rw\nDataType=0x0004",
        "DataType=", "ObjectType=0x9\nAccessType=", "ObjectType=0x8\nAccessType=maybe", "SubNumber=1\nAccessType=ro",
        "SubNumber=\nDataType=7", "ObjectType=9\nDataType=none\nAccessType=rw\nPDOMapping=0"}) {
    const std::string record = std::string("[1018]\nParameterName=Identity\n") + own + "\n";
    for (const std::string& text : {record + part, part + record}) {
      const EdsFile file = parse(text);
      EXPECT_EQ(file.entries().size(), 1u) << text;
      EXPECT_EQ(file.object("identity/vendor-id"), kVendor) << text;
      EXPECT_EQ(default_number(*file.find(kVendor), 1), 5) << text;
    }
  }
}

TEST(EdsValues, RepeatsAnAxis) {
  EdsFile file = parse(
      "[1400]\nParameterName=R\nObjectType=9\n[1400sub1]\nParameterName=C\nDataType=7\nAccessType=rw\n"
      "DefaultValue=$NODEID+0x200\n[1402sub1]\nParameterName=C\nDataType=7\nAccessType=rw\n"
      "[6040]\nParameterName=W\nDataType=6\nAccessType=rw\nDefaultValue=3\n"
      "[2000]\nParameterName=M\nDataType=6\nAccessType=rw\n");
  const std::size_t before = file.entries().size();
  file.repeat_axis(3, 129);
  EXPECT_EQ(file.entries().size(), before + 2);
  ASSERT_NE(file.find({0x7040}), nullptr);
  EXPECT_EQ(default_number(*file.find({0x7040}), 1), 3);
  ASSERT_NE(file.find({0x1480, 1}), nullptr);
  EXPECT_EQ(default_number(*file.find({0x1480, 1}), 1), 0x80000000);
  const EdsFile axis = file.of_axis(3, 129);
  EXPECT_EQ(default_number(*axis.find({0x1400, 1}), 1), 0x80000000);
  EXPECT_EQ(default_number(*axis.find({0x6040}), 1), 3);
}

}  // namespace
}  // namespace mrroc::canopen
