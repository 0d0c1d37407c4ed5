// An EDS file of any content, and a simulated node with the object dictionary that it describes.
#include "canopen/eds_file.hpp"
#include "fuzz/fuzz.hpp"
#include "sim/can/object_store.hpp"

namespace {

using namespace mrroc::canopen;

/// The identifier and the mapping of a PDO can be changed only in CiA 301's order.
bool refuses_of_its_pdo(Object object, SdoAbort why) {
  const bool of_pdo = object.index >= kReceivePdoParameters && object.index < kTransmitPdoMapping + 0x200;
  return of_pdo && (why == SdoAbort::invalid_value || why == SdoAbort::wrong_state ||
                    why == SdoAbort::unsupported_access || why == SdoAbort::mapping_too_long);
}

void check(const EdsFile& file) {
  for (const auto& [object, entry] : file.entries()) {
    fuzz::require(!entry.name.empty(), "an object has a name");
    fuzz::require(least(entry.type) <= greatest(entry.type), "a type has limits");
    char address[16];
    std::snprintf(address, sizeof address, "0x%x:%u", object.index, object.sub);
    fuzz::require(file.object(address) == object, "an object has an address");
    const std::string& name = entry.name;  // a part's is found with its object's before it
    fuzz::refuses<std::invalid_argument>(
        [&] { fuzz::require(file.find(file.object(name)) != nullptr, "a name belongs to an object"); });
  }
  mrroc::sim::ObjectStore store(file, 5);
  for (const auto& [object, entry] : file.entries()) {
    std::vector<std::uint8_t> value;
    const bool read = store.read(object, value) == SdoAbort::none;
    fuzz::require(read == entry.readable(), "a readable object is read");
    fuzz::require(!read || size_of(entry.type) == 0 || value.size() == size_of(entry.type), "a value fits its type");
    const SdoAbort why = store.write(object, std::vector<std::uint8_t>(store.size(object)));
    fuzz::require(entry.writable() || why != SdoAbort::none, "a read-only object is not written");
    fuzz::require(!entry.writable() || why == SdoAbort::none || refuses_of_its_pdo(object, why),
                  "a writable object is written, except for PDOs in use");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::refuses<EdsError>([&] { check(EdsFile::parse(fuzz::text_of(data, size), "input.eds")); });
  return 0;
}
