#include "canopen/eds_file.hpp"

#include <gtest/gtest.h>

#include "canopen/default_value.hpp"
#include "canopen/random_frames.hpp"

namespace mrroc::canopen {
namespace {

EdsFile parse(const std::string& text) { return EdsFile::parse(text, "drive.eds"); }

std::string mistake(const std::string& text) {
  try {
    parse(text);
    return "";
  } catch (const EdsError& error) {
    return error.what();
  }
}

std::string no_object(const EdsFile& file, const std::string& name) {
  try {
    file.object(name);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

constexpr const char* kSmall = R"(; a comment
[DeviceInfo]
ProductName = Servo

[6040]
ParameterName=Controlword
DataType=0x0006
AccessType=RW
DefaultValue=0
PDOMapping=1

[1018]
ParameterName=Identity object
ObjectType=0x9
SubNumber=2

[1018sub1]
ParameterName=Vendor-ID
DataType=7
AccessType=ro
)";

TEST(EdsFile, AByteOrderMarkIsNoPartOfIt) {
  const EdsFile file = parse(std::string("\xEF\xBB\xBF") + kSmall);
  EXPECT_EQ(file.product(), "Servo");
  EXPECT_NE(file.find(kControlword), nullptr);
  EXPECT_EQ(parse(std::string("\xEF\xBB\xBF") + (kSmall + 12)).product(), "Servo") << "before a section";
}

TEST(EdsFile, ADefaultMayCountFromTheNodesNumber) {
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

/// The object 2000h of this type with a line, and how it is read.
ObjectEntry with_default(const std::string& type, const std::string& line) {
  return *parse("[2000]\nParameterName=Value\nDataType=" + type + "\nAccessType=rw\n" + line + "\n").find({0x2000, 0});
}

TEST(EdsFile, ValuesOfEveryTypeAreReadAsMakersWriteThem) {
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
  EXPECT_EQ(bytes("0x0009", "a;b"), (Bytes{'a', ';', 'b'}));
  EXPECT_EQ(bytes("0x0009", "\"a ;b\" ; a name"), (Bytes{'a', ' ', ';', 'b'}));
  EXPECT_EQ(bytes("0x0009", "$NODEID"), (Bytes{'$', 'N', 'O', 'D', 'E', 'I', 'D'}));
  EXPECT_EQ(bytes("0x0005", "0x12"), Bytes{0x12});
  EXPECT_EQ(bytes("0x000f", "01 02"), Bytes{});
}

TEST(EdsFile, AValueThatIsNotUnderstoodIsNeverNoValue) {
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
      << "of node 127 it would not fit";
  EXPECT_EQ(of("7", "DefaultValue=0180"), "drive.eds:5: 2000: DefaultValue: '0180', expected a number of 32" + number);
  EXPECT_EQ(of("7", "DefaultValue=1\xA0"),
            "drive.eds:5: 2000: DefaultValue: '1\\xA0', expected a number of 32" + number);
  EXPECT_EQ(of("8", "DefaultValue=1,5"),
            "drive.eds:5: 2000: DefaultValue: '1,5', expected a decimal number of 32 bits, such as -0.25");
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

TEST(EdsFile, ARecordsOwnTypeAndAccessMeanNothing) {
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

TEST(EdsFile, BearsWhatMakersAndEditorsAdd) {
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

TEST(EdsFile, TheFrameworksOwnIsRead) {
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

TEST(EdsFile, PartsThatAreDescribedAtOnce) {
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

TEST(EdsFile, ObjectsByNameAndByAddress) {
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

TEST(EdsFile, AnUnknownNameIsAnsweredWithThoseThatComeNear) {
  const EdsFile file = parse(kSmall);
  EXPECT_EQ(no_object(file, "control"),
            "'control' is no object of the EDS file, expected a name of it (Controlword) or an address like 0x6040 or "
            "0x1018:1");
  EXPECT_EQ(no_object(file, "0x1018:2"), "object 1018h:2 is not in the EDS file");
  for (const char* const bad : {"", "0x", "0x10000", "0x6040:256", "0x6040:", "0x6040:1:2", "6040"})
    EXPECT_NE(no_object(file, bad), "") << bad;
}

TEST(EdsFile, OfTwoObjectsWithOneNameItStandsForTheFirst) {
  const std::string both =
      "[6060]\nParameterName=Mode\nDataType=2\nAccessType=rw\n[6061]\nParameterName=mode\nDataType=2\nAccessType=ro\n";
  EXPECT_EQ(parse(both).object("mode"), kMode);
}

TEST(EdsFile, EveryMistakeHasItsLine) {
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

TEST(EdsFile, SectionsThatDescribeNoValueAreLeftOut) {
  EXPECT_TRUE(parse("[Comments]\nLines=0\n[604]\na=b\n[60400]\na=b\n[6040su1]\na=b\n[6040sub]\na=b\n[6040sub100]\n"
                    "a=b\n[6040subx]\na=b\n")
                  .entries()
                  .empty());
  EXPECT_TRUE(parse("").entries().empty());
}

TEST(EdsFile, AnyTextIsReadOrRefused) {
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
