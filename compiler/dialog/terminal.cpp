#include "dialog/terminal.hpp"

#include <histedit.h>

#include <clocale>
#include <csignal>
#include <cstdio>

#include "diagnostics/assert.hpp"

namespace mbcc::dialog {

/// What libedit calls; it keeps the terminal for them.
struct TerminalCallbacks {
  static Terminal& terminal_of(EditLine* editor) {
    void* terminal = nullptr;
    el_get(editor, EL_CLIENTDATA, &terminal);
    return *static_cast<Terminal*>(terminal);
  }
  static char* prompt(EditLine* editor) { return terminal_of(editor).prompt_.data(); }
  static unsigned char interrupt(EditLine* editor, int /*key*/) {
    terminal_of(editor).interrupted_ = true;
    return CC_EOF;
  }
  static unsigned char suspend(EditLine* /*editor*/, int /*key*/) {
    raise(SIGTSTP);
    return CC_REFRESH;
  }
};

void Terminal::Close::operator()(editline* editor) const { el_end(editor); }
void Terminal::Close::operator()(History* past) const { history_end(past); }

Terminal::Terminal() : past_(history_init()), editor_(el_init("mbcc", stdin, stdout, stderr)) {
  MBCC_ASSERT(past_ && editor_);
  std::setlocale(LC_CTYPE, "");  // libedit drops what is no character of the locale
  constexpr int history_length = 1000;
  HistEvent event;
  history(past_.get(), &event, H_SETSIZE, history_length);
  EditLine* editor = editor_.get();
  el_set(editor, EL_CLIENTDATA, this);
  el_set(editor, EL_PROMPT, &TerminalCallbacks::prompt);
  el_set(editor, EL_EDITOR, "emacs");
  el_set(editor, EL_HIST, history, past_.get());
  // Ctrl-C comes as a key, so that what stands in the line is not lost; Ctrl-Z then does so, too. Real signals find the
  // terminal as it was. (el_set would copy the names of functions and lose the copies.)
  el_set(editor, EL_SETTY, "-d", "-isig", nullptr);
  el_wset(editor, EL_ADDFN, L"mbcc-interrupt", L"leave the dialog", &TerminalCallbacks::interrupt);
  el_wset(editor, EL_ADDFN, L"mbcc-suspend", L"suspend the dialog", &TerminalCallbacks::suspend);
  el_set(editor, EL_BIND, "^C", "mbcc-interrupt", nullptr);
  el_set(editor, EL_BIND, "^Z", "mbcc-suspend", nullptr);
  el_set(editor, EL_SIGNAL, 1);
  el_source(editor, nullptr);
}

Terminal::~Terminal() = default;

Reply Terminal::ask(const Question& question) {
  prompt_ = question.prompt;
  interrupted_ = false;
  el_set(editor_.get(), EL_PREP_TERM, 1);  // before anything is to be seen that invites to type
  if (!question.prefill.empty()) {
    el_push(editor_.get(), question.prefill.c_str());
  }
  int length = 0;
  const char* typed = el_gets(editor_.get(), &length);
  if (typed == nullptr || length <= 0 || interrupted_) {
    const LineInfo* line = el_line(editor_.get());
    say("\n");
    return {interrupted_ ? Reply::Kind::Interrupt : Reply::Kind::End,
            std::string(line->buffer, static_cast<std::size_t>(line->lastchar - line->buffer))};
  }
  std::string line(typed, static_cast<std::size_t>(length));
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) {
    line.pop_back();
  }
  remember(line);
  return {Reply::Kind::Line, line};
}

void Terminal::remember(const std::string& line) {
  if (!line.empty()) {
    HistEvent event;
    history(past_.get(), &event, H_ENTER, line.c_str());
  }
}

void Terminal::say(std::string_view lines) {
  std::fwrite(lines.data(), 1, lines.size(), stdout);
  std::fflush(stdout);
}

}  // namespace mbcc::dialog
