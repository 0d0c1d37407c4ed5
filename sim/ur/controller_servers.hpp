#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "sim/ur/virtual_controller.hpp"

namespace mrroc::sim::ur {

/// The servers of a UR controller on TCP ports of one address, for any number of clients each:
///
///   30004  RTDE: data packages at 500 Hz and its fractions
///   29999  dashboard server
///   30001  primary and 30002 secondary interface: take programs, send the robot's state ten times a second
///   30003  real-time interface: takes programs, sends the robot's state in each period, of a CB3 at 125 Hz
///
/// One thread serves all of them and steps the controller on a clock of its own, faster than the wall clock by
/// `clock_rate`. Periods that the host has missed are made up for, so the controller's time does not fall behind.
///
/// In lockstep the controller has no clock: each call of `advance` is one period, which waits for the set-points of the
/// client that writes `lockstep_register`, the driver.
class ControllerServers {
 public:
  struct Options {
    std::string address = "127.0.0.1";
    int rtde_port = 30004;  ///< of each port: 0 takes a free one
    int dashboard_port = 29999;
    int primary_port = 30001;
    int secondary_port = 30002;
    int realtime_port = 30003;
    double clock_rate = 1;  ///< seconds of the controller in a second of the host
    /// Input register that holds the number of the driver's set-points; nothing: the controller has its own clock.
    std::optional<int> lockstep_register;
    VirtualController::Options controller;
  };
  struct Ports {
    int rtde = 0, dashboard = 0, primary = 0, secondary = 0, realtime = 0;
  };

  /// Opens the ports; the thread starts. Throws std::system_error that names the address and the port.
  ControllerServers(const Options& options, std::unique_ptr<JointPlant> plant);
  ~ControllerServers();
  ControllerServers(const ControllerServers&) = delete;
  ControllerServers& operator=(const ControllerServers&) = delete;

  const Ports& ports() const noexcept { return ports_; }

  /// How a period of lockstep has ended.
  enum class Period {
    answered,        ///< the set-points of the period have come
    without_driver,  ///< no client writes them
    unanswered       ///< the timeout came first
  };
  /// Period k of lockstep, from 0: sends the packages of k, whose timestamp is that of the period's begin, waits for
  /// set-points with the number k + 1, and moves the joints. `timeout` of wall time, ns. One thread.
  Period advance(std::int64_t timeout);

  std::uint64_t periods();     ///< of the controller so far; any thread
  std::size_t rtde_clients();  ///< connected now; any thread

  /// Calls `action` with the controller between two periods. Any thread.
  void with(const std::function<void(VirtualController&)>& action);

  // disturbances of the RTDE connections; any thread
  void cut();                  ///< ends all connections
  void refuse(bool on);        ///< ends all connections, and accepts no new one
  void lose(int packages);     ///< does not send the next ones
  void lose_every(int n);      ///< does not send each n-th; 0: sends all
  void repeat(int packages);   ///< sends each of the next ones twice
  void delay(int periods);     ///< holds packages back, then sends all of them
  void postpone(int periods);  ///< sends each so much later, until it is 0
  void send_garbage();         ///< bytes that are not RTDE
  void restart();              ///< ends all connections of all servers and boots

 private:
  enum class Service { rtde, dashboard, primary, secondary, realtime };
  struct Client;
  struct Listener;

  void run();
  void wake() const noexcept;
  void step();
  void send_packages();
  bool has_driver() const;
  std::string lockstep_field() const;
  void accept(Listener& listener);
  void take(Client& client);
  void take_rtde(Client& client);
  void take_lines(Client& client);
  void take_programs(Client& client);
  void answer(Client& client, std::uint8_t type, const std::vector<std::uint8_t>& payload);
  void set_up_outputs(Client& client, mrroc::ur::rtde::Bytes payload);
  void set_up_inputs(Client& client, mrroc::ur::rtde::Bytes payload);
  void take_data(Client& client, mrroc::ur::rtde::Bytes payload);
  bool is_in_use(const Client& own, const std::string& name) const;
  void send_state(Client& client);
  static void send(Client& client, const std::vector<std::uint8_t>& bytes);
  static void flush(Client& client);
  void end_clients(bool all);

  const Options options_;
  Ports ports_;
  std::mutex mutex_;  ///< of all below
  VirtualController controller_;
  std::vector<Listener> listeners_;
  std::list<Client> clients_;
  std::uint64_t steps_ = 0;
  int lose_ = 0, lose_every_ = 0, repeat_ = 0, delay_ = 0, postpone_ = 0;
  bool refuse_ = false;
  std::int32_t answered_ = 0;  ///< lockstep: number of the driver's newest set-points
  std::condition_variable answered_or_gone_;
  int wake_ = -1, timer_ = -1;
  std::atomic<bool> end_{false};
  std::thread thread_;
};

}  // namespace mrroc::sim::ur
