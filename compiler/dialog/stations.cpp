// What has to be settled between the dialogs: where the model goes, drafts, a consistent start, files, and what then.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "dialog/item.hpp"
#include "dialog/outline.hpp"
#include "dialog/session.hpp"
#include "dialog/start.hpp"
#include "dialog/write_model.hpp"

namespace mbcc::dialog {

namespace {

namespace fs = std::filesystem;

std::string beside(const std::string& path, const std::string& name) {
  return (fs::path(path).parent_path() / name).string();
}

/// Warnings are for when the model is compiled.
Diagnostics errors_of(const Diagnostics& diagnostics) {
  Diagnostics errors;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::Error) {
      errors.add(diagnostic);
    }
  }
  return errors;
}

/// By moving the start.
bool is_curable(const Diagnostic& error) {
  return error.finding == Finding::StartOffPosition || error.finding == Finding::StartOffVelocity;
}

}  // namespace

bool Session::open_model() {
  std::optional<std::string> text = workshop_.read(options_.model);
  if (!text) {
    end(Ending::WrongUsage, fmt::format("mbcc: error: cannot read `{}`\n", options_.model));
    return false;
  }
  if (!text->empty() && text->back() != '\n') {
    *text += '\n';
  }
  const Findings findings = workshop_.examine(options_.model, *text, Depth::Language);
  if (findings.diagnostics.has_errors()) {
    end(Ending::WrongModel, render(findings.diagnostics, findings.sources, options_.colours));
    return false;
  }
  draft_ = outline(*text, fs::path(options_.model).stem().string()).answers;
  return true;
}

// -- a name

std::string Session::settle_name() {
  draft_.path = !options_.output.empty() ? options_.output : beside(options_.model, draft_.name + ".mbd");
  if (!options_.interactive && !may_replace()) {
    return refuse_to_replace();
  }
  if (saved_as_ != draft_path() && workshop_.exists(draft_path())) {
    phase_ = Phase::Resuming;
    return fmt::format("`{}` keeps the answers of a dialog that was left\n", draft_path());
  }
  return begin_draft();
}

/// Under the name that has just been settled.
std::string Session::begin_draft() {
  if (!saved_as_.empty() && saved_as_ != draft_path()) {
    workshop_.remove(saved_as_);
  }
  enter(Dialog::Dimension);
  const bool saved = saved_as_ == draft_path();
  return saved ? "" : end(Ending::WrongUsage, fmt::format("mbcc: error: cannot write `{}`\n", draft_path()));
}

std::string Session::resume(const std::string& text) {
  if (is_no(text)) {
    return begin_draft();
  }
  if (!text.empty() && !is_yes(text)) {
    return "answer Y or N\n";
  }
  std::optional<Bookmark> bookmark = read_bookmark(workshop_.read(draft_path()).value_or(""));
  if (!bookmark) {
    return end(Ending::WrongUsage,
               fmt::format("mbcc: error: `{}` is no draft of this version of mbcc: move it away\n", draft_path()));
  }
  bookmark->draft.path = draft_.path;
  bookmark->draft.name = draft_.name;
  draft_ = std::move(bookmark->draft);
  place_ = bookmark->place;
  phase_ = place_.confirming ? Phase::Confirming : Phase::Asking;
  retry_ = bookmark->unfinished.empty() ? std::nullopt : std::optional(bookmark->unfinished);
  saved_as_ = draft_path();
  return "";
}

bool Session::save(std::string_view unfinished) {
  if (draft_.path.empty()) {
    return true;
  }
  const bool saved = workshop_.write(draft_path(), write_bookmark({draft_, place_, std::string(unfinished)}));
  saved_as_ = saved ? draft_path() : "";
  return saved;
}

// -- a consistent start

std::string Session::settle_start() {
  const std::string text = write_model(draft_).text;
  const Findings findings = workshop_.examine(draft_.path, text, Depth::Physics);
  const Diagnostics errors = errors_of(findings.diagnostics);
  if (!errors.has_errors()) {
    return leave_start();
  }
  std::string said = render(errors, findings.sources, options_.colours);
  if (std::all_of(errors.all().begin(), errors.all().end(), is_curable)) {
    moved_ = workshop_.assemble(draft_.path, text);
    if (can_take(draft_, moved_)) {
      phase_ = Phase::Moving;
      return said + "the nearest consistent start has\n" + describe_moves(moved_);
    }
    said += "no consistent start was found near this one\n";
  }
  return said + ask_for_start();
}

/// Dialog H again, or the last one before it where there is nothing to ask for in H.
std::string Session::ask_for_start() {
  place_.dialog = Dialog::Start;
  return slots_of(Dialog::Start, draft_).empty() ? go_back() : enter(Dialog::Start);
}

std::string Session::leave_start() { return place_.dialog == Dialog::Start ? enter(Dialog::Times) : settle_files(); }

std::string Session::move_start() {
  take_start(draft_, moved_);
  return leave_start();
}

// -- files

std::string Session::existing_files() const {
  std::string names;
  for (const std::string& path : {draft_.path, program_path()}) {
    if (workshop_.exists(path)) {
      names += fmt::format("{}`{}`", names.empty() ? "" : " and ", path);
    }
  }
  return names;
}

std::string Session::program_path() const { return beside(draft_.path, "c" + draft_.name + ".cpp"); }

/// What this session wrote is its own.
bool Session::may_replace() const { return options_.force || written_ == program_path() || existing_files().empty(); }

std::string Session::refuse_to_replace() {
  return end(Ending::WrongUsage,
             fmt::format("mbcc: error: {} would be replaced: say `--force`, or take another name\n", existing_files()));
}

std::string Session::settle_files() {
  if (may_replace()) {
    return write();
  }
  if (!options_.interactive) {
    return refuse_to_replace();
  }
  phase_ = Phase::Overwriting;
  return "";
}

std::string Session::overwrite(const std::string& text) {
  if (is_yes(text)) {
    return write();
  }
  if (!is_no(text)) {
    return "answer Y or N\n";
  }
  return options_.output.empty() ? enter(Dialog::Name) : leave("", Ending::WrongUsage);
}

std::string Session::write() {
  if (!workshop_.write(draft_.path, write_model(draft_).text)) {
    return end(Ending::WrongUsage, fmt::format("mbcc: error: cannot write `{}`\n", draft_.path));
  }
  workshop_.remove(saved_as_);
  saved_as_.clear();
  written_ = program_path();
  phase_ = Phase::Closing;
  exit_code_ = workshop_.compile(draft_.path, program_path());
  return exit_code_ == 0 ? fmt::format("wrote `{}` and `{}`\n", draft_.path, program_path())
                         : fmt::format("wrote `{}`\n", draft_.path);
}

std::string Session::close(const std::string& text) {
  if (text.empty()) {
    return end(Ending::Complete, "");
  }
  if (text == "check") {
    exit_code_ = workshop_.check(draft_.path);
  } else if (text == "run") {
    exit_code_ = workshop_.run(draft_.path);
  } else if (text == "plot") {
    const std::string figure = beside(draft_.path, draft_.name + ".svg");
    exit_code_ = workshop_.plot(draft_.path, figure);
    return exit_code_ == 0 ? fmt::format("drew `{}`\n", figure) : "";
  } else {
    return "answer check, run or plot, or ENTER to end\n";
  }
  return "";
}

}  // namespace mbcc::dialog
