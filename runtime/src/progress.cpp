#include "progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "durations.hpp"

namespace mbrt {
namespace {

using namespace std::chrono_literals;
using Seconds = std::chrono::duration<double>;

constexpr std::string_view erase_line = "\r\x1b[K";

std::size_t terminal_columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// "[######..........]", as wide as there is room beside `text`; nothing where that is too little to be seen.
std::string bar(double done, std::size_t columns, std::size_t text) {
  constexpr std::size_t narrowest = 10, widest = 40, frame = 4;
  if (columns < text + frame + narrowest) {
    return "";
  }
  const std::size_t width = std::min(widest, columns - text - frame);
  const auto full = static_cast<std::size_t>(done * static_cast<double>(width));
  return fmt::format("[{:#<{}}{:.<{}}] ", "", full, "", width - full);
}

}  // namespace

bool Progress::has_watcher() { return isatty(STDERR_FILENO) != 0; }

Progress::Progress(double from, double to, From shown)
    : from_(from),
      to_(to),
      on_terminal_(has_watcher()),
      shown_from_(shown),
      next_show_(begin_ + (shown == From::FirstSecond || !on_terminal_ ? 1000ms : 0ms)),
      time_(from) {}

Progress::~Progress() {
  if (visible_ && on_terminal_) {
    fmt::print(stderr, "{}", erase_line);
  } else if (shown_from_ == From::FirstStep && !on_terminal_) {
    show();
  }
}

void Progress::ask_clock() {
  constexpr Seconds interval = 50ms;
  const Clock::time_point now = Clock::now();
  const double wanted = static_cast<double>(stride_) * (interval / Seconds(std::max(now - asked_, Clock::duration(1))));
  // Steps may become slower: never more than twice as many as before.
  stride_ = std::clamp(static_cast<long>(std::min(wanted, 1e9)), 1L, 2 * stride_);
  steps_until_asked_ = stride_;
  asked_ = now;
  if (now >= next_show_) {
    next_show_ = now + (on_terminal_ ? 200ms : 1000ms);
    show();
  }
}

void Progress::show() {
  const double done = to_ > from_ ? (time_ - from_) / (to_ - from_) : 1;
  const double elapsed = Seconds(Clock::now() - begin_).count();
  std::string text = fmt::format("{:3.0f} %, t = {:.4g}", std::floor(100 * done), time_);
  if (done > 0 && done < 1) {
    text += fmt::format(", {} remaining", duration(std::ceil(elapsed * (1 - done) / done)));
  }
  if (on_terminal_) {
    fmt::print(stderr, "{}{}{}", erase_line, bar(done, terminal_columns(), text.size()), text);
    visible_ = true;
  } else {
    fmt::print(stderr, "{}\n", text);
  }
}

}  // namespace mbrt
