#pragma once

namespace mrroc::links {

/// Works around a defect of Cyclone DDS (0.10.2, Debian 12) in the descriptions that this process receives from now on:
/// anyone who reaches a process's port could end the process with one packet and without any key.
///
/// A description of a participant, reader or writer may name a type (PID_TYPE_INFORMATION, XTypes 1.3, 7.6.3.2.1) by
/// numbers with a kind. Cyclone calls abort() when the kind is unknown. Valid descriptions have a type whose numbers
/// are hashes (EK_MINIMAL, EK_COMPLETE): here a description with any other kind is refused before Cyclone reads it.
///
/// Cyclone calls our function, which has the name of its own, instead of its own, which ours calls. A Cyclone without a
/// function of this name is unchanged. Any thread.
void mend_received_types() noexcept;

}  // namespace mrroc::links
