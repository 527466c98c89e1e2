#pragma once
// Answers of a person: a line that is edited in place, with a history.

#include <memory>

#include "dialog/reader.hpp"

// Of libedit.
struct editline;
struct history;

namespace mbcc::dialog {

/// Standard input and output, which must be a terminal. Keys are those of Emacs unless ~/.editrc says otherwise.
class Terminal {
 public:
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  Reply ask(const Question& question);
  void say(std::string_view lines);

 private:
  struct Close {
    void operator()(editline* editor) const;
    void operator()(struct history* past) const;
  };

  void remember(const std::string& line);

  std::unique_ptr<struct history, Close> past_;
  std::unique_ptr<editline, Close> editor_;
  std::string prompt_;
  bool interrupted_ = false;

  friend struct TerminalCallbacks;
};

static_assert(Reader<Terminal>);

}  // namespace mbcc::dialog
