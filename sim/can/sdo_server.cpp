#include "sim/can/sdo_server.hpp"

#include <algorithm>

namespace mrroc::sim {

using namespace canopen;

namespace {

constexpr std::uint8_t kUploadSegment = 3, kUpload = 2, kDownload = 1, kAbort = 4;  // the command's upper three bits

Object object_of(const can::Frame& request) {
  return {static_cast<std::uint16_t>(can::get(request.bytes(), 1, 2)), request.data[3]};
}

}  // namespace

std::optional<can::Frame> SdoServer::answer(const can::Frame& request) {
  if (request.error || request.remote || request.id != kSdoRequest + node_ || request.size != 8) return {};
  switch (request.data[0] >> 5) {
    case kDownload:
      return download(request);
    case kUpload:
      return upload(request);
    case kUploadSegment:
      return upload_segment(request);
    case kAbort:
      uploading_ = false;
      return {};
    default:
      return abort(request, SdoAbort::unknown_command);
  }
}

can::Frame SdoServer::abort(const can::Frame& request, SdoAbort why) const {
  can::Frame frame{kSdoResponse + node_, {0x80, request.data[1], request.data[2], request.data[3], 0, 0, 0, 0}};
  can::put(frame.data, 4, 4, static_cast<std::uint32_t>(why));
  return frame;
}

can::Frame SdoServer::upload(const can::Frame& request) {
  if (const SdoAbort why = store_.read(object_of(request), value_); why != SdoAbort::none) return abort(request, why);
  can::Frame frame{kSdoResponse + node_, {0, request.data[1], request.data[2], request.data[3], 0, 0, 0, 0}};
  uploading_ = value_.empty() || value_.size() > 4;
  if (!uploading_) {
    frame.data[0] = static_cast<std::uint8_t>(0x43 | (4 - value_.size()) << 2);
    std::copy(value_.begin(), value_.end(), frame.data.begin() + 4);
    return frame;
  }
  sent_ = toggle_ = 0;
  frame.data[0] = 0x41;
  can::put(frame.data, 4, 4, value_.size());
  return frame;
}

can::Frame SdoServer::upload_segment(const can::Frame& request) {
  if (!uploading_) return abort(request, SdoAbort::unknown_command);
  if ((request.data[0] & 0x10) != toggle_) {
    uploading_ = false;
    return abort(request, SdoAbort::toggle_bit);
  }
  toggle_ ^= 0x10;
  const std::size_t count = std::min<std::size_t>(7, value_.size() - sent_);
  const bool last = sent_ + count >= value_.size();
  can::Frame frame{kSdoResponse + node_, {0, 0, 0, 0, 0, 0, 0, 0}};
  frame.data[0] = static_cast<std::uint8_t>((request.data[0] & 0x10) | (7 - count) << 1 | (last ? 1 : 0));
  std::copy_n(value_.begin() + static_cast<std::ptrdiff_t>(sent_), count, frame.data.begin() + 1);
  sent_ += count;
  uploading_ = !last;
  return frame;
}

can::Frame SdoServer::download(const can::Frame& request) {
  const std::uint8_t command = request.data[0];
  if ((command & 2) == 0) return abort(request, SdoAbort::unsupported_access);  // our values are shorter
  const std::size_t size = (command & 1) != 0 ? 4u - ((command >> 2) & 3u) : store_.size(object_of(request));
  const SdoAbort why = store_.write(object_of(request), request.bytes().subspan(4, std::min<std::size_t>(4, size)));
  if (why != SdoAbort::none) return abort(request, why);
  return {kSdoResponse + node_, {0x60, request.data[1], request.data[2], request.data[3], 0, 0, 0, 0}};
}

}  // namespace mrroc::sim
