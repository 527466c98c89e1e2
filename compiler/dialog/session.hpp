#pragma once
// The dialogs as a machine: it has a question, takes an answer, and has the next question. It reads and prints nothing.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/render.hpp"
#include "dialog/bookmark.hpp"
#include "dialog/workshop.hpp"

namespace mbcc::dialog {

struct Options {
  std::string model;         ///< to start from; empty for a new one
  std::string output;        ///< where the model goes; empty for NAME.mbd beside `model`
  std::string default_name;  ///< of a new model; empty for the one of the table
  bool force = false;        ///< replace files without asking
  bool interactive = true;   ///< somebody is there to be asked about files
  Colours colours = Colours::Off;
};

struct Question {
  std::string prompt;
  std::string prefill;  ///< what ENTER accepts
};

/// How a session ended.
enum class Ending {
  Complete,     ///< the model is written
  WrongModel,   ///< the one to start from is
  WrongUsage,   ///< files that cannot be read, written or replaced
  Unfinished,   ///< the input ended
  Interrupted,  ///< by the user
};

class Session {
 public:
  /// `workshop` must outlive the session.
  Session(Options options, const Workshop& workshop);

  /// What to say before the first question; a model that cannot be started from ends the session.
  std::string begin();

  Question question() const;

  /// Takes a line, and returns what to say to it: nothing, or whole lines.
  std::string answer(std::string_view line);

  /// The user went away, with `unfinished` in the line: what has been answered is kept in a file beside the model.
  std::string leave(std::string_view unfinished, Ending ending);

  const std::optional<Ending>& ending() const { return ending_; }  ///< nothing while there is a question
  int exit_code() const { return exit_code_; }                     ///< of the last command that was run
  const std::string& error() const { return error_; }              ///< why the session ended, whole lines

 private:
  enum class Phase {
    Asking,       ///< the question at place_
    Confirming,   ///< whether the answers of a dialog are right
    Resuming,     ///< whether to go on with a draft
    Moving,       ///< whether to take the nearest consistent start
    Overwriting,  ///< whether files that exist may be replaced
    Closing,      ///< what to do with the model that has been written
  };

  static bool is_yes(std::string_view text) { return text == "Y" || text == "y"; }
  static bool is_no(std::string_view text) { return text == "N" || text == "n"; }

  // session.cpp: from question to question
  Slot slot() const;
  std::string default_answer() const;
  std::string take(const std::string& text);
  std::string leave_dialog();
  std::string enter(Dialog dialog);
  std::string go_back();
  std::string help() const;
  std::string end(Ending ending, std::string error);

  // stations.cpp: what has to be settled between the dialogs
  bool open_model();
  std::string settle_name();
  std::string begin_draft();
  std::string resume(const std::string& text);
  bool save(std::string_view unfinished);
  std::string settle_start();
  std::string ask_for_start();
  std::string leave_start();
  std::string move_start();
  bool may_replace() const;
  std::string refuse_to_replace();
  std::string settle_files();
  std::string overwrite(const std::string& text);
  std::string write();
  std::string close(const std::string& text);
  std::string existing_files() const;
  std::string program_path() const;
  std::string draft_path() const { return draft_.path + ".draft"; }

  Options options_;
  const Workshop& workshop_;
  Phase phase_ = Phase::Asking;
  Draft draft_;
  Place place_;
  std::optional<std::string> retry_;  ///< stands in the line instead of the answer so far
  std::vector<Moved> moved_;          ///< what Phase::Moving offers
  std::string saved_as_;              ///< where this session's draft is
  std::string written_;               ///< the program that this session wrote
  std::optional<Ending> ending_;
  int exit_code_ = 0;
  std::string error_;
};

}  // namespace mbcc::dialog
