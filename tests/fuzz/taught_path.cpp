// A taught path's file (mrroc/taught_path.hpp), of any content.
#include "mrroc/taught_path.hpp"

#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"
#include "language/free_flyer.hpp"
#include "mrroc/errors.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  static const mrroc::fakes::FreeFlyer task(mrroc::Pose::Identity());
  fuzz::refuses<mrroc::NonFatalError>([&] {
    const auto path = mrroc::load_taught_path(file.write(fuzz::text_of(data, size)), *task.arm);
    fuzz::require(!path.points.empty(), "an accepted path has a point");
    for (const auto& point : path.points) {
      fuzz::require(path.space == mrroc::TaughtPath::Space::poses || point.joints.size() == 6, "a joint for each axis");
      fuzz::require(point.pose.matrix().allFinite(), "a pose is finite");
    }
  });
  return 0;
}
