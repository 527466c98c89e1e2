#pragma once
// Ctrl-C asks a run to stop at its next step, so that what it has computed is written.

namespace mbrt {

/// The first SIGINT or SIGTERM from now on is noted, the second ends the process as usual.
void listen_for_interrupts();

bool interrupted();

}  // namespace mbrt
