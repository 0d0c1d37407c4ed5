#include "process/mailbox.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <deque>

#include "mrroc/errors.hpp"

namespace mrroc::process::mailbox_test {
namespace {

Message parcel(const std::string& label, std::uint64_t number) {
  Message parcel;
  parcel.label.assign(label);
  parcel.fingerprint = number;
  return parcel;
}

TEST(Mailbox, GivesTheOldestOfALabelAndKeepsTheOthers) {
  EXPECT_TRUE(rc::check([] {
    Mailbox mailbox;
    std::deque<std::pair<std::string, std::uint64_t>> model;
    for (std::uint64_t i = 1; i < 200; ++i) {
      const auto label = *rc::gen::element<std::string>("a", "b", "c");
      if (*rc::gen::arbitrary<bool>()) {
        if (model.size() == Mailbox::kCapacity) {
          RC_ASSERT_THROWS_AS(mailbox.put(parcel(label, i)), NonFatalError);
          continue;
        }
        mailbox.put(parcel(label, i));
        model.emplace_back(label, i);
        continue;
      }
      const auto expected =
          std::find_if(model.begin(), model.end(), [&](const auto& entry) { return entry.first == label; });
      RC_ASSERT(mailbox.has(label) == (expected != model.end()));
      Message taken;
      RC_ASSERT(mailbox.take(label, taken) == (expected != model.end()));
      if (expected == model.end()) continue;
      RC_ASSERT(taken.fingerprint == expected->second);
      model.erase(expected);
    }
  }));
}

}  // namespace
}  // namespace mrroc::process::mailbox_test
