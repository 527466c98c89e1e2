// The manual page: the texts of `mbcc help` for troff.

#include "fixture.hpp"

namespace mbcc::test {

TEST_CASE("the manual page begins as pages do, and has what help says, ready for troff") {
  const Outcome outcome = run_mbcc({"help", "manual"});
  CHECK(outcome.exit_code == 0);
  const std::string& page = outcome.output;
  const std::string version = run_mbcc({"--version"}).output;
  CHECK(page.find(".TH MBCC 1 \"\" \"" + version.substr(0, version.find('\n')) +
                  "\" \"User Commands\"\n.SH NAME\nmbcc \\- a compiler for mechanics\n.SH SYNOPSIS\n"
                  "\\fBmbcc MODEL.mbd \\-o SIM.cpp\\fR\n.br\n\\fBmbcc run MODEL.mbd [flags]\\fR\n.br\n") == 0);
  for (const char* part : {
           ".SH COMMANDS\n.TP\n\\fBmbcc MODEL.mbd \\-o SIM.cpp\\fR\ncompile a model to one C++ program",
           ".TP\n\\fB\\-\\-library\\fR\nthe class alone: no main, no allocation, no streams\n",
           ".SH MODELS\n.PP\n.nf\nA model in one page\n\n  system pendulum  ",
           ".PP\n\\fBln\\fR is natural, \\fBlog\\fR is base 10. \\fBif(a < b, x, y)\\fR takes a comparison.",
           ".TP\n\\fBA name\\fR\na letter, then letters and digits; the first 7 count\n",
           ".SH EXIT STATUS\n.PP\nExit codes\n.TP\n\\fB0\\fR\nfine, warnings included\n",
       }) {
    INFO(part);
    CHECK(page.find(part) != std::string::npos);
  }
}

TEST_CASE("troff finds nothing to warn of in the manual page") {
  const ScratchDirectory scratch;
  write_file(scratch / "mbcc.1", run_mbcc({"help", "manual"}).output);
  const Outcome outcome = run_program("/bin/sh", {"-c", "groff -man -Tutf8 -ww -z " + quoted(scratch / "mbcc.1")});
  if (outcome.exit_code == 127) {
    WARN("no groff");
    return;
  }
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.errors.empty());
}

}  // namespace mbcc::test
