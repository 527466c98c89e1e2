#include "interrupt.hpp"

#include <csignal>

namespace mbrt {
namespace {

volatile std::sig_atomic_t noted = 0;  // signal handlers reach nothing but globals

extern "C" void note_interrupt(int) { noted = 1; }

}  // namespace

void listen_for_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  // A write that is under way is finished (SA_RESTART), so that rows stay whole.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return noted != 0; }

}  // namespace mbrt
