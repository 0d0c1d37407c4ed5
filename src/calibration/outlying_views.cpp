#include "calibration/outlying_views.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <random>

#include "mrroc/errors.hpp"

namespace mrroc::calibration {

namespace {

constexpr std::size_t kFew = 5;  // views of one closed form
constexpr int kTrials = 100;
constexpr std::uint32_t kSeed = 1;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The views that are still used, and the removal of others.
class Selection {
 public:
  Selection(const std::vector<MarkerView>& views, AgreedFit& agreed) : kept(views), agreed_(agreed) {
    agreed_.used.resize(views.size());
    std::iota(agreed_.used.begin(), agreed_.used.end(), std::size_t{0});
  }

  /// Removes the view with the largest of these residuals if it contradicts the others.
  bool remove_worst(std::vector<double>& residuals) {
    const auto worst = std::max_element(residuals.begin(), residuals.end());
    const std::size_t all = agreed_.used.size() + agreed_.left_out.size();
    if (*worst <= kOutlying * median(residuals) || 5 * (agreed_.left_out.size() + 1) > all) return false;
    const auto at = worst - residuals.begin();
    agreed_.left_out.push_back(agreed_.used[static_cast<std::size_t>(at)]);
    agreed_.used.erase(agreed_.used.begin() + at);
    kept.erase(kept.begin() + at);
    residuals.erase(worst);
    return true;
  }

  std::vector<MarkerView> kept;

 private:
  AgreedFit& agreed_;
};

std::vector<double> residuals_of(const RobotModel& model, const HandEyeFit& fit, const std::vector<MarkerView>& views) {
  std::vector<double> residuals;
  residuals.reserve(views.size());
  for (const MarkerView& view : views) residuals.push_back(residual_of(model, fit, view));
  return residuals;
}

/// Nothing where the views turn about one axis only.
std::optional<std::vector<double>> residuals_of_few(const RobotModel& model, const std::vector<MarkerView>& few,
                                                    const std::vector<MarkerView>& views, Carried carried) try {
  return residuals_of(model, closed_form_hand_eye(model, few, carried), views);
} catch (const NonFatalError&) {
  return std::nullopt;
}

/// The residuals of all views with the closed form of few for which their median is least; empty: every closed form has
/// failed.
std::vector<double> least_median_residuals(const RobotModel& model, const std::vector<MarkerView>& views,
                                           Carried carried) {
  std::mt19937 random(kSeed);
  std::vector<MarkerView> shuffled = views;
  std::vector<double> best;
  for (int trial = 0; trial < kTrials; ++trial) {
    for (std::size_t i = 0; i < kFew; ++i) std::swap(shuffled[i], shuffled[i + random() % (shuffled.size() - i)]);
    auto residuals = residuals_of_few(model, {shuffled.begin(), shuffled.begin() + kFew}, views, carried);
    if (residuals && (best.empty() || median(*residuals) < median(best))) best = std::move(*residuals);
  }
  return best;
}

}  // namespace

AgreedFit fit_of_agreeing_views(const RobotModel& model, const std::vector<MarkerView>& views,
                                const HandEyePriors& priors, Carried carried) {
  AgreedFit agreed;
  Selection selection(views, agreed);
  if (views.size() > kFew) {
    std::vector<double> residuals = least_median_residuals(model, views, carried);
    while (!residuals.empty() && selection.remove_worst(residuals)) {
    }
  }
  for (;;) {
    agreed.fit = fit_hand_eye(model, selection.kept, priors, carried);
    std::vector<double> residuals = agreed.fit.residuals;
    if (!selection.remove_worst(residuals)) return agreed;
  }
}

}  // namespace mrroc::calibration
