#include "sim/ur/controller_servers.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <deque>
#include <map>
#include <system_error>

#include "drivers/ur/rtde/packet.hpp"
#include "drivers/ur/rtde/protocol_error.hpp"
#include "drivers/ur/rtde/recipe.hpp"

namespace mrroc::sim::ur {

using namespace mrroc::ur::rtde;

namespace {

constexpr std::size_t kMostQueued = 1 << 20;  // bytes of a client that does not read
constexpr std::size_t kMostHeld = 10000;
constexpr std::size_t kLongestProgram = 1 << 20;
constexpr int kStatePeriods = 50;  // of the primary and secondary interfaces

[[noreturn]] void fail(const std::string& what) { throw std::system_error(errno, std::generic_category(), what); }

/// A socket that accepts connections, and its port.
std::pair<int, int> open_listener(const std::string& address, int port) {
  const std::string where = address + ":" + std::to_string(port);
  const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (fd < 0) fail(where);
  const int on = 1;
  ::setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(static_cast<std::uint16_t>(port));
  if (::inet_pton(AF_INET, address.c_str(), &name.sin_addr) != 1) {
    ::close(fd);
    errno = EINVAL;
    fail(where);
  }
  socklen_t size = sizeof name;
  if (::bind(fd, reinterpret_cast<sockaddr*>(&name), size) != 0 || ::listen(fd, 16) != 0 ||
      ::getsockname(fd, reinterpret_cast<sockaddr*>(&name), &size) != 0) {
    const int reason = errno;
    ::close(fd);
    errno = reason;
    fail(where);
  }
  return {fd, ntohs(name.sin_port)};
}

template <class T>
void put(std::vector<std::uint8_t>& bytes, T value) {
  std::array<std::uint8_t, sizeof(T)> memory{};
  WireWriter writer(memory);
  writer.put(value);
  bytes.insert(bytes.end(), memory.begin(), memory.end());
}

/// A package of the primary or secondary interface, or a part of one: its length, its kind, its contents.
std::vector<std::uint8_t> framed(std::uint8_t kind, const std::vector<std::uint8_t>& contents) {
  std::vector<std::uint8_t> bytes;
  put(bytes, static_cast<std::int32_t>(contents.size() + 5));
  put(bytes, kind);
  bytes.insert(bytes.end(), contents.begin(), contents.end());
  return bytes;
}

}  // namespace

struct ControllerServers::Listener {
  Service service;
  int fd;
};

struct ControllerServers::Client {
  Service service;
  int fd;
  std::vector<std::uint8_t> queued;
  bool ended = false;
  // RTDE
  PacketBuffer packets;
  bool started = false;
  std::uint64_t every = 0;  ///< periods between two data packages
  std::vector<const VirtualController::Getter*> outputs;
  Recipe output_recipe;
  struct InputRecipe {
    Recipe recipe;
    std::vector<std::string> names;
    std::vector<const VirtualController::Input*> fields;
  };
  std::map<std::uint8_t, InputRecipe> inputs;
  struct Held {
    std::uint64_t due;  ///< period of the controller
    std::vector<std::uint8_t> bytes;
  };
  std::deque<Held> held;  ///< packages that are delayed
  // the others
  std::string text;
};

ControllerServers::ControllerServers(const Options& options, std::unique_ptr<JointPlant> plant)
    : options_(options), controller_(options.controller, std::move(plant)) {
  try {
    for (const auto& [service, port, taken] :
         {std::tuple{Service::rtde, options.rtde_port, &ports_.rtde},
          std::tuple{Service::dashboard, options.dashboard_port, &ports_.dashboard},
          std::tuple{Service::primary, options.primary_port, &ports_.primary},
          std::tuple{Service::secondary, options.secondary_port, &ports_.secondary},
          std::tuple{Service::realtime, options.realtime_port, &ports_.realtime}}) {
      const auto [fd, bound] = open_listener(options.address, port);
      listeners_.push_back({service, fd});
      *taken = bound;
    }
    wake_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    timer_ = ::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK);
    if (wake_ < 0 || timer_ < 0) fail("eventfd or timerfd");
  } catch (...) {
    for (const Listener& listener : listeners_) ::close(listener.fd);
    throw;
  }
  const auto ns = std::lround(options.controller.period * 1e9);
  const itimerspec interval{{0, ns}, {0, ns}};
  ::timerfd_settime(timer_, 0, &interval, nullptr);
  thread_ = std::thread([this] { run(); });
}

ControllerServers::~ControllerServers() {
  end_.store(true);
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_, &one, sizeof one);
  thread_.join();
  for (const Client& client : clients_) ::close(client.fd);
  for (const Listener& listener : listeners_) ::close(listener.fd);
  ::close(wake_);
  ::close(timer_);
}

