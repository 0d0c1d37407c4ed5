# mrroc_sensor_class(TYPE TOML OUTPUT_FOLDER CLASS_SUFFIX FILE_SUFFIX): writes the class that a task program declares for a sensor of
# this type, with one accessor per channel of its declaration TYPE.toml ([[channels]] name, unit), to
# OUTPUT_FOLDER/mrroc/sensors/TYPE<FILE_SUFFIX>.hpp. CMake configures again when TOML changes.
function(mrroc_sensor_class type toml folder class_suffix file_suffix)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${toml})
  string(REPLACE "_" ";" words ${type})
  set(class "")
  foreach(word ${words})
    string(SUBSTRING ${word} 0 1 first)
    string(SUBSTRING ${word} 1 -1 rest)
    string(TOUPPER ${first} first)
    string(APPEND class ${first}${rest})
  endforeach()
  set(class ${class}${class_suffix})

  file(STRINGS ${toml} lines)
  set(accessors "")
  set(index -1)
  set(in_channel FALSE)
  foreach(line IN LISTS lines)
    if(line MATCHES "^\\[\\[channels\\]\\]")
      math(EXPR index "${index} + 1")
      set(in_channel TRUE)
    elseif(line MATCHES "^\\[")
      set(in_channel FALSE)
    elseif(in_channel AND line MATCHES "^name *= *[\"']([a-z][a-z0-9_]*)[\"']")
      set(name ${CMAKE_MATCH_1})
    elseif(in_channel AND line MATCHES "^unit *= *[\"']([^\"']*)[\"']")
      string(APPEND accessors
        "  /// ${CMAKE_MATCH_1}\n  double ${name}() const noexcept { return Sensor::value(${index}); }\n")
    endif()
  endforeach()
  if(accessors STREQUAL "")
    message(FATAL_ERROR "${toml}: no [[channels]] with name and unit, expected at least one")
  endif()

  cmake_path(GET toml FILENAME file)
  file(CONFIGURE OUTPUT ${folder}/mrroc/sensors/${type}${file_suffix}.hpp @ONLY CONTENT [[
#pragma once

// made from @file@

#include <string>

#include "mrroc/sensor.hpp"

namespace mrroc {

/// A sensor of type `@type@` in a task program: the channels of its reading, NaN before the first one. Task's thread.
class @class@ : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no sensor `name` of this type.
  @class@(Task& task, const std::string& name) : Sensor(task, name, "@type@") {}

@accessors@};

}  // namespace mrroc
]])
endfunction()
