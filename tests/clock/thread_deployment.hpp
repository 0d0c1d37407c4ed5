#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "clock/host.hpp"
#include "clock/leave.hpp"
#include "clock/participant.hpp"

namespace mrroc::clock {

/// A host whose participants are threads of the test. They call each other's `arrived` themselves, like a transport
/// that delivers at once.
class ThreadDeployment {
 public:
  using Body = std::function<void(Clock&)>;

  explicit ThreadDeployment(std::vector<std::string> names, HostOptions options = {})
      : host((options.participants = std::move(names), options)) {}
  ~ThreadDeployment() { join(); }

  /// Joins the deployment as `name`, to be registered before `start`.
  Clock& attach(const std::string& name, Part part = Part::task) {
    members_.push_back({attach_clock(host.fd(), name, part), nullptr});
    return *members_.back().clock;
  }
  /// Sets what the thread of the newest member does after the start; then it leaves.
  void body(Body body) { members_.back().body = std::move(body); }
  Clock& add(const std::string& name, Body what, Part part = Part::task) {
    Clock& clock = attach(name, part);
    body(std::move(what));
    return clock;
  }

  void start() {
    for (Member& member : members_)
      threads_.emplace_back([&member] {
        if (member.clock->start()) member.body(*member.clock);
        // leaves as in the destructor, but another thread may still hold the clock
        leave(*member.clock);
      });
    EXPECT_TRUE(host.wait_ready(60).empty());
    host_thread_ = std::thread([this] { host.run(); });
  }
  /// Waits until every body has returned, then ends the time and waits for its thread.
  void join() {
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    host.end();
    if (host_thread_.joinable()) host_thread_.join();
  }

  ClockHost host;

 private:
  struct Member {
    std::unique_ptr<Clock> clock;
    Body body;
  };
  std::vector<Member> members_;
  std::vector<std::thread> threads_;
  std::thread host_thread_;
};

}  // namespace mrroc::clock