std::uint64_t ControllerServers::periods() {
  const std::lock_guard lock(mutex_);
  return steps_;
}

std::size_t ControllerServers::rtde_clients() {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(clients_.begin(), clients_.end(), [](const Client& client) {
    return client.service == Service::rtde && !client.ended;
  }));
}

void ControllerServers::with(const std::function<void(VirtualController&)>& action) {
  const std::lock_guard lock(mutex_);
  action(controller_);
}

void ControllerServers::cut() {
  const std::lock_guard lock(mutex_);
  end_clients(false);
}

void ControllerServers::refuse(bool on) {
  const std::lock_guard lock(mutex_);
  refuse_ = on;
  if (on) end_clients(false);
}

void ControllerServers::lose(int packages) {
  const std::lock_guard lock(mutex_);
  lose_ = packages;
}

void ControllerServers::repeat(int packages) {
  const std::lock_guard lock(mutex_);
  repeat_ = packages;
}

void ControllerServers::delay(int periods) {
  const std::lock_guard lock(mutex_);
  delay_ = periods;
}

void ControllerServers::lose_every(int n) {
  const std::lock_guard lock(mutex_);
  lose_every_ = n;
}

void ControllerServers::postpone(int periods) {
  const std::lock_guard lock(mutex_);
  postpone_ = periods;
}

void ControllerServers::send_garbage() {
  const std::lock_guard lock(mutex_);
  for (Client& client : clients_)
    if (client.service == Service::rtde)
      for (int i = 0; i < 64; ++i) client.queued.push_back(static_cast<std::uint8_t>(0xa5 ^ i));
}

void ControllerServers::restart() {
  const std::lock_guard lock(mutex_);
  end_clients(true);
  controller_.restart();
}

void ControllerServers::end_clients(bool all) {
  for (Client& client : clients_) client.ended = client.ended || all || client.service == Service::rtde;
}

void ControllerServers::run() {
  while (!end_.load()) {
    std::vector<pollfd> entries{{wake_, POLLIN, 0}, {timer_, POLLIN, 0}};
    for (const Listener& listener : listeners_) entries.push_back({listener.fd, POLLIN, 0});
    std::vector<Client*> polled;
    {
      const std::lock_guard lock(mutex_);
      for (Client& client : clients_) {
        entries.push_back({client.fd, static_cast<short>(client.queued.empty() ? POLLIN : POLLIN | POLLOUT), 0});
        polled.push_back(&client);
      }
    }
    ::poll(entries.data(), entries.size(), -1);
    const std::lock_guard lock(mutex_);
    std::uint64_t periods = 0;
    if (::read(timer_, &periods, sizeof periods) != sizeof periods) periods = 0;
    for (std::size_t i = 0; i < listeners_.size(); ++i)
      if (entries[2 + i].revents != 0) accept(listeners_[i]);
    for (std::size_t i = 0; i < polled.size(); ++i)
      if ((entries[2 + listeners_.size() + i].revents & (POLLIN | POLLHUP | POLLERR)) != 0) take(*polled[i]);
    for (; periods > 0; --periods) step();
    for (Client& client : clients_) flush(client);
    std::erase_if(clients_, [](const Client& client) {
      if (client.ended) ::close(client.fd);
      return client.ended;
    });
  }
}

void ControllerServers::step() {
  controller_.step();
  ++steps_;
  const bool loses = lose_ > 0 || (lose_every_ > 0 && steps_ % static_cast<std::uint64_t>(lose_every_) == 0);
  for (Client& client : clients_) {
    if (client.service == Service::rtde && client.started && steps_ % client.every == 0 && !loses) send_state(client);
    const bool states = client.service == Service::primary || client.service == Service::secondary;
    if (states && steps_ % kStatePeriods == 0) send_robot_state(client);
    const bool reads = client.queued.size() < kMostQueued;
    for (; reads && !client.held.empty() && client.held.front().due <= steps_; client.held.pop_front()) {
      const std::vector<std::uint8_t>& bytes = client.held.front().bytes;
      client.queued.insert(client.queued.end(), bytes.begin(), bytes.end());
    }
  }
  for (int* const rest : {&lose_, &repeat_, &delay_})
    if (*rest > 0) --*rest;
}

