#include "process/record/text_memory.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace mrroc::process::text_memory_test {
namespace {

TEST(TextMemory, EveryReaderGetsTheWholeText) {
  for (const std::string& text : {std::string(), std::string("name = 'x'\n"), std::string(1 << 20, 'x')}) {
    const TextMemory memory(text);
    EXPECT_EQ(read_text(memory.fd()), text);
    EXPECT_EQ(read_text(memory.fd()), text) << "the file position is shared";
  }
}

TEST(TextMemory, NoProcessCanChangeIt) {
  const TextMemory memory("text");
  EXPECT_LT(pwrite(memory.fd(), "T", 1, 0), 0);
  EXPECT_NE(ftruncate(memory.fd(), 0), 0);
  EXPECT_EQ(read_text(memory.fd()), "text");
}

}  // namespace
}  // namespace mrroc::process::text_memory_test
