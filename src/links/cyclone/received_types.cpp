#include "links/cyclone/received_types.hpp"

#include <dds/ddsi/ddsi_plist.h>
#include <dds/ddsi/ddsi_typelib.h>
#include <dds/ddsi/ddsi_xt_impl.h>

#include "links/cyclone/cyclone_function.hpp"

namespace mrroc::links {
namespace {

using Valid = decltype(&ddsi_typeinfo_valid);

Valid cyclone_valid() noexcept {
  static const auto function = cyclone_function<Valid>("ddsi_typeinfo_valid");
  return function;
}

}  // namespace

void mend_received_types() noexcept { cyclone_valid(); }

}  // namespace mrroc::links

extern "C" bool ddsi_typeinfo_valid(const ddsi_typeinfo_t* type) {
  return type->x.minimal.typeid_with_size.type_id._d == DDS_XTypes_EK_MINIMAL &&
         type->x.complete.typeid_with_size.type_id._d == DDS_XTypes_EK_COMPLETE && mrroc::links::cyclone_valid()(type);
}
