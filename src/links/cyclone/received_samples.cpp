#include "links/cyclone/received_samples.hpp"

#include <dds/dds.h>
#include <dds/ddsi/q_protocol.h>
#include <dds/ddsi/q_radmin.h>
#include <dds/ddsi/q_rtps.h>

#include "links/cyclone/cyclone_function.hpp"

namespace mrroc::links {
namespace {

using Reorder = decltype(&nn_reorder_rsample);
using Gap = decltype(&nn_reorder_gap);

Reorder cyclone_reorder() noexcept {
  static const auto function = cyclone_function<Reorder>("nn_reorder_rsample");
  return function;
}

Gap cyclone_gap() noexcept {
  static const auto function = cyclone_function<Gap>("nn_reorder_gap");
  return function;
}

/// A hand-shake message always counts as data. Cyclone has the writer in our byte order.
void take_handshake_for_data(const nn_rdata& first) noexcept {
  auto& submessage =
      *reinterpret_cast<Data_DataFrag_common_t*>(NN_RMSG_PAYLOADOFF(first.rmsg, NN_RDATA_SUBMSG_OFF(&first)));
  if (submessage.writerId.u != NN_ENTITYID_P2P_BUILTIN_PARTICIPANT_STATELESS_MESSAGE_WRITER) return;
  unsigned flags = submessage.smhdr.flags;
  if (submessage.smhdr.submessageId == SMID_DATA_FRAG)
    flags &= ~DATAFRAG_FLAG_KEYFLAG;
  else
    flags = (flags & ~DATA_FLAG_KEYFLAG) | DATA_FLAG_DATAFLAG;
  submessage.smhdr.flags = static_cast<unsigned char>(flags);
}

/// Of the samples that are delivered now; a gap has neither data nor information.
void mend(const nn_rsample_chain_elem* sample) noexcept {
  for (; sample != nullptr; sample = sample->next) {
    if (sample->sampleinfo == nullptr) continue;
    take_handshake_for_data(*sample->fragchain);
    for (nn_rdata* fragment = sample->fragchain; fragment != nullptr; fragment = fragment->nextfrag)
      if (fragment->maxp1 > sample->sampleinfo->size) fragment->maxp1 = sample->sampleinfo->size;
  }
}

}  // namespace

void mend_received_samples() noexcept {
  cyclone_reorder();
  cyclone_gap();
}

}  // namespace mrroc::links

extern "C" {

nn_reorder_result_t nn_reorder_rsample(nn_rsample_chain* delivered, nn_reorder* reorder, nn_rsample* sample,
                                       int* references, int queue_is_full) {
  using namespace mrroc::links;
  const nn_reorder_result_t result = cyclone_reorder()(delivered, reorder, sample, references, queue_is_full);
  if (result > 0) mend(delivered->first);
  return result;
}

nn_reorder_result_t nn_reorder_gap(nn_rsample_chain* delivered, nn_reorder* reorder, nn_rdata* data, seqno_t first,
                                   seqno_t end, int* references) {
  using namespace mrroc::links;
  const nn_reorder_result_t result = cyclone_gap()(delivered, reorder, data, first, end, references);
  if (result > 0) mend(delivered->first);
  return result;
}
}
