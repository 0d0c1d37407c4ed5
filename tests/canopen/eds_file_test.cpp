#include <gtest/gtest.h>

#include "canopen/default_value.hpp"
#include "canopen/eds_text.hpp"
#include "canopen/random_frames.hpp"

namespace mrroc::canopen {
namespace {

std::string no_object(const EdsFile& file, const std::string& name) {
  try {
    file.object(name);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(EdsFile, IgnoresAByteOrderMark) {
  const EdsFile file = parse(std::string("\xEF\xBB\xBF") + kSmall);
  EXPECT_EQ(file.product(), "Servo");
  EXPECT_NE(file.find(kControlword), nullptr);
  EXPECT_EQ(parse(std::string("\xEF\xBB\xBF") + (kSmall + 12)).product(), "Servo") << "before a section";
}

TEST(EdsFile, AcceptsAdditionsOfMakersAndEditors) {
  for (const char* const text :
       {"[6040] ; a comment\nParameterName=Controlword\nDataType=0x6\nAccessType=rww\nPDOMapping=0x1\n",
        "\xEF\xBB\xBF[6040]\r\nPARAMETERNAME = \"Controlword\"\r\ndatatype = 6 ; unsigned16\r\n"
        "accesstype = \"RWW\" ; both\r\nPDOMAPPING=1\r\n\x1A",
        "# made by hand\n[ 6040 ]\nParameterName=Controlword ; the word\nDataType=06\nAccessType=Rww \t\n"
        "PDOMapping=1;\n",
        "[6040]\nParameterName=Controlword\nParameterName=Controlword\nDataType=0X0006\nAccessType=rww;\n"
        "PDOMapping=1\nLowLimit=\nObjFlags=0"}) {
    const EdsFile file = parse(text);
    const ObjectEntry& entry = *file.find(file.object("controlword"));
    EXPECT_EQ(entry.type, DataType::unsigned16) << text;
    EXPECT_EQ(entry.access, "rww") << text;
    EXPECT_TRUE(entry.mappable) << text;
  }
  EXPECT_EQ(parse("[2000]\nParameterName=Spannung \xFC"
                  "ber 24V\nDataType=7\nAccessType=ro\n")
                .entries()
                .size(),
            1u)
      << "names in Latin-1";
  EXPECT_EQ(parse("[2000]\nParameterName=Firmware\nObjectType=0x2\n").find({0x2000, 0})->type, DataType::domain);
}

// Elmo, Schunk, Pilz, Roboteq, Xeryon and JINR: docs/how-to/can.md
TEST(EdsFile, ReadsWhatFilesOfMakersHave) {
  const EdsFile file = parse(
      "; created by a tool\r\n\r\n[DeviceInfo]\r\nVendorname=Maker\r\nCompactPDO=0\r\n\r\n[DummyUsage]\r\n"
      "Dummy0001=0\r\n\r\n[1003]\r\nSubNumber=17\r\nParameterName=Error Field\r\nObjectType=0x08\r\n\r\n"
      "[1003sub0]\r\nParameterName=Number\r\nDataType=0x0005\r\nAccessType=rw\r\nPDOMapping=0\r\n\r\n"
      "[1003sub10]\r\nParameterName=Field 16\r\nObjectType=0x07\r\nDataType=0x0007\r\nAccessType=ro\r\n"
      "DefaultValue=\r\n\r\n;[6406]\r\n;ParameterName=date\r\n\r\n[1800]\r\nParameterName=TPDO 1\r\n"
      "ObjectType=0x9\r\nSubNumber=2\r\nObjFlags=0x0\r\n\r\n[1800sub1]\r\nParameterName=COB-ID\r\nObjectType=0x7\r\n"
      "DataType=0x0007\r\nAccessType=rw\r\nDefaultValue=$NodeID + 0x180\r\n;ParameterValue=2\r\n\r\n"
      "[2013]\r\nParameterName=Step\r\nDataType=0x0008\r\nAccessType=rw\r\nDefaultValue=0x437A0000\r\n");
  EXPECT_EQ(file.product(), "");
  EXPECT_EQ(file.entries().size(), 4u);
  EXPECT_EQ(file.object("error field/field 16"), (Object{0x1003, 0x10}));
  EXPECT_EQ(default_number(*file.find({0x1800, 1}), 5), 0x185);
  EXPECT_EQ(default_number(*file.find({0x1003, 0x10}), 5), std::nullopt);
  EXPECT_EQ(configured_bytes(*file.find({0x2013, 0}), 5), (std::vector<std::uint8_t>{0, 0, 0x7a, 0x43}));
}

TEST(EdsFile, ReadsTheFilesOfTheFramework) {
  const EdsFile file = EdsFile::load(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia402.eds");
  EXPECT_EQ(file.product(), "CiA 402 servo drive");
  for (const Object object : {kDeviceType, kControlword, kStatusword, kMode, kTargetPosition, kPositionActual, kVendor,
                              kHomingSpeedZero, kInterpolationTime, kDigitalInputs, kQuickStopOption})
    EXPECT_NE(file.find(object), nullptr) << to_text(object);
  for (const auto& [object, entry] : file.entries()) {
    EXPECT_FALSE(entry.name.empty());
    EXPECT_FALSE(entry.access.empty()) << to_text(object);
    EXPECT_TRUE(size_of(entry.type) != 0 || entry.type == DataType::visible_string) << to_text(object);
  }
  EXPECT_TRUE(file.find(kControlword)->mappable);
  EXPECT_FALSE(file.find(kStatusword)->writable());
}

TEST(EdsFile, ReadsPartsThatAreDescribedTogether) {
  const EdsFile file = parse(R"([1003]
ParameterName=Errors
ObjectType=0x8
DataType=0x0007
AccessType=ro
DefaultValue=5
CompactSubObj=3

[1003Name]
NrOfEntries=1
2=Older

[1003Value]
NrOfEntries=1
3=0x7
)");
  EXPECT_EQ(file.entries().size(), 4u);
  EXPECT_EQ(file.find({0x1003, 0})->default_value, "3");
  EXPECT_EQ(file.find({0x1003, 0})->type, DataType::unsigned8);
  EXPECT_EQ(file.object("errors/errors1"), (Object{0x1003, 1}));
  EXPECT_EQ(file.object("errors/older"), (Object{0x1003, 2}));
  EXPECT_EQ(file.find({0x1003, 1})->default_value, "5");
  EXPECT_EQ(file.find({0x1003, 3})->default_value, "0x7");
  EXPECT_EQ(file.find({0x1003, 3})->type, DataType::unsigned32);
  EXPECT_NE(mistake("[1003]\nParameterName=E\nCompactSubObj=255\n")
                .find("drive.eds:3: 1003: CompactSubObj: '255', expected a number up to 254"),
            std::string::npos);
}

TEST(EdsFile, FindsObjectsByNameAndByAddress) {
  const EdsFile file = parse(kSmall);
  EXPECT_EQ(file.product(), "Servo");
  EXPECT_EQ(file.entries().size(), 2u) << "an object that has only parts has no value";
  for (const char* const name : {"Controlword", " controlWORD ", "0x6040", "0X6040:0", "0x6040:0x0"})
    EXPECT_EQ(file.object(name), kControlword) << name;
  EXPECT_EQ(file.object("identity object/vendor-id"), kVendor);
  EXPECT_EQ(file.object("0x1018:1"), kVendor);
  const ObjectEntry& entry = *file.find(kControlword);
  EXPECT_EQ(entry.type, DataType::unsigned16);
  EXPECT_EQ(entry.access, "rw");
  EXPECT_EQ(entry.default_value, "0");
  EXPECT_EQ(file.find({0x1018, 0}), nullptr);
}

TEST(EdsFile, SuggestsSimilarNamesForAnUnknownName) {
  const EdsFile file = parse(kSmall);
  EXPECT_EQ(
      no_object(file, "control"),
      "'control' is not an object of the EDS file, expected a name of it (Controlword) or an address like 0x6040 or "
      "0x1018:1");
  EXPECT_EQ(no_object(file, "0x1018:2"), "object 1018h:2 is not in the EDS file");
  for (const char* const bad : {"", "0x", "0x10000", "0x6040:256", "0x6040:", "0x6040:1:2", "6040"})
    EXPECT_NE(no_object(file, bad), "") << bad;
}

TEST(EdsFile, NameOfTwoObjectsIsThatOfTheFirst) {
  const std::string both =
      "[6060]\nParameterName=Mode\nDataType=2\nAccessType=rw\n[6061]\nParameterName=mode\nDataType=2\nAccessType=ro\n";
  EXPECT_EQ(parse(both).object("mode"), kMode);
}

TEST(EdsFile, ReportsEveryMistakeWithItsLine) {
  EXPECT_EQ(mistake("[6040\n"), "drive.eds:1: '[6040' has no end, expected [NAME]");
  EXPECT_EQ(mistake("\n[6040]\nParameterName\n"), "drive.eds:3: 'ParameterName', expected KEY=VALUE");
  EXPECT_EQ(mistake("a=b\n"), "drive.eds:1: 'a=b', expected a section [NAME] first");
  EXPECT_EQ(mistake("[6040]\nAccessType=rw\n"), "drive.eds:1: 6040: no ParameterName, expected one");
  EXPECT_EQ(mistake("[6040]\nParameterName=\n"), "drive.eds:1: 6040: no ParameterName, expected one");
  EXPECT_EQ(mistake("[6040]\nParameterName=a\nDataType=7\nAccessType=maybe\n"),
            "drive.eds:4: 6040: AccessType: 'maybe', expected ro, wo, rw, rwr, rww or const");
  for (const std::string type : {"", "x", "0", "0x10000", "-1", "7 8", "99999999999", "0x"})
    EXPECT_EQ(mistake("[1018SUB1]\r\nParameterName=a\r\nDataType=" + type + "\r\n"),
              "drive.eds:3: 1018sub1: DataType: '" + type + "', expected a type's number, as 0x0007");
  EXPECT_THROW(EdsFile::load("/nonexistent/drive.eds"), EdsError);
  EXPECT_THROW(EdsFile::load(MRROC_SOURCE_DIR), EdsError) << "a folder";
}

TEST(EdsFile, IgnoresSectionsWithoutAValue) {
  EXPECT_TRUE(parse("[Comments]\nLines=0\n[604]\na=b\n[60400]\na=b\n[6040su1]\na=b\n[6040sub]\na=b\n[6040sub100]\n"
                    "a=b\n[6040subx]\na=b\n")
                  .entries()
                  .empty());
  EXPECT_TRUE(parse("").entries().empty());
}

TEST(EdsFile, RefusesAMisspeltAddressOfAValue) {
  const std::string value = "ParameterName=Type\nDataType=5\nAccessType=rw\nDefaultValue=254\n";
  for (const char* const name : {"1802 sub1", "1802_sub1", "1802.1", "1802sub", "1802sub100", "1802subx", "1802su1",
                                 "18020", "0x1802", "0x1802sub1", "1802sub 1", "A580 Sub2"}) {
    const std::string text = std::string{"[1802]\nParameterName=TPDO 3\nObjectType=9\n["} + name + "]\n" + value;
    try {
      parse(text);
      ADD_FAILURE() << name;
    } catch (const EdsError& error) {
      EXPECT_TRUE(std::string_view(error.what()).starts_with("drive.eds:4: ")) << error.what();
    }
  }
  for (const char* const name : {"M1SubExt6000", "M1Fixed6000sub1", "Decoration", "Comments"})
    EXPECT_TRUE(parse(std::string{"["} + name + "]\n" + value).entries().empty()) << name;
}

TEST(EdsFile, ReadsOrRefusesAnyText) {
  EXPECT_TRUE(rc::check("lines of pieces", [] {
    const auto pieces = *rc::gen::container<std::vector<std::string>>(
        rc::gen::element<std::string>("[", "]", "6040", "sub", "1", "=", "\n", "\r", ";", " ", "ParameterName",
                                      "DataType", "AccessType", "0x", "rw", "\xff", std::string(1, '\0')));
    std::string text;
    for (const std::string& piece : pieces) text += piece;
    try {
      parse(text);
    } catch (const EdsError& error) {
      RC_ASSERT(std::string(error.what()).starts_with("drive.eds:"));
    }
  }));
}

}  // namespace
}  // namespace mrroc::canopen
