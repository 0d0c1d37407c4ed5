#pragma once

#include <string>
#include <utility>

#include "mrroc/generator.hpp"
#include "mrroc/superior.hpp"

namespace mrroc {

/// A generator of an ECP in whose Move the MP takes part, the paper's equation (11): e_j^{i+1} = f*(c_0, c_j, e_j, v).
/// One step of the MP's Move or Wait over this robot is one step of this one:
///
///   the MP's command for this robot arrives: superior().command()
///   f_T of this Move; next_state() computes this robot's command from it, and from what this ECP knows and senses
///   exchange with the EDP; the state, as it is, answers the MP
///
/// The command has the MP's macrostep (N, v) and start tick before `next_state()`. Where the MP commands `hold` the
/// robot holds, without `next_state()`; while the MP sends nothing it stays at rest (in motion its EDP brakes). Pauses
/// and the operator's speed act through the MP's commands. At the start of an MP's Move, and whenever its generator
/// plans from rest, the MP plans from the robot's true desired state: `resume()` is called then, with the robot at rest
/// or in the motion that its state describes.
///
/// Its Move has one robot, that of the ECP. It ends when the MP's Move ends (`superior().ended()`; a Wait of the MP
/// only holds), unless it is to `stay()`, or by a condition. When it ends first, the MP plans again from the robot's
/// state at its next command; while the ECP's program does something else then, the MP gets `busy`. An error here is an
/// error of the robot in the MP's Move, too.
///
/// Task's thread only, as every generator.
class Coordinated : public Generator {
 public:
  Coordinated(std::string name, Superior& superior) : Generator(std::move(name)), superior_(&superior) {}

  /// c_0 of this step.
  const Superior& superior() const noexcept { return *superior_; }
  Superior* followed() noexcept final { return superior_; }
  /// Takes part in the MP's following Moves, too, until a condition of `until` holds or the MP ends this Move
  /// (`end_motion`).
  Coordinated& stay() noexcept {
    stays_ = true;
    return *this;
  }
  bool terminal_condition() override { return !stays_ && superior_->ended(); }
  /// The MP's commands are at the operator's speed already.
  bool scales_with_speed() const final { return false; }

 private:
  Superior* superior_;
  bool stays_ = false;
};

}  // namespace mrroc
