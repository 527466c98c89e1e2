#include "dialog/session.hpp"

#include <fmt/format.h>

#include "dialog/check.hpp"
#include "dialog/item.hpp"
#include "source/text.hpp"

namespace mbcc::dialog {

namespace {

Dialog following(Dialog dialog) { return static_cast<Dialog>(static_cast<std::size_t>(dialog) + 1); }

}  // namespace

Session::Session(Options options, const Workshop& workshop) : options_(std::move(options)), workshop_(workshop) {}

std::string Session::begin() {
  if (!options_.model.empty() && !open_model()) {
    return "";
  }
  return "ENTER takes what stands in the line, `?` explains the question, `back` returns to the dialog before.\n";
}

Question Session::question() const {
  const char letter = row_of(place_.dialog).letter;
  switch (phase_) {
    case Phase::Asking:
      return {fmt::format("{} {}: ", letter, label(draft_, slot())), retry_.value_or(default_answer())};
    case Phase::Confirming:
      return {fmt::format("{} right (Y)? ", letter), ""};
    case Phase::Resuming:
      return {fmt::format("go on with `{}` (Y/N)? ", draft_path()), ""};
    case Phase::Moving:
      return {"take the nearest consistent start (Y)? ", ""};
    case Phase::Overwriting:
      return {fmt::format("replace {} (Y/N)? ", existing_files()), ""};
    case Phase::Closing:
      break;
  }
  return {"check, run, plot, or ENTER to end: ", ""};
}

std::string Session::answer(std::string_view line) {
  const std::string text(trimmed(line));
  // Behind what stood in the line they mean the same: who asks for help need not clear it first.
  const std::string prefill = question().prefill;
  if (text == "?" || text == prefill + "?") {
    return help();
  }
  if (text == "back" || text == prefill + "back") {
    return go_back();
  }
  switch (phase_) {
    case Phase::Asking:
      return take(text.empty() ? prefill : text);
    case Phase::Confirming:
      return text.empty() || is_yes(text) ? leave_dialog() : enter(place_.dialog);
    case Phase::Resuming:
      return resume(text);
    case Phase::Moving:
      return text.empty() || is_yes(text) ? move_start() : enter(Dialog::Start);
    case Phase::Overwriting:
      return overwrite(text);
    case Phase::Closing:
      break;
  }
  return close(text);
}

Slot Session::slot() const { return slots_of(place_.dialog, draft_)[place_.index]; }

std::string Session::default_answer() const {
  const bool names_a_draft = slot().item == Item::Name && draft_.name.empty() && !options_.default_name.empty();
  return names_a_draft ? options_.default_name : prefill(draft_, slot());
}

std::string Session::take(const std::string& text) {
  Verdict verdict = check_answer(draft_, slot(), text, workshop_, options_.colours);
  if (!verdict.accepted) {
    retry_ = text;
    return verdict.message;
  }
  mbcc::dialog::answer(draft_, slot()) = verdict.text;
  make_room(draft_);
  retry_.reset();
  if (place_.index + 1 < slots_of(place_.dialog, draft_).size()) {
    ++place_.index;
    save("");
    return verdict.message;
  }
  if (row_of(place_.dialog).confirmed) {
    phase_ = Phase::Confirming;
    place_.confirming = true;
    save("");
    return verdict.message;
  }
  return verdict.message + leave_dialog();
}

std::string Session::leave_dialog() {
  switch (place_.dialog) {
    case Dialog::Name:
      return settle_name();
    case Dialog::Start:
    case Dialog::Times:
      return settle_start();
    default:
      return enter(following(place_.dialog));
  }
}

/// Or the next dialog that has something to ask for.
std::string Session::enter(Dialog dialog) {
  while (slots_of(dialog, draft_).empty()) {
    dialog = following(dialog);
  }
  phase_ = Phase::Asking;
  place_ = {dialog, 0, false};
  retry_.reset();
  save("");
  return "";
}

std::string Session::go_back() {
  Dialog dialog = place_.dialog;
  if (phase_ == Phase::Resuming) {
    return enter(Dialog::Name);
  }
  if (phase_ == Phase::Overwriting || phase_ == Phase::Closing) {
    return enter(Dialog::Times);
  }
  do {
    if (dialog == Dialog::Name) {
      return "this is the first dialog\n";
    }
    dialog = static_cast<Dialog>(static_cast<std::size_t>(dialog) - 1);
  } while (slots_of(dialog, draft_).empty());
  return enter(dialog);
}

std::string Session::help() const {
  switch (phase_) {
    case Phase::Asking:
      return std::string(row_of(slot().item).help);
    case Phase::Confirming:
      return "Y or ENTER goes on; anything else asks this dialog again, with these answers in the lines.\n";
    case Phase::Resuming:
      return "The file keeps the answers of a dialog that was left: Y goes on with them, N begins anew.\n";
    case Phase::Moving:
      return "Y or ENTER takes the values shown; anything else asks dialog H again.\n";
    case Phase::Overwriting:
      return options_.output.empty() ? "Y replaces what is there; N keeps it, and asks for another name.\n"
                                     : "Y replaces what is there; N keeps it, and the answers as a draft.\n";
    case Phase::Closing:
      break;
  }
  return "check shows the structure of the model, run its motion in numbers, plot in figures; back changes the "
         "model.\n";
}

std::string Session::leave(std::string_view unfinished, Ending ending) {
  if (phase_ == Phase::Closing) {
    return end(ending == Ending::Unfinished ? Ending::Complete : ending, "");
  }
  end(ending, ending == Ending::Unfinished ? "mbcc: error: the answers end before the model is complete\n" : "");
  if (draft_.path.empty() || phase_ == Phase::Resuming) {
    return "";
  }
  if (!save(phase_ == Phase::Asking ? unfinished : "")) {
    return end(ending, fmt::format("mbcc: error: cannot write `{}`\n", draft_path()));
  }
  return fmt::format("the answers so far are kept in `{}`: `mbcc dialog` goes on with them\n", draft_path());
}

std::string Session::end(Ending ending, std::string error) {
  ending_ = ending;
  error_ = std::move(error);
  return "";
}

}  // namespace mbcc::dialog
