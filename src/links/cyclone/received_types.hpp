#pragma once

namespace mrroc::links {

/// Repairs a defect of Cyclone DDS (0.10.2, Debian 12) in the descriptions that this process receives from now on:
/// whoever reaches a process's port could end it, with one packet and without any key.
///
/// A description of a participant, reader or writer may name a type (PID_TYPE_INFORMATION, XTypes 1.3, 7.6.3.2.1) by
/// numbers that say of which kind they are. Cyclone calls abort() where the kind of one is none that there is. What is
/// described has a type of its own, whose numbers are hashes (EK_MINIMAL, EK_COMPLETE): here every other is refused,
/// and the description with it, before Cyclone looks.
///
/// Cyclone calls the function that does so, which has its own name, instead of its own, which that calls. A Cyclone
/// without a function of this name stays as it is. Any thread.
void mend_received_types() noexcept;

}  // namespace mrroc::links
