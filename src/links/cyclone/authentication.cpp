#include "links/cyclone/authentication.hpp"

#include <dds/dds.h>
#include <dds/ddsrt/string.h>
#include <dds/security/dds_security_api_authentication.h>
#include <dlfcn.h>

#include <cstdint>

#include "links/cyclone/cyclone_function.hpp"
#include "mrroc/errors.hpp"

struct ddsi_domaingv;
struct dds_security_fsm;

namespace mrroc::links {
namespace {

// of dds/security/dds_security_api.h, which is not C++, as dds_security_fsm.h
using InitFunction = int (*)(const char* argument, void** context, ddsi_domaingv* domain);
using FinalizeFunction = int (*)(void* context);
using Dispatch = void (*)(dds_security_fsm*, std::int32_t event, bool first);

/// The functions of Cyclone's plug-in. Written by the first `authentication_library`, before Cyclone calls any of it.
struct Plugin {
  InitFunction init = nullptr;
  FinalizeFunction finalize = nullptr;
  DDS_Security_authentication_validate_remote_identity validate_remote_identity = nullptr;
  DDS_Security_authentication_process_handshake process_handshake = nullptr;
};

Plugin plugin;

/// The event of a hand-shake's state machine that reports the peer's session keys: EVENT_RECV_CRYPTO_TOKENS of
/// Cyclone's ddsi_handshake.c.
constexpr std::int32_t kSessionKeysReceived = 104;

/// Whether this thread, Cyclone's hand-shake thread, has made a final message whose hand-shake has not entered its next
/// state yet.
thread_local bool makes_final_message = false;

Dispatch cyclone_dispatch() noexcept {
  static const auto function = cyclone_function<Dispatch>("dds_security_fsm_dispatch");
  return function;
}

template <class Function>
Function find(void* library, const char* name) {
  return reinterpret_cast<Function>(::dlsym(library, name));
}

void open_plugin(const std::filesystem::path& path) {
  // as Cyclone opens it
  void* const library = ::dlopen(path.c_str(), RTLD_GLOBAL | RTLD_NOW);
  if (library != nullptr) {
    plugin.init = find<InitFunction>(library, "init_authentication");
    plugin.finalize = find<FinalizeFunction>(library, "finalize_authentication");
  }
  if (plugin.init == nullptr || plugin.finalize == nullptr) {
    const char* const error = ::dlerror();
    throw SystemError(
        ErrorCode::resources,
        "DDS security: " + (error != nullptr ? error : path.string() + " is not an authentication plug-in"));
  }
}

DDS_Security_ValidationResult_t validate_remote_identity(
    dds_security_authentication* instance, DDS_Security_IdentityHandle* remote,
    DDS_Security_AuthRequestMessageToken* local_token, const DDS_Security_AuthRequestMessageToken* remote_token,
    const DDS_Security_IdentityHandle local, const DDS_Security_IdentityToken* identity,
    const DDS_Security_GUID_t* participant, DDS_Security_SecurityException* exception) {
  const auto result = plugin.validate_remote_identity(instance, remote, local_token, remote_token, local, identity,
                                                      participant, exception);
  // Cyclone frees it with the token, with its own allocator
  if (local_token != nullptr && local_token->class_id == nullptr) local_token->class_id = ddsrt_strdup("");
  return result;
}

DDS_Security_ValidationResult_t process_handshake(dds_security_authentication* instance,
                                                  DDS_Security_HandshakeMessageToken* sent,
                                                  const DDS_Security_HandshakeMessageToken* received,
                                                  const DDS_Security_HandshakeHandle handshake,
                                                  DDS_Security_SecurityException* exception) {
  const auto result = plugin.process_handshake(instance, sent, received, handshake, exception);
  makes_final_message = result == DDS_SECURITY_VALIDATION_OK_FINAL_MESSAGE;
  return result;
}

}  // namespace

AuthenticationLibrary authentication_library(const std::filesystem::path& library) {
  [[maybe_unused]] static const bool opened = (open_plugin(library), true);
  cyclone_dispatch();
  // dlopen takes an empty name, here that of a file: URL, for the program itself, which exports them (CMakeLists.txt)
  return {.path = "file://", .init = "mrroc_init_authentication", .finalize = "mrroc_finalize_authentication"};
}

}  // namespace mrroc::links

extern "C" {

int mrroc_init_authentication(const char* argument, void** context, ddsi_domaingv* domain) {
  using namespace mrroc::links;
  const int result = plugin.init(argument, context, domain);
  if (result != 0 || *context == nullptr) return result;
  auto& functions = *static_cast<dds_security_authentication*>(*context);
  plugin.validate_remote_identity = functions.validate_remote_identity;
  functions.validate_remote_identity = validate_remote_identity;
  plugin.process_handshake = functions.process_handshake;
  functions.process_handshake = process_handshake;
  return result;
}

// both instead of Cyclone's own, which it finds here first
void dds_security_fsm_dispatch(dds_security_fsm* handshake, std::int32_t event, bool first) {
  using namespace mrroc::links;
  // first: the next state's event, dispatched when the final message has been sent
  if (first) makes_final_message = false;
  if (makes_final_message && event == kSessionKeysReceived) return;
  cyclone_dispatch()(handshake, event, first);
}

void dds_security_fsm_set_timeout(dds_security_fsm*, void (*)(dds_security_fsm*, void*), dds_time_t) {}

int mrroc_finalize_authentication(void* context) { return mrroc::links::plugin.finalize(context); }
}
