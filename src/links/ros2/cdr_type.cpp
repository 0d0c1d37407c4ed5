#include "links/ros2/cdr_type.hpp"

#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <dds/ddsi/q_radmin.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>

namespace mrroc::ros2 {
namespace {

/// One message, on its way out or in. It is shared by reference counts of Cyclone.
struct Sample : ddsi_serdata {
  Sample(const ddsi_sertype* of, ddsi_serdata_kind content) : ddsi_serdata{} {
    ddsi_serdata_init(this, of, content);
    hash = of->serdata_basehash;
  }
  CdrBytes bytes;
  std::size_t size = 0;  // without the padding at the end of `bytes`

  /// Cyclone reads up to the next multiple of 4.
  void pad() {
    size = bytes.size();
    bytes.resize((size + 3) / 4 * 4);
  }
};

const Sample& of(const ddsi_serdata* data) noexcept { return *static_cast<const Sample*>(data); }

/// A new sample that `fill` completes; null without memory, for which Cyclone drops the message.
template <class Fill>
ddsi_serdata* make(const ddsi_sertype* type, ddsi_serdata_kind kind, Fill fill) noexcept try {
  auto sample = std::make_unique<Sample>(type, kind);
  fill(sample->bytes);
  sample->pad();
  return sample.release();
} catch (const std::bad_alloc&) {
  return nullptr;
}

void append(CdrBytes& bytes, const void* from, std::size_t count) {
  const auto* const begin = static_cast<const std::byte*>(from);
  bytes.insert(bytes.end(), begin, begin + count);
}

/// No participant makes this one keep more than a few of these messages.
constexpr std::size_t kLargestReceived = 4U << 20;

/// Fragments may overlap. The memory follows the fragments, not the size that the sender states.
ddsi_serdata* from_fragments(const ddsi_sertype* type, ddsi_serdata_kind kind, const nn_rdata* fragment, size_t size) {
  if (size > kLargestReceived) return nullptr;
  return make(type, kind, [&](CdrBytes& bytes) {
    for (; fragment != nullptr; fragment = fragment->nextfrag) {
      const std::size_t end = std::min<std::size_t>(fragment->maxp1, size);
      if (fragment->min > bytes.size() || end <= bytes.size()) continue;
      const auto* const payload = NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment));
      append(bytes, payload + (bytes.size() - fragment->min), end - bytes.size());
    }
  });
}

ddsi_serdata* from_parts(const ddsi_sertype* type, ddsi_serdata_kind kind, ddsrt_msg_iovlen_t count,
                         const ddsrt_iovec_t* parts, size_t size) {
  if (size > kLargestReceived) return nullptr;
  return make(type, kind, [&](CdrBytes& bytes) {
    for (const ddsrt_iovec_t& part : std::span(parts, count))
      append(bytes, part.iov_base, std::min(part.iov_len, size - bytes.size()));
  });
}

ddsi_serdata* from_keyhash(const ddsi_sertype* type, const ddsi_keyhash*) {
  return make(type, SDK_KEY, [](CdrBytes&) {});
}

ddsi_serdata* from_sample(const ddsi_sertype* type, ddsi_serdata_kind kind, const void* sample) {
  return make(type, kind, [&](CdrBytes& bytes) { bytes = *static_cast<const CdrBytes*>(sample); });
}

void copy_out(const ddsi_serdata* data, size_t offset, size_t count, void* into) {
  std::memcpy(into, of(data).bytes.data() + offset, count);
}

ddsi_serdata* lend(const ddsi_serdata* data, size_t offset, size_t count, ddsrt_iovec_t* part) {
  part->iov_base = const_cast<std::byte*>(of(data).bytes.data()) + offset;
  part->iov_len = count;
  return ddsi_serdata_ref(data);
}

void take_back(ddsi_serdata* data, const ddsrt_iovec_t*) { ddsi_serdata_unref(data); }

bool to_sample(const ddsi_serdata* data, void* sample, void** buffer, void*) try {
  if (buffer != nullptr) return false;
  const Sample& own = of(data);
  static_cast<CdrBytes*>(sample)->assign(own.bytes.begin(), own.bytes.begin() + static_cast<std::ptrdiff_t>(own.size));
  return true;
} catch (const std::bad_alloc&) {
  return false;
}

