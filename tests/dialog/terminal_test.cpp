// Dialogs on a terminal: lines that are edited in place, Ctrl-C, drafts, files that exist.

#include "pseudo_terminal.hpp"
#include "session.hpp"
#include "support/variable.hpp"

namespace mbcc::test {

namespace {

// Keys of line editing, as in Emacs.
const std::string enter = "\r", start_of_line = "\x01", ctrl_c = "\x03", ctrl_d = "\x04", end_of_line = "\x05",
                  right = "\x06", before = "\x10", clear = "\x15", rub_out = "\x7f";

}  // namespace

TEST_CASE("plain mbcc asks on a terminal, and Ctrl-C keeps even what stands in the line") {
  const Desk desk;
  PseudoTerminal first({MBCC_BINARY}, desk.directory / "");
  first.answer("A name: model", clear + "osc" + enter);
  first.answer("A right (Y)? ", enter);
  first.answer("B dimension: ", "1" + enter);
  first.answer("C particles: ", "1" + enter);
  first.answer("D constraints: ", "1" + enter);
  first.answer("E m1: 1", enter);
  first.answer("E right (Y)? ", enter);
  first.answer("F fx1: 0", rub_out + "-4*x1" + enter);
  first.answer("F right (Y)? ", "n" + enter);
  first.answer("F fx1: -4*x1", start_of_line + right + "1" + enter);
  first.answer("F right (Y)? ", before + enter);  // the answer before
  first.answer("F fx1: -14*x1", start_of_line + right + right + rub_out + end_of_line + " " + enter);
  first.answer("F right (Y)? ", "Y" + enter);
  first.answer("G g1: ", "vx1^ = 1" + enter);
  first.answer("G g1: vx1^ = 1", "?" + enter);
  first.answer("G g1: vx1^ = 1", start_of_line + right + right + right + right + "2" + enter);
  first.answer("G right (Y)? ", enter);
  first.answer("H x1: ", "0.2" + ctrl_c);
  CHECK(first.finish() == 130);
  CHECK(first.text() == transcript_file("terminal_left.transcript"));

  PseudoTerminal second({MBCC_BINARY}, desk.directory / "");
  second.answer("A name: osc", enter);  // the name of the draft
  second.answer("A right (Y)? ", enter);
  second.answer("go on with `osc.mbd.draft` (Y/N)? ", enter);
  second.answer("H x1: 0.2", "5" + enter);
  second.answer("H vx1: ", "-1" + enter);
  second.answer("I step: ", "0.01" + enter);
  second.answer("I initial time: ", "0" + enter);
  second.answer("I final time: ", "1" + enter);
  second.answer("check, run, plot, or ENTER to end: ", "check" + enter);
  second.answer("check, run, plot, or ENTER to end: ", ctrl_d);
  CHECK(second.finish() == 0);
  CHECK(second.text() == transcript_file("terminal_resumed.transcript"));
  CHECK(desk.read("osc.mbd") == transcript_file("osc.mbd"));
  CHECK_FALSE(desk.has("osc.mbd.draft"));
}

namespace {

/// ENTER for all that osc.mbd answers behind its name.
void accept(PseudoTerminal& terminal) {
  for (const char* line : {"A right (Y)? ", "B dimension: 1", "C particles: 1", "D constraints: 1", "E m1: 1",
                           "E right (Y)? ", "F fx1: -4*x1", "F right (Y)? ", "G g1: vx1^2 = 1", "G right (Y)? ",
                           "H x1: 0.25", "H vx1: -1", "I step: 0.01", "I initial time: 0", "I final time: 1"}) {
    terminal.answer(line, enter);
  }
}

}  // namespace

TEST_CASE("on a terminal files that exist are replaced by consent alone") {
  const Desk desk;
  desk.write("osc.mbd", transcript_file("osc.mbd"));
  desk.write("cosc.cpp", "precious");
  PseudoTerminal terminal({MBCC_BINARY, "dialog", "osc.mbd"}, desk.directory / "");
  terminal.answer("A name: osc", enter);
  accept(terminal);
  terminal.answer("replace `osc.mbd` and `cosc.cpp` (Y/N)? ", "?" + enter);
  terminal.answer("replace `osc.mbd` and `cosc.cpp` (Y/N)? ", enter);
  terminal.answer("replace `osc.mbd` and `cosc.cpp` (Y/N)? ", "N" + enter);
  terminal.answer("A name: osc", rub_out + "d" + enter);
  CHECK(desk.read("cosc.cpp") == "precious");
  accept(terminal);
  terminal.answer("check, run, plot, or ENTER to end: ", "back" + enter);
  for (const char* line : {"I step: 0.01", "H x1: 0.25", "G g1: vx1^2 = 1", "F fx1: -4*x1", "E m1: 1",
                           "D constraints: 1", "C particles: 1", "B dimension: 1"}) {
    terminal.answer(line, "back" + enter);  // behind the answer, or instead of it
  }
  terminal.answer("A name: osd", rub_out + "c" + enter);
  accept(terminal);
  terminal.answer("replace `osc.mbd` and `cosc.cpp` (Y/N)? ", "Y" + enter);
  terminal.answer("check, run, plot, or ENTER to end: ", enter);
  CHECK(terminal.finish() == 0);
  CHECK(terminal.text() == transcript_file("terminal_files.transcript"));
  CHECK(desk.read("cosc.cpp") == desk.run("osc.mbd -o -", "").output);
  CHECK(desk.read("cosd.cpp") == desk.run("osd.mbd -o -", "").output);
  CHECK_FALSE(desk.has("osc.mbd.draft"));
  CHECK_FALSE(desk.has("osd.mbd.draft"));
}

TEST_CASE("with -o there is no other name to ask for, and the answers stay in the draft") {
  const Desk desk;
  desk.write("osc.mbd", transcript_file("osc.mbd"));
  desk.write("other.mbd", "precious");
  PseudoTerminal terminal({MBCC_BINARY, "dialog", "osc.mbd", "-o", "other.mbd"}, desk.directory / "");
  terminal.answer("A name: osc", enter);
  accept(terminal);
  terminal.answer("replace `other.mbd` (Y/N)? ", "?" + enter);
  terminal.answer("replace `other.mbd` (Y/N)? ", "N" + enter);
  CHECK(terminal.finish() == 2);
  CHECK(terminal.text() == transcript_file("terminal_output.transcript"));
  CHECK(desk.read("other.mbd") == "precious");
  CHECK(desk.has("other.mbd.draft"));
}

TEST_CASE("a run at the end of the dialog is the run of mbcc, and the dialog goes on") {
  const Desk desk;
  const Variable cache("XDG_CACHE_HOME", desk.directory / "cache");
  desk.write("osc.mbd", transcript_file("osc.mbd"));
  PseudoTerminal terminal({MBCC_BINARY, "dialog", "osc.mbd", "--force"}, desk.directory / "");
  terminal.answer("A name: osc", enter);
  accept(terminal);
  terminal.answer("check, run, plot, or ENTER to end: ", "run" + enter);
  terminal.answer("check, run, plot, or ENTER to end: ", enter);
  CHECK(terminal.finish() == 0);
  CHECK(terminal.text().find("osc: ok, rk4, 100 steps of 0.01 from t = 0 to 1") != std::string::npos);
}

}  // namespace mbcc::test
