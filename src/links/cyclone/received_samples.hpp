#pragma once

namespace mrroc::links {

/// Works around two defects of Cyclone DDS (0.10.2, Debian 12; according to its source also 11.0) in the samples that
/// this process receives from now on. With them, anyone who reaches a process's port could end the process, or write
/// beyond a buffer, without any key.
///
/// - A sample that comes in fragments (DATA_FRAG, RTPS 2.3, 9.4.5.4) contains its size in each of them. Cyclone
///   allocates the size in the first one and writes them all, so that a forged fragment with a larger size writes
///   beyond the buffer. Here everything beyond the size in the first is cut off a complete sample.
/// - A message of a hand-shake (ParticipantStatelessMessage, DDS Security 1.1, 7.4.3; not signed yet) has no key.
///   For a message that claims to be only a key, or neither key nor data, Cyclone reads a null pointer. Here the
///   message is treated as data, whose length and contents Cyclone checks.
///
/// Cyclone calls our functions, which have the names of its own, instead of its own, which ours call. A Cyclone without
/// functions of these names is unchanged. Any thread.
void mend_received_samples() noexcept;

}  // namespace mrroc::links
