#pragma once

#include <string>

#include "canopen/eds_file.hpp"

namespace mrroc::canopen {

inline EdsFile parse(const std::string& text) { return EdsFile::parse(text, "drive.eds"); }

/// The error in the text; empty: it is valid.
inline std::string mistake(const std::string& text) {
  try {
    parse(text);
    return "";
  } catch (const EdsError& error) {
    return error.what();
  }
}

/// One value and one record.
inline constexpr const char* kSmall = R"(; a comment
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

}  // namespace mrroc::canopen
