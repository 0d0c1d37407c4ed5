#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/entries/errors_entry.hpp"
#include "config/key_values.hpp"
#include "config/robot_files.hpp"
#include "mrroc/joint_trajectory.hpp"
#include "mrroc/load.hpp"
#include "mrroc/measured_arm.hpp"
#include "mrroc/types.hpp"

namespace mrroc::config {

enum class ClockMode { real, paced, lockstep };

/// Another machine on which processes of the deployment run.
struct HostEntry {
  std::string name;                  ///< used by robots, sensors and [sim]
  std::string address;               ///< name or IPv4 address under which the machines reach it
  std::vector<std::string> command;  ///< starts a program there, whose words follow; empty: ssh to the address
  std::string mrroc;                 ///< path of the `mrroc` command there; empty: as here
  std::filesystem::path folder;      ///< the deployment's folder there; empty: as here
};

struct MpEntry {
  std::string program = "mrroc_mp";  ///< the stock MP when left out; absolute path after loading
  std::filesystem::path states;      ///< the state machine that the stock MP runs, absolute; may be empty
};

/// The driver of a robot or of a sensor, with its own keys: docs/how-to/writing-a-driver.md.
struct DriverEntry : KeyValues {
  std::string name;               ///< folder drivers/<name>
  std::filesystem::path library;  ///< on this process's host, absolute; empty on others
  bool world = false;             ///< its device is part of the simulated world
  std::string controller;         ///< of a sensor: the robots' driver whose controller contains it; else empty
  bool simulated = false;         ///< `stand_in` simulates its device, in the simulated world
  std::string stand_in;           ///< absolute path; empty: a real device
  std::vector<ClockMode> clocks;  ///< under which it works
};

/// The drives of a robot on a CAN bus: docs/how-to/can.md.
struct CanEntry {
  std::string interface;         ///< of the kernel ("can0"), or "unix:PATH" with an absolute path
  std::filesystem::path drives;  ///< the table of its drives, absolute
  std::filesystem::path io;      ///< the table of its I/O nodes, absolute; empty: none
};

struct RobotEntry {
  std::string name;
  std::string type;                  ///< folder robots/<type>
  std::filesystem::path parameters;  ///< named by the deployment, absolute; empty: the type's own
  /// Of its ECP; the stock ECP when left out. Absolute path after loading, on the robot's own host.
  std::string program = "mrroc_ecp";
  DriverEntry driver;                 ///< of its drives
  std::optional<CanEntry> can;        ///< socketcan only
  bool synchronised = true;           ///< the absolute positions are known from the start
  std::optional<int> emergency_stop;  ///< digital input 0..15: off means that the emergency stop is pressed
  std::string force_sensor;           ///< the sensor whose raw readings its EDP uses; may be empty
  /// Limits beyond which the robot stops, in the axes of that sensor: 3 forces (N), 3 torques (N m). The original's.
  Wrench force_limits = (Wrench() << 65, 65, 130, 5, 5, 5).finished();
  Load load;  ///< on the flange, in its frame
  /// `joint_zeros`, `joint_gears`, `link_positions`, `link_rotations`: as measured. A simulated robot stays as its type
  /// describes it.
  MeasuredArm measured_arm;
  std::string host;   ///< name of a [hosts] table; empty: the runner's machine
  std::string mount;  ///< robot that carries it; empty: fixed in the world
  /// In the world, or in the frame of the carrier's site `tool`: `position = [x, y, z]` (m), `rotation = [r, p, y]`
  /// (rad, fixed axes x y z).
  Pose base = Pose::Identity();
  /// Where its base is as measured, in the world: `base_position`, `base_rotation`. What tasks and readings count on; a
  /// simulated robot stays at `base`.
  std::optional<Pose> measured_base;
  std::string edp_program;  ///< key `edp` of its parameter file, else `<type>_edp`; absolute path