void ControllerServers::accept(Listener& listener) {
  const int fd = ::accept4(listener.fd, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (fd < 0) return;
  if (refuse_ && listener.service == Service::rtde) {
    ::close(fd);
    return;
  }
  const int on = 1;
  ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  Client& client = clients_.emplace_back();
  client.service = listener.service;
  client.fd = fd;
  constexpr std::string_view kGreeting = "Connected: Universal Robots Dashboard Server\n";
  if (listener.service == Service::dashboard) client.queued.assign(kGreeting.begin(), kGreeting.end());
}

void ControllerServers::take(Client& client) {
  if (client.ended) return;
  for (;;) {
    std::array<std::uint8_t, 4096> bytes{};
    const bool rtde = client.service == Service::rtde;
    const std::span<std::uint8_t> space = rtde ? client.packets.free_space() : std::span<std::uint8_t>(bytes);
    const ssize_t size = ::recv(client.fd, space.data(), space.size(), 0);
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (size <= 0) {
      client.ended = true;
      return;
    }
    if (rtde) {
      client.packets.filled(static_cast<std::size_t>(size));
      take_rtde(client);
    } else {
      client.text.append(reinterpret_cast<const char*>(bytes.data()), static_cast<std::size_t>(size));
      client.service == Service::dashboard ? take_lines(client) : take_programs(client);
    }
    if (client.ended) return;
  }
}

void ControllerServers::answer(Client& client, std::uint8_t type, const std::vector<std::uint8_t>& payload) {
  append_packet(client.queued, static_cast<PacketType>(type), payload);
}

void ControllerServers::take_rtde(Client& client) {
  Packet packet;
  PacketBuffer::Next next = PacketBuffer::Next::incomplete;
  try {
    while ((next = client.packets.next(packet)) == PacketBuffer::Next::packet) {
      const auto type = static_cast<std::uint8_t>(packet.type);
      switch (packet.type) {
        case PacketType::request_protocol_version: {
          const auto request = VersionRequest::from_payload(packet.payload);
          answer(client, type, Acceptance{request.version == kProtocolVersion}.payload());
          break;
        }
        case PacketType::get_urcontrol_version:
          answer(client, type, controller_.version().payload());
          break;
        case PacketType::setup_outputs:
          set_up_outputs(client, packet.payload);
          break;
        case PacketType::setup_inputs:
          set_up_inputs(client, packet.payload);
          break;
        case PacketType::start:
        case PacketType::pause: {
          const bool starts = packet.type == PacketType::start;
          const bool accepted = client.output_recipe.id != 0;
          client.started = starts && accepted;
          answer(client, type, Acceptance{accepted}.payload());
          break;
        }
        case PacketType::data_package:
          take_data(client, packet.payload);
          break;
        case PacketType::text_message:
          break;
      }
    }
  } catch (const ProtocolError& error) {
    answer(client, static_cast<std::uint8_t>(PacketType::text_message),
           TextMessage{error.what(), "RTDE", TextMessage::Level::error}.payload());
    client.ended = true;
  }
  if (next == PacketBuffer::Next::broken) client.ended = true;
}

void ControllerServers::set_up_outputs(Client& client, Bytes payload) {
  const auto request = OutputsRequest::from_payload(payload);
  SetupReply reply{1, {}};
  client.outputs.clear();
  client.output_recipe = {1, {}};
  for (const std::string& name : request.names) {
    const VirtualController::Getter* const field = controller_.output(name);
    if (field == nullptr) {
      reply.types.emplace_back(kNotFound);
      reply.id = client.output_recipe.id = 0;
      continue;
    }
    const FieldType type = type_of((*field)());
    reply.types.emplace_back(name_of(type));
    client.outputs.push_back(field);
    client.output_recipe.types.push_back(type);
  }
  const double full = 1 / options_.controller.period;
  const double frequency = std::clamp(std::isfinite(request.frequency) ? request.frequency : full, 1.0, full);
  client.every = static_cast<std::uint64_t>(std::lround(full / frequency));
  answer(client, static_cast<std::uint8_t>(PacketType::setup_outputs), reply.payload());
}

bool ControllerServers::is_in_use(const Client& own, const std::string& name) const {
  return std::any_of(clients_.begin(), clients_.end(), [&](const Client& client) {
    return &client != &own && !client.ended &&
           std::any_of(client.inputs.begin(), client.inputs.end(), [&name](const auto& entry) {
             const auto& names = entry.second.names;
             return std::find(names.begin(), names.end(), name) != names.end();
           });
  });
}

void ControllerServers::set_up_inputs(Client& client, Bytes payload) {
  const auto request = InputsRequest::from_payload(payload);
  const auto id = static_cast<std::uint8_t>(client.inputs.size() + 1);
  SetupReply reply{id, {}};
  Client::InputRecipe recipe{{id, {}}, request.names, {}};
  for (const std::string& name : request.names) {
    const VirtualController::Input* const field = controller_.input(name);
    const bool used = field != nullptr && is_in_use(client, name);
    if (field == nullptr || used) {
      reply.types.emplace_back(used ? kInUse : kNotFound);
      reply.id = 0;
      continue;
    }
    reply.types.emplace_back(name_of(field->type));
    recipe.recipe.types.push_back(field->type);
    recipe.fields.push_back(field);
  }
  if (reply.id != 0) client.inputs.emplace(id, std::move(recipe));
  answer(client, static_cast<std::uint8_t>(PacketType::setup_inputs), reply.payload());
}

void ControllerServers::take_data(Client& client, Bytes payload) {
  const auto found = payload.empty() ? client.inputs.end() : client.inputs.find(payload[0]);
  if (found == client.inputs.end()) throw ProtocolError("a data package of an unknown recipe");
  std::vector<Value> values(found->second.fields.size());
  if (!decode_data(found->second.recipe, payload, values))
    throw ProtocolError("a data package of another length than its recipe");
  for (std::size_t i = 0; i < values.size(); ++i) found->second.fields[i]->set(values[i]);
}

void ControllerServers::send_state(Client& client) {
  std::vector<Value> values;
  for (const VirtualController::Getter* field : client.outputs) values.push_back((*field)());
  std::vector<std::uint8_t> bytes(kHeaderSize + client.output_recipe.size());
  encode_data(client.output_recipe, values, bytes);
  const std::uint64_t due = steps_ + static_cast<std::uint64_t>(std::max(delay_, postpone_));
  for (int copies = repeat_ > 0 ? 2 : 1; copies > 0 && client.held.size() < kMostHeld; --copies)
    client.held.push_back({client.held.empty() ? due : std::max(due, client.held.back().due), bytes});
}

void ControllerServers::take_lines(Client& client) {
  for (std::size_t end = 0; (end = client.text.find('\n')) != std::string::npos;) {
    std::string line = client.text.substr(0, end);
    client.text.erase(0, end + 1);
    if (line.ends_with('\r')) line.pop_back();
    const std::string reply = (line == "quit" ? "Disconnected" : controller_.dashboard(line)) + "\n";
    client.queued.insert(client.queued.end(), reply.begin(), reply.end());
    if (line == "quit") client.ended = true;
  }
  if (client.text.size() > kLongestProgram) client.ended = true;
}

/// A program ends with a line "end" that is not indented. Other lines, single commands, are skipped.
void ControllerServers::take_programs(Client& client) {
  std::string& text = client.text;
  while (!text.empty()) {
    const std::size_t line_end = text.find('\n');
    if (line_end == std::string::npos) break;
    if (!text.starts_with("def ")) {
      text.erase(0, line_end + 1);
      continue;
    }
    const std::size_t end = text.find("\nend\n");
    if (end == std::string::npos) break;
    controller_.start_program(text.substr(0, end + 5));
    text.erase(0, end + 5);
  }
  if (text.size() > kLongestProgram) client.ended = true;
}

void ControllerServers::send_robot_state(Client& client) {
  if (client.queued.size() > kMostQueued) return;
  const bool emergency = (controller_.safety_status() & 1u << 7) != 0;
  const bool protective = (controller_.safety_status() & 1u << 2) != 0;
  std::vector<std::uint8_t> mode;
  put(mode, static_cast<std::uint64_t>(controller_.time() * 1e6));
  const bool power = (controller_.robot_status() & 1u) != 0, runs = (controller_.robot_status() & 2u) != 0;
  for (const bool flag : {true, true, power, emergency, protective, runs, false})
    put(mode, static_cast<std::uint8_t>(flag));
  put(mode, static_cast<std::uint8_t>(controller_.robot_mode()));
  put(mode, std::uint8_t{0});
  for (const double value : {controller_.speed_slider(), 1.0, 1.0}) put(mode, value);
  put(mode, std::uint8_t{0});
  std::vector<std::uint8_t> joints;
  for (std::size_t i = 0; i < 6; ++i) {
    for (const double value : {controller_.position()[i], controller_.position()[i], controller_.velocity()[i]})
      put(joints, value);
    for (const float value : {0.0F, 48.0F, 30.0F, 30.0F}) put(joints, value);
    put(joints, static_cast<std::uint8_t>(controller_.joint_mode(i)));
  }
  std::vector<std::uint8_t> parts = framed(0, mode);
  const std::vector<std::uint8_t> second = framed(1, joints);
  parts.insert(parts.end(), second.begin(), second.end());
  const std::vector<std::uint8_t> bytes = framed(16, parts);
  client.queued.insert(client.queued.end(), bytes.begin(), bytes.end());
}

void ControllerServers::flush(Client& client) {
  if (client.queued.empty()) return;
  const ssize_t size = ::send(client.fd, client.queued.data(), client.queued.size(), MSG_NOSIGNAL);
  if (size > 0) client.queued.erase(client.queued.begin(), client.queued.begin() + size);
  if (size < 0 && errno != EAGAIN && errno != EINTR) client.ended = true;
}

}  // namespace mrroc::sim::ur
