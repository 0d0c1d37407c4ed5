#pragma once

#include <concepts>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "mrroc/generator.hpp"

namespace mrroc {

/// Several generators at once, each for its own robots:
///
///   Move({arm, gripper}, {encoder}, Together{TrackFrame{arm, frame, above}, JointLine{gripper, open}});
///
/// A part ends on its own or when the condition of its own `until` holds; its robots then hold, while the others
/// continue. The whole ends when all parts have ended, or by the condition of its own `until`. If two parts command one
/// robot, the later one takes effect. The name lists the parts: "TrackFrame + JointLine".
class Together : public Generator {
 public:
  /// Temporary parts are moved in; variables, and results of `until`, are held by reference.
  template <class... Parts>
  requires(sizeof...(Parts) >= 2 &&
           (std::derived_from<std::remove_cvref_t<Parts>, Generator> && ...)) explicit Together(Parts&&... parts)
      : Generator(joined({&parts...})) {
    (add(std::forward<Parts>(parts)), ...);
  }

  void start() override;
  void resume() override;
  bool brake() override;
  bool terminal_condition() override;
  void next_state() override;
  void finish() noexcept override;
  /// If all parts do: they are executed in the same time.
  bool scales_with_speed() const override;

 private:
  struct Part {
    std::shared_ptr<Generator> generator;
    bool ended = false;
  };
  static std::string joined(const std::vector<const Generator*>& parts);
  void add(Generator& part) { parts_.push_back({{std::shared_ptr<void>{}, &part}}); }
  template <class Part>
  requires(!std::is_lvalue_reference_v<Part>) void add(Part&& part) {
    parts_.push_back({std::make_shared<Part>(std::forward<Part>(part))});
  }

  std::vector<Part> parts_;
};

}  // namespace mrroc