  const Pose& known_base() const { return measured_base ? *measured_base : base; }
  RobotFiles files() const { return robot_files(type, parameters); }
  /// Whether the EDP is the type's own; else it serves several types.
  bool own_edp() const { return std::filesystem::path(edp_program).filename() == type + "_edp"; }
  /// Names of the processes of its EDP and of the stand-in for its drives.
  std::string edp_process() const { return name + "_edp"; }
  std::string drives_process() const { return name + "_drives"; }
  /// Whether its motors drive joints of the simulated world.
  bool in_world() const { return driver.world || driver.simulated; }
};

/// Name and unit of one value of a sensor's reading. Names are unique within a sensor, without spaces.
struct Channel {
  std::string name;
  std::string unit;
};

struct SensorEntry : KeyValues {
  std::string name;
  std::string type;   ///< folder sensors/<type>
  std::string robot;  ///< the effector it is mounted on; empty: fixed in the world
  std::string host;   ///< as of a robot; default: the host of its robot; if simulated, of the simulator
  bool interactive = true;
  bool polled = false;                ///< interactive, but Move does not wait for its readings
  double rate = 0;                    ///< Hz, non-interactive only; 1 / rate is a whole number of servo periods
  std::string source = "simulated";   ///< simulated | replay | hardware, or the name of `driver`
  std::optional<DriverEntry> driver;  ///< of its hardware
  std::filesystem::path replay;       ///< played file, absolute
  double frozen_after = 0;            ///< s after which hardware with a constant reading counts as broken; 0: never
  std::vector<double> noise_max;      ///< largest standard deviation of each raw channel; empty or 0: unlimited
  // declared by sensors/<type>/<type>.toml
  std::vector<Channel> channels, raw_channels;              ///< of v and of r
  std::vector<std::string> sources{"simulated", "replay"};  ///< supported sources
  bool wants_effector_state = false;                        ///< e_l of `robot` is sent to its VSP at every tick
  bool gives_wrench = false;                                ///< an EDP may read it as its robot's force sensor
  bool gives_pictures = false;                              ///< as cameras: its keys `width` and `height` are theirs
  /// For that: the library of its type, on the robot's own host, absolute; empty: no EDP reads it.
  std::filesystem::path wrench_library;
  std::string vsp_program;  ///< the type's `<type>_vsp`, absolute path

