#pragma once

#include "cooperative_transfer/transfer.hpp"
#include "system/programs/share.hpp"

namespace mrroc::test {

/// The transfer by two arms in which the MP moves the bar and the ECPs control the forces; or nothing does.
template <class Arm>
class SharedTransfer : public transfer::TransferBy<Arm> {
 public:
  explicit SharedTransfer(const transfer::Arms& carriers) : transfer::TransferBy<Arm>(carriers) {}

 private:
  bool controls_force() const override { return false; }
  void gripped() override {
    if (!shared_) return;
    for (const char* arm : {"left", "right"}) this->start(arm, Share{mass_});
  }
  void before_release() override {
    if (!shared_) return;
    for (const char* arm : {"left", "right"}) this->end_motion(arm);
    this->wait_for_all();
  }
  void run() override {
    using namespace transfer;
    shared_ = this->ask_yes_no("Do the arms comply?");
    mass_ = this->ask_number("Mass?", 0, 5);
    this->set_tools();
    this->take_up();
    for (const auto& [path, limits] : {std::pair{way::carry(this->arms), kFree}, std::pair{way::lower(), kNear}})
      this->carry_along(path, limits);
    this->put_down(way::put_down());
  }

  bool shared_ = false;
  double mass_ = 0;  // kg, of the bar
};

}  // namespace mrroc::test
