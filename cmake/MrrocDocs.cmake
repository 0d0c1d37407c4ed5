# The target docs: the public headers as HTML, in docs/html of the build folder. A warning of Doxygen is an error.
find_program(MRROC_DOXYGEN doxygen)
file(GLOB documented RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS robots/*/include sensors/*/include)
list(APPEND documented include mp/include ecp/include testing/include ${MRROC_PUBLIC_HEADERS})
list(JOIN documented " " MRROC_DOCUMENTED)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/docs/Doxyfile @ONLY CONTENT "PROJECT_NAME = MRROC++
PROJECT_NUMBER = ${PROJECT_VERSION}
INPUT = @MRROC_DOCUMENTED@
FILE_PATTERNS = *.hpp
RECURSIVE = YES
STRIP_FROM_PATH = include mp/include ecp/include testing/include ${PROJECT_SOURCE_DIR}
OUTPUT_DIRECTORY = ${CMAKE_BINARY_DIR}/docs
GENERATE_LATEX = NO
JAVADOC_AUTOBRIEF = YES
MACRO_EXPANSION = YES
SORT_MEMBER_DOCS = NO
QUIET = YES
WARN_IF_UNDOCUMENTED = NO
WARN_AS_ERROR = FAIL_ON_WARNINGS
")
add_custom_target(docs
  COMMAND $<IF:$<BOOL:${MRROC_DOXYGEN}>,${MRROC_DOXYGEN},doxygen> ${CMAKE_BINARY_DIR}/docs/Doxyfile
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
