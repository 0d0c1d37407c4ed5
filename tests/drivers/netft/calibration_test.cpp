#include "drivers/netft/calibration.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>

#include "config/message_of.hpp"

namespace mrroc::netft::calibration_test {
namespace {

constexpr const char* kAddress = "http://192.168.1.1:80/netftapi2.xml";

/// A page in the form of the sensor's, `elements` among others.
std::string page(const std::string& elements) {
  return "<?xml version=\"1.0\"?>\n<netFTApi>\n<runstat>0x00000000</runstat>\n<runft>1;2;3;4;5;6</runft>\n" + elements +
         "\n<prodname>Net F/T</prodname></netFTApi>\n";
}

constexpr const char* kUsual =
    "<cfgcpf>1000000</cfgcpf><cfgcpt>1000</cfgcpt><scfgfu>N</scfgfu><scfgtu>Nmm</scfgtu>"
    "<comrdte>Enabled</comrdte><comrdtrate>7000</comrdtrate>";

std::string refusal(const std::string& xml) {
  return config::message_of("", [&] { read_configuration(xml, kAddress); });
}

TEST(NetftCalibration, ReadsCountsAndUnitsOfThePage) {
  const SensorConfiguration read = read_configuration(page(kUsual), kAddress);
  EXPECT_DOUBLE_EQ(read.calibration.newtons_per_count, 1e-6);
  EXPECT_DOUBLE_EQ(read.calibration.newton_metres_per_count, 1e-6);
  EXPECT_EQ(read.product, "Net F/T");
  EXPECT_EQ(read.rate, 7000);
  EXPECT_TRUE(read.rdt_enabled);
  EXPECT_EQ(read.status, 0u);
}

TEST(NetftCalibration, ReadsCodesWhereUnitsHaveNoNames) {
  const SensorConfiguration read =
      read_configuration(page("<cfgcpf>10</cfgcpf><cfgcpt>100</cfgcpt><cfgfu>5</cfgfu><cfgtu>1</cfgtu>"), kAddress);
  EXPECT_DOUBLE_EQ(read.calibration.newtons_per_count, 0.980665);
  EXPECT_NEAR(read.calibration.newton_metres_per_count, 0.00112984829, 1e-11);
  EXPECT_EQ(read.rate, 0);
}

TEST(NetftCalibration, ConvertsEveryUnit) {
  // NIST Special Publication 811, appendix B.8
  EXPECT_DOUBLE_EQ(newtons("N").value(), 1);
  EXPECT_DOUBLE_EQ(newtons("kN").value(), 1000);
  EXPECT_NEAR(newtons("lbf").value(), 4.448222, 1e-6);
  EXPECT_NEAR(newtons("klbf").value(), 4448.222, 1e-3);
  EXPECT_DOUBLE_EQ(newtons("kgf").value(), 9.80665);
  EXPECT_DOUBLE_EQ(newtons("gf").value(), 0.00980665);
  EXPECT_FALSE(newtons("g"));
  EXPECT_DOUBLE_EQ(newton_metres("N-m").value(), 1);
  EXPECT_DOUBLE_EQ(newton_metres("Nm").value(), 1);
  EXPECT_DOUBLE_EQ(newton_metres("N-mm").value(), 0.001);
  EXPECT_DOUBLE_EQ(newton_metres("kN-m").value(), 1000);
  EXPECT_NEAR(newton_metres("lbf-in").value(), 0.1129848, 1e-7);
  EXPECT_NEAR(newton_metres("lbf-ft").value(), 1.355818, 1e-6);
  EXPECT_DOUBLE_EQ(newton_metres("kgf-cm").value(), 0.0980665);
  EXPECT_FALSE(newton_metres("N"));
}

TEST(NetftCalibration, NamesAddressElementAndValueOfAMistake) {
  EXPECT_EQ(refusal(page("<cfgcpf>x</cfgcpf><cfgcpt>1</cfgcpt><scfgfu>N</scfgfu><scfgtu>Nm</scfgtu>")),
            "http://192.168.1.1:80/netftapi2.xml:5: cfgcpf: 'x', expected a number above 0");
  EXPECT_EQ(refusal(page("<cfgcpf>1</cfgcpf>\n<cfgcpt>0</cfgcpt><scfgfu>N</scfgfu><scfgtu>Nm</scfgtu>")),
            "http://192.168.1.1:80/netftapi2.xml:6: cfgcpt: '0', expected a number above 0");
  EXPECT_EQ(refusal(page("<cfgcpf>1</cfgcpf><cfgcpt>1</cfgcpt><scfgfu>stone</scfgfu><scfgtu>Nm</scfgtu>")),
            "http://192.168.1.1:80/netftapi2.xml:5: scfgfu: 'stone', expected 'lbf', 'N', 'klbf', 'kN', 'kgf' or 'gf'");
  const std::string missing = refusal(page("<cfgcpf>1</cfgcpf><scfgfu>N</scfgfu><scfgtu>Nm</scfgtu>"));
  EXPECT_EQ(missing, "http://192.168.1.1:80/netftapi2.xml: cfgcpt: missing, expected a number above 0");
  EXPECT_EQ(refusal(page(std::string(kUsual) + "\n<cfgcpf>2</cfgcpf>")),
            "http://192.168.1.1:80/netftapi2.xml:6: cfgcpf: also in line 5, expected one element");
  EXPECT_EQ(refusal(page("<cfgcpf>1</cfgcpf><cfgcpt>1</cfgcpt><cfgfu>7</cfgfu><scfgtu>Nm</scfgtu>")),
            "http://192.168.1.1:80/netftapi2.xml:5: cfgfu: '7', expected the number of a unit: 'lbf', 'N', 'klbf', "
            "'kN', 'kgf' or 'gf'");
}

TEST(NetftCalibration, RefusesPagesOfOtherDevices) {
  EXPECT_NE(refusal("").find("not an XML page, expected the configuration page of a Net F/T"), std::string::npos);
  EXPECT_NE(refusal("<html><body>printer").find("not an XML page"), std::string::npos);
  EXPECT_NE(refusal("<html><body>printer</body></html>").find("missing"), std::string::npos);
  EXPECT_NE(refusal(page(std::string(kUsual) + "<x>")).find("not an XML page"), std::string::npos);
}

TEST(NetftCalibration, ReportsDisabledRdtAndStatus) {
  std::string text = page(kUsual);
  text.replace(text.find("Enabled"), 7, "Disabled");
  text.replace(text.find("0x00000000"), 10, "0x80020000");
  const SensorConfiguration read = read_configuration(text, kAddress);
  EXPECT_FALSE(read.rdt_enabled);
  EXPECT_EQ(read.status, 0x80020000u);
}

TEST(NetftCalibration, TruncatedPageIsRefused) {
  const std::string whole = page(kUsual);
  const bool ok = rc::check("a page that was cut off is refused", [&] {
    const auto size = *rc::gen::inRange<std::size_t>(0, whole.find("</netFTApi>"));
    RC_ASSERT(!refusal(whole.substr(0, size)).empty());
  });
  EXPECT_TRUE(ok);
}

}  // namespace
}  // namespace mrroc::netft::calibration_test
