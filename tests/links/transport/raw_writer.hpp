#pragma once

#include "links/transport/entity.hpp"
#include "links/wire/codec.hpp"

namespace mrroc::links {

/// Writes any given wire form, also one that no `Writer` would send. Its peers accept it.
template <class T>
class RawWriter {
 public:
  RawWriter(Domain& domain, const std::string& topic)
      : topic_(create_topic(domain, WireOf<T>::descriptor(), topic)),
        writer_(dds_create_writer(domain.participant(), topic_.get(), link_writer_qos(domain).get(), nullptr), "writer",
                topic) {}

  void write(const Wire<T>& wire) { EXPECT_EQ(dds_write(writer_.get(), &wire), DDS_RETCODE_OK); }

 private:
  Entity topic_;
  Entity writer_;
};

/// The wire form of `message` with an empty header.
template <class T>
Wire<T> wire_of(const T& message) {
  Wire<T> wire{};
  encode(message, wire);
  return wire;
}

}  // namespace mrroc::links