  /// Of the pictures of a type that gives them, px.
  int picture_width() const { return static_cast<int>(numbers.at("width").at(0)); }
  int picture_height() const { return static_cast<int>(numbers.at("height").at(0)); }
  /// Whether its raw readings are measured in the simulated world.
  bool in_world() const { return source == "simulated" || (driver && driver->simulated); }
  /// Whether a process simulates its hardware, and the name of that process.
  bool has_stand_in() const { return driver && !driver->stand_in.empty(); }
  std::string stand_in_process() const { return name + "_" + driver->name; }
};

/// Puts parts into the simulated world one after the other, like a feeder or a person: docs/reference/simulation.md.
struct FeederEntry {
  std::string name;
  std::vector<std::string> parts;    ///< free bodies of the scene, in the order of their arrival
  std::array<double, 3> position{};  ///< m, in the world, of a part's frame
  std::array<double, 3> spread{};    ///< m: maximum random offset of each coordinate, uniform
  double turn = 0;                   ///< rad, the same about the world's z
  double first = 0;                  ///< s: arrival of the first part
  std::array<double, 2> interval{};  ///< s: shortest and longest time between two parts, uniform
  std::uint32_t seed = 1;            ///< of its random numbers; the same seed gives the same poses and times
};

struct SimEntry {
  std::string host;                   ///< as of a robot; default: the host of the robots that it simulates
  std::filesystem::path scene;        ///< MJCF of the task's scene, absolute
  double timestep = 0.001;            ///< s; the servo period is a whole number of these
  std::string program;                ///< `mrroc_sim`, absolute path
  std::vector<FeederEntry> feeders;   ///< in file order
  std::optional<ErrorsEntry> errors;  ///< none: the world is as the parameter files describe it
};

/// How the processes of the deployment reach each other: docs/how-to/security.md.
struct NetworkEntry {
  std::string interface;       ///< network device or own address; empty: loopback, this machine only
  bool security = false;       ///< DDS Security: only participants with the keys are accepted
  std::filesystem::path keys;  ///< folder of the keys, absolute; empty only without security
};

/// The bridge to ROS 2: docs/how-to/ros2.md.
struct Ros2Entry {
  std::optional<int> domain;     ///< 0..230; nothing: that of the environment's ROS_DOMAIN_ID, or 0
  std::string distro = "jazzy";  ///< of the nodes on the other side
  std::string name_space = "/";  ///< of everything that the bridge publishes
  std::string interface;         ///< network device or own address; empty: as any ROS 2 node chooses
  bool commands = false;         ///< whether nodes may start, pause and stop the task
};

/// An order of the operator to one robot, while no task commands it.
struct RobotOrder {
  std::string robot;
  std::string axis;     ///< of jog and step: a name or a number from 1 of an axis, or x, y, z, rx, ry, rz
  std::string frame;    ///< of jog and step: axes | base | tool | motors
  std::string posture;  ///< of go: in the robot's parameter file
  double amount = 0;    ///< of jog: rad/s or m/s; of step: rad or m; of output: its value
  std::string tool{};   ///< of tool: in the robot's parameter file
};

/// The operator's speed, percent of the programmed one.
inline constexpr double kLeastSpeedPercent = 1, kFullSpeedPercent = 100;

/// A command of the operator at a given tick: written in advance for runs without an operator, or noted in a live run.
struct Event {
  Tick tick = 0;
  /// start | pause | resume | trigger | stop | estop | reset | speed | answer | follow | cancel, or one of `order`: jog
  /// | step | go | hold | synchronise | recover | bias | output | tool
  std::string command{};
  std::string asker{};  ///< of an answer: the sensor or process that asks; else empty
  double value = 0;     ///< the answer: the number, 1 or 0 for yes or no, the index of a choice; the speed, percent
  /// Of an answer: the number of the asker's question, from 1; 0: the one that is open then.
  std::uint64_t question = 0;
  RobotOrder order{};  ///< of commands to a robot; else empty. Of `follow` and `cancel`: the robot alone
  std::shared_ptr<const JointTrajectory> trajectory{};  ///< of `follow`
};

/// A prepared answer to a question of a task program, for runs without an operator: the text that the operator would
/// type.
struct Answer {
  std::string question;  ///< its whole text
  std::string process;   ///< the asking process; empty: any
  std::string answer;
  int line = 0;  ///< of the deployment file, for errors
};

/// A deployment file, validated as a whole: names are unique and at most 31 characters of letters, digits and `_`,
/// every type is installed, every program of this host exists, every named file exists, every carrier of a mounted
/// robot is a robot.
struct Deployment {
  std::filesystem::path file;                       ///< absolute
  std::vector<std::filesystem::path> calibrations;  ///< files whose keys the entries have, absolute
  std::string name;
  ClockMode clock = ClockMode::lockstep;
  double servo_period = 0.002;   ///< s
  int domain = -1;               ///< DDS domain; -1: the runner takes a free one
  double start_timeout = 30;     ///< s of wall time for the start-up barrier
  double heartbeat_timeout = 5;  ///< s of wall time without a heartbeat after which a process counts as silent
  double link_timeout = 0.04;    ///< s of silence between two hosts after which each stops its robots
  double clock_error = 0.001;    ///< s: maximum offset between the ticks of two hosts; default: half a servo period
  std::size_t delta_limit = 1000;
  std::string here;              ///< the host on which this was loaded; empty: the runner's machine
  std::vector<HostEntry> hosts;  ///< in file order
  MpEntry mp;
  std::vector<RobotEntry> robots;    ///< in file order
  std::vector<SensorEntry> sensors;  ///< in file order
  std::optional<SimEntry> sim;
  NetworkEntry network;
  std::optional<Ros2Entry> ros2;  ///< none: no bridge unless `mrroc run` is asked for one
  std::vector<Event> events;      ///< by tick, those of one tick in file order
  std::vector<Answer> answers;    ///< in file order

  /// The entry of this name; throws ConfigurationError that lists the known ones.
  const RobotEntry& robot(const std::string& name) const;
  const SensorEntry& sensor(const std::string& name) const;
  /// The other machines on which processes run, in file order.
  std::vector<const HostEntry*> hosts_used() const;
};

/// Reads and validates; throws ConfigurationError with file, line, key, value and what was expected. Configuration time
/// only: reads the named files, and asks the resolver for every `host` that is not a [hosts] table. Programs are
/// searched only for this machine's host in the deployment: `this_host()`.
Deployment load_deployment(const std::filesystem::path& file);
/// The same for a text that was read before (deployment_text.hpp).
Deployment load_deployment(const std::filesystem::path& file, const std::string& text);

}  // namespace mrroc::config
