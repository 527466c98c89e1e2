// Dialogs through a pipe: whole transcripts, and what they leave behind.

#include "session.hpp"

namespace mbcc::test {

TEST_CASE("the answers of the paper's section 3 make its model, its program and its numbers") {
  const Desk desk;
  const Outcome outcome = desk.run_transcript("paper");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.errors == "");
  CHECK(desk.read("artigo5.mbd") == transcript_file("artigo5.mbd"));
  CHECK(desk.read("cartigo5.cpp") == desk.run("artigo5.mbd -o -", "").output);
  CHECK_FALSE(desk.has("artigo5.mbd.draft"));

  const Run run = run_model(desk.directory / "artigo5.mbd");
  REQUIRE(run.exit_code == 0);
  // The seven digits of the paper's method in double precision, reproduced by several programs.
  CHECK(run.constraint_error("constraint_1", "position") == Approx(1.465189e-5).epsilon(1e-6));
  CHECK(run.constraint_error("constraint_2", "position") == Approx(5.484222e-7).epsilon(1e-6));
  CHECK(run.constraint_error("constraint_3", "velocity") == 0);
  CHECK(run.constraint_error("constraint_4", "velocity") == 0);
}

TEST_CASE("docs/dialog.md shows that transcript and that model") {
  const std::string page = read_file(std::filesystem::path(MBCC_SOURCE_DIR) / "docs/dialog.md");
  CHECK(page.find("```text\n" + transcript_file("paper.transcript") + "```\n") != std::string::npos);
  CHECK(page.find("```mbd\n" + transcript_file("artigo5.mbd") + "```\n") != std::string::npos);
}

}  // namespace mbcc::test