ddsi_serdata* to_untyped(const ddsi_serdata* data) {
  ddsi_serdata* const key = make(data->type, SDK_KEY, [](CdrBytes&) {});
  if (key != nullptr) key->type = nullptr;
  return key;
}

bool untyped_to_sample(const ddsi_sertype*, const ddsi_serdata*, void* sample, void**, void*) {
  static_cast<CdrBytes*>(sample)->clear();
  return true;
}

size_t print(const ddsi_sertype*, const ddsi_serdata* data, char* text, size_t size) {
  const int count = std::snprintf(text, size, "CDR of %zu bytes", of(data).size);
  return count > 0 ? static_cast<size_t>(count) : 0;
}

// Of a sample without a message, which a writer that ends leaves behind, and of samples that Cyclone keeps for a
// reader.

void clear(const ddsi_sertype*, void* samples, size_t count) {
  for (CdrBytes& sample : std::span(static_cast<CdrBytes*>(samples), count)) sample.clear();
}

void resize(void** samples, const ddsi_sertype*, void* old, size_t old_count, size_t count) {
  auto* const kept = static_cast<CdrBytes*>(old);
  auto* const made = count > 0 ? new CdrBytes[count] : nullptr;
  std::move(kept, kept + std::min(old_count, count), made);
  delete[] kept;
  for (std::size_t i = 0; i < count; ++i) samples[i] = &made[i];
}

void release(const ddsi_sertype*, void** samples, size_t count, dds_free_op_t operation) {
  if (count == 0) return;
  for (std::size_t i = 0; i < count; ++i) static_cast<CdrBytes*>(samples[i])->clear();
  if ((operation & DDS_FREE_ALL_BIT) != 0) delete[] static_cast<CdrBytes*>(samples[0]);
}

constexpr ddsi_serdata_ops kSampleOperations{
    .eqkey = [](const ddsi_serdata*, const ddsi_serdata*) { return true; },
    .get_size = [](const ddsi_serdata* data) { return static_cast<std::uint32_t>(of(data).size); },
    .from_ser = &from_fragments,
    .from_ser_iov = &from_parts,
    .from_keyhash = &from_keyhash,
    .from_sample = &from_sample,
    .to_ser = &copy_out,
    .to_ser_ref = &lend,
    .to_ser_unref = &take_back,
    .to_sample = &to_sample,
    .to_untyped = &to_untyped,
    .untyped_to_sample = &untyped_to_sample,
    .free = [](ddsi_serdata* data) { delete static_cast<Sample*>(data); },
    .print = &print,
    .get_keyhash = [](const ddsi_serdata*, ddsi_keyhash* hash, bool) { *hash = {}; },
    .get_sample_size = nullptr,  // of shared memory, which is off
    .from_iox_buffer = nullptr,
};

constexpr ddsi_sertype_ops kTypeOperations{
    .version = ddsi_sertype_v0,
    .arg = nullptr,
    .free =
        [](ddsi_sertype* type) {
          ddsi_sertype_fini(type);
          delete type;
        },
    .zero_samples = &clear,
    .realloc_samples = &resize,
    .free_samples = &release,
    .equal = [](const ddsi_sertype*, const ddsi_sertype*) { return true; },
    .hash = [](const ddsi_sertype*) -> std::uint32_t { return 0; },
    .type_id = nullptr,  // of XTypes, which ROS 2 does not use
    .type_map = nullptr,
    .type_info = nullptr,
    .derive_sertype = nullptr,
    .get_serialized_size = nullptr,
    .serialize_into = nullptr,
};

}  // namespace

links::Entity create_cdr_topic(dds_entity_t participant, const std::string& topic, const std::string& type) {
  auto* sertype = new ddsi_sertype{};
  ddsi_sertype_init(sertype, type.c_str(), &kTypeOperations, &kSampleOperations, true);
  sertype->allowed_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1;
  const dds_entity_t handle = dds_create_topic_sertype(participant, topic.c_str(), &sertype, nullptr, nullptr, nullptr);
  if (handle < 0) ddsi_sertype_unref(sertype);
  return {handle, "topic", topic};
}

}  // namespace mrroc::ros2
