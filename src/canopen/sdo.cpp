#include "canopen/sdo.hpp"

#include <algorithm>

namespace mrroc::canopen {

namespace {

// command specifiers, CiA 301 7.2.4.3: upper three bits
constexpr std::uint8_t kDownloadSegment = 0x00, kDownload = 0x20, kUpload = 0x40, kUploadSegment = 0x60, kAbort = 0x80;
constexpr std::uint8_t kAnsweredUploadSegment = 0x00, kAnsweredDownloadSegment = 0x20, kAnsweredUpload = 0x40,
                       kAnsweredDownload = 0x60;
constexpr std::uint8_t kSpecifier = 0xe0, kToggle = 0x10, kExpedited = 0x02, kSizeTold = 0x01, kLast = 0x01;
constexpr std::size_t kInSegment = 7;

struct AbortText {
  std::uint32_t code;
  std::string_view text;
};

// CiA 301, table 22
constexpr AbortText kAbortTexts[] = {
    {0x05030000, "toggle bit not alternated"},
    {0x05040000, "SDO protocol timed out"},
    {0x05040001, "command specifier not valid or unknown"},
    {0x05040002, "invalid block size"},
    {0x05040003, "invalid sequence number"},
    {0x05040004, "CRC error"},
    {0x05040005, "out of memory"},
    {0x06010000, "unsupported access to an object"},
    {0x06010001, "attempt to read a write only object"},
    {0x06010002, "attempt to write a read only object"},
    {0x06020000, "object does not exist in the object dictionary"},
    {0x06040041, "object cannot be mapped to the PDO"},
    {0x06040042, "the number and length of the objects to be mapped exceed PDO length"},
    {0x06040043, "general parameter incompatibility"},
    {0x06040047, "general internal incompatibility in the device"},
    {0x06060000, "access failed due to a hardware error"},
    {0x06070010, "data type does not match, length of service parameter does not match"},
    {0x06070012, "data type does not match, length of service parameter too high"},
    {0x06070013, "data type does not match, length of service parameter too low"},
    {0x06090011, "sub-index does not exist"},
    {0x06090030, "invalid value for parameter"},
    {0x06090031, "value of parameter written too high"},
    {0x06090032, "value of parameter written too low"},
    {0x06090036, "maximum value is less than minimum value"},
    {0x060a0023, "resource not available"},
    {0x08000000, "general error"},
    {0x08000020, "data cannot be transferred or stored to the application"},
    {0x08000021, "data cannot be transferred because of local control"},
    {0x08000022, "data cannot be transferred because of the present device state"},
    {0x08000023, "object dictionary dynamic generation failed or there is none"},
    {0x08000024, "no data available"},
};

}  // namespace

std::string_view describe(SdoAbort abort) noexcept {
  if (abort == SdoAbort::none) return "no abort";
  const auto code = static_cast<std::uint32_t>(abort);
  const auto* const found = std::find_if(std::begin(kAbortTexts), std::end(kAbortTexts),
                                         [code](const AbortText& text) { return text.code == code; });
  return found != std::end(kAbortTexts) ? found->text : "unknown abort code";
}

can::Frame SdoTransfer::request(std::uint8_t command) const noexcept {
  can::Frame frame{kSdoRequest + node_, {command, 0, 0, object_.sub, 0, 0, 0, 0}};
  can::put(frame.data, 1, 2, object_.index);
  return frame;
}

can::Frame SdoTransfer::upload(NodeId node, Object object) noexcept {
  status_ = Status::waiting;
  writes_ = segmented_ = begun_ = false;
  node_ = node;
  object_ = object;
  abort_ = SdoAbort::none;
  size_ = sent_ = told_ = 0;
  toggle_ = 0;
  return request(kUpload);
}

can::Frame SdoTransfer::download(NodeId node, Object object, std::span<const std::uint8_t> value) noexcept {
  upload(node, object);
  writes_ = true;
  size_ = std::min(value.size(), value_.size());
  std::copy_n(value.begin(), size_, value_.begin());
  segmented_ = size_ == 0 || size_ > 4;  // an expedited transfer has at least one byte
  if (segmented_) {
    can::Frame frame = request(kDownload | kSizeTold);
    can::put(frame.data, 4, 4, size_);
    return frame;
  }
  const auto unused = static_cast<std::uint8_t>((4 - size_) << 2);
  can::Frame frame = request(static_cast<std::uint8_t>(kDownload | unused | kExpedited | kSizeTold));
  std::copy_n(value_.begin(), size_, frame.data.begin() + 4);
  return frame;
}

can::Frame SdoTransfer::refuse(SdoAbort why) noexcept {
  status_ = Status::refused;
  abort_ = why;
  can::Frame frame = request(kAbort);
  can::put(frame.data, 4, 4, static_cast<std::uint32_t>(why));
  return frame;
}

bool SdoTransfer::take(const can::Frame& frame, can::Frame& next) noexcept {
  next = {};
  if (status_ != Status::waiting || frame.error || frame.remote || frame.fd || frame.id != kSdoResponse + node_ ||
      frame.size != 8)
    return false;
  const std::uint8_t specifier = frame.data[0] & kSpecifier;
  const bool is_segment = specifier == kAnsweredUploadSegment || specifier == kAnsweredDownloadSegment;
  // answers to an earlier, abandoned request: for another object, or a segment before segments are possible
  if (is_segment ? !begun_ : Object{static_cast<std::uint16_t>(can::get(frame.data, 1, 2)), frame.data[3]} != object_)
    return false;
  if (specifier == kAbort) {
    status_ = Status::refused;
    abort_ = static_cast<SdoAbort>(can::get(frame.data, 4, 4));
  } else if (!writes_) {
    next = begun_ ? take_segment(frame) : take_upload(frame);
  } else if (specifier == kAnsweredDownload && !begun_) {
    begun_ = true;
    if (segmented_)
      next = next_segment();
    else
      status_ = Status::done;
  } else if (specifier == kAnsweredDownloadSegment) {
    if ((frame.data[0] & kToggle) != toggle_) {
      next = refuse(SdoAbort::toggle_bit);
    } else {
      toggle_ ^= kToggle;
      if (sent_ >= size_)
        status_ = Status::done;
      else
        next = next_segment();
    }
  } else {
    next = refuse(SdoAbort::unknown_command);
  }
  return true;
}

can::Frame SdoTransfer::take_upload(const can::Frame& frame) noexcept {
  const std::uint8_t command = frame.data[0];
  if ((command & kSpecifier) != kAnsweredUpload) return refuse(SdoAbort::unknown_command);
  if ((command & kExpedited) != 0) {
    size_ = (command & kSizeTold) != 0 ? 4u - ((command >> 2) & 3u) : 4u;
    std::copy_n(frame.data.begin() + 4, size_, value_.begin());
    status_ = Status::done;
    return {};
  }
  if ((command & kSizeTold) != 0 && can::get(frame.data, 4, 4) > kMaxValue) return refuse(SdoAbort::out_of_memory);
  told_ = (command & kSizeTold) != 0 ? can::get(frame.data, 4, 4) : kMaxValue + 1;
  begun_ = segmented_ = true;
  can::Frame segment = request(kUploadSegment);
  std::fill(segment.data.begin() + 1, segment.data.end(), std::uint8_t{0});
  return segment;
}

can::Frame SdoTransfer::take_segment(const can::Frame& frame) noexcept {
  const std::uint8_t command = frame.data[0];
  if ((command & kSpecifier) != kAnsweredUploadSegment) return refuse(SdoAbort::unknown_command);
  if ((command & kToggle) != toggle_) return refuse(SdoAbort::toggle_bit);
  const std::size_t count = kInSegment - ((command >> 1) & 7u);
  if (size_ + count > kMaxValue) return refuse(SdoAbort::out_of_memory);
  std::copy_n(frame.data.begin() + 1, count, value_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += count;
  if ((command & kLast) != 0) {
    if (told_ <= kMaxValue && told_ != size_) return refuse(SdoAbort::wrong_length);
    status_ = Status::done;
    return {};
  }
  toggle_ ^= kToggle;
  can::Frame segment{kSdoRequest + node_, {0, 0, 0, 0, 0, 0, 0, 0}};
  segment.data[0] = kUploadSegment | toggle_;
  return segment;
}

can::Frame SdoTransfer::next_segment() noexcept {
  const std::size_t count = std::min(kInSegment, size_ - sent_);
  can::Frame segment{kSdoRequest + node_, {0, 0, 0, 0, 0, 0, 0, 0}};
  segment.data[0] = static_cast<std::uint8_t>(kDownloadSegment | toggle_ | ((kInSegment - count) << 1) |
                                              (sent_ + count >= size_ ? kLast : 0));
  std::copy_n(value_.begin() + static_cast<std::ptrdiff_t>(sent_), count, segment.data.begin() + 1);
  sent_ += count;
  return segment;
}

}  // namespace mrroc::canopen
