// A part of the simulated world, of any content: read, renamed, written again. MuJoCo's interpretation of the text is
// not tested.
#include <algorithm>

#include "config/table.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "sim/scene/mjcf_part.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const mrroc::task_test::ScratchFolder folder;  // where an input can include only itself
  static const fuzz::MemoryFile again;
  const auto file = folder.write("part.xml", fuzz::text_of(data, size));
  mrroc::sim::MjcfPart part;
  const auto read = [&] { part = mrroc::sim::read_part(file, "arm/"); };
  if (fuzz::refuses<mrroc::config::ConfigurationError>(read)) return 0;
  mrroc::sim::Element root{"mujoco", {}, part.world, part.origin};
  root.children.push_back(part.defaults);
  root.children.insert(root.children.end(), part.sections.begin(), part.sections.end());
  const auto text = mrroc::sim::write(root);
  const auto lines = static_cast<std::size_t>(std::count(text.text.begin(), text.text.end(), '\n'));
  fuzz::require(lines == text.lines.size(), "every line has its origin");
  const auto well_formed = mrroc::sim::load_mjcf(again.write(text.text));
  fuzz::require(mrroc::sim::write(well_formed).text == text.text, "a written part reads back unchanged");
  return 0;
}
