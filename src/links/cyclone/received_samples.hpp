#pragma once

namespace mrroc::links {

/// Repairs two defects of Cyclone DDS (0.10.2, Debian 12; by its source 11.0, too) in what this process receives from
/// now on. Whoever reaches a process's port could end it by them, or write behind its memory, without any key.
///
/// - A sample that comes in fragments (DATA_FRAG, RTPS 2.3, 9.4.5.4) says its size in each of them. Cyclone allocates
///   the size of the first and writes them all, so that a forged one, which says more and lies beyond, writes behind
///   the memory. Here what lies beyond the size of the first is cut off a complete sample.
/// - A message of a hand-shake (ParticipantStatelessMessage, DDS Security 1.1, 7.4.3; not signed yet) has no key.
///   Cyclone makes no message of one that says it is only a key, or neither key nor data, and reads it, a null pointer.
///   Here it is taken for data, whose length and contents Cyclone checks.
///
/// Cyclone calls the functions that do so, which have its own names, instead of its own, which they call. A Cyclone
/// without functions of these names stays as it is. Any thread.
void mend_received_samples() noexcept;

}  // namespace mrroc::links
