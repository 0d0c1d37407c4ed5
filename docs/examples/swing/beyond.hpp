#pragma once

#include <mrroc/condition.hpp>
#include <mrroc/sensors/protractor.hpp>

/// The angle has passed a limit.
class Beyond : public mrroc::Condition {
 public:
  Beyond(const mrroc::Protractor& protractor, double limit)
      : Condition("beyond"), protractor_(&protractor), limit_(limit) {}

 protected:
  bool holds() override { return protractor_->angle() > limit_; }

 private:
  const mrroc::Protractor* protractor_;
  double limit_;  // rad
};
