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

TEST_CASE("an answer of every wrong kind is refused in every dialog, and asked for again") {
  const Desk desk;
  const Outcome outcome = desk.run_transcript("refusals");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.errors ==
        "pendulu.mbd:12:18: warning: constraint `constraint_2` is redundant: rank 1 of 2 at the initial configuration\n"
        "constraint     : x1*vx1 + y1*vy1\n"
        "                 ^~~~~~~~~~~~~~~\n");
}

TEST_CASE("answers can be explained, rejected and returned to in every dialog, and are not lost") {
  const Desk desk;
  CHECK(desk.run_transcript("changes").exit_code == 0);
  CHECK(desk.read("swing.mbd") == transcript_file("changes.mbd"));
}

TEST_CASE("a start off the constraints is reported, and the nearest one on them offered") {
  const Desk desk;
  SECTION("before the times and after them, as constraints may depend on time") {
    CHECK(desk.run_transcript("start").exit_code == 0);
    CHECK(desk.read("hoop.mbd").find("position = (1.2, 1.6)") != std::string::npos);
  }
  SECTION("if there is one") {
    const Outcome outcome = desk.run_transcript("hopeless");
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.errors == "mbcc: error: the answers end before the model is complete\n");
  }
}

TEST_CASE("a dialog that ends too early goes on the next time") {
  const Desk desk;
  const Outcome left = desk.run_transcript("left");
  CHECK(left.exit_code == 2);
  CHECK(left.errors == "mbcc: error: the answers end before the model is complete\n");
  CHECK_FALSE(desk.has("artigo5.mbd"));

  SECTION("where it was") {
    CHECK(desk.run_transcript("resumed").exit_code == 0);
    CHECK(desk.read("artigo5.mbd") == transcript_file("artigo5.mbd"));
    CHECK_FALSE(desk.has("artigo5.mbd.draft"));
  }
  SECTION("or from its beginning") {
    const Outcome outcome = desk.run("dialog", "artigo5\n\nN\n2\n");
    CHECK(outcome.output.find("(Y/N)? N\nB dimension: 2\nC particles: \n") != std::string::npos);
  }
  SECTION("but not with a draft that is none") {
    for (const char* text : {"", "{}", "[1, 2]", R"({"format": "mbcc dialog 0"})"}) {
      desk.write("artigo5.mbd.draft", text);
      const Outcome outcome = desk.run("dialog", "artigo5\n\nY\n");
      CHECK(outcome.exit_code == 2);
      CHECK(outcome.errors == "mbcc: error: `artigo5.mbd.draft` is no draft of this version of mbcc: move it away\n");
      CHECK(desk.read("artigo5.mbd.draft") == text);
    }
  }
  SECTION("nor with one whose numbers promise what is not there") {
    std::string draft = desk.read("artigo5.mbd.draft");
    const std::string count = R"("particle_count": "2")";
    REQUIRE(draft.find(count) != std::string::npos);
    draft.replace(draft.find(count), count.size(), R"("particle_count": "3")");
    desk.write("artigo5.mbd.draft", draft);
    CHECK(desk.run("dialog", "artigo5\n\nY\n").exit_code == 2);
  }
}

TEST_CASE("a dialog that starts from a model changes what is answered otherwise and nothing else") {
  const Desk desk;
  const std::string model = transcript_file("swing.mbd");
  desk.write("swing.mbd", model);
  SECTION("more particles and constraints") {
    const Outcome outcome = desk.run_transcript("edited", "swing.mbd -o edited.mbd");
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.errors == "");
    CHECK(desk.read("edited.mbd") == transcript_file("edited.mbd"));
    CHECK(desk.read("swing.mbd") == model);
  }
  SECTION("fewer") {
    CHECK(desk.run_transcript("reduced", "swing.mbd --force").exit_code == 0);
    CHECK(desk.read("swing.mbd") == transcript_file("reduced.mbd"));
  }
  SECTION("but not from a wrong one") {
    desk.write("wrong.mbd", "particle 1 { mass = 1 }\n");
    const Outcome outcome = desk.run("dialog wrong.mbd", "");
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.output == "");
    CHECK(outcome.errors ==
          "wrong.mbd:1:10: error: particle 1 has no position: write `position = ...`\n"
          "particle 1 { mass = 1 }\n"
          "         ^\n");
  }
}

TEST_CASE("from a pipe no file is replaced without --force") {
  const Desk desk;
  const std::string answers = "fall\n\n1\n1\n0\n\n\n-9.81\n\n0\n0\n0.1\n0\n1\n";
  desk.write("cfall.cpp", "precious");
  const Outcome refused = desk.run("dialog", answers);
  CHECK(refused.exit_code == 2);
  CHECK(refused.errors == "mbcc: error: `cfall.cpp` would be replaced: say `--force`, or take another name\n");
  CHECK(desk.read("cfall.cpp") == "precious");
  CHECK_FALSE(desk.has("fall.mbd"));
  CHECK(desk.run("dialog --force", answers).exit_code == 0);
  CHECK(desk.read("cfall.cpp") != "precious");

  const Outcome again = desk.run("dialog", answers);
  CHECK(again.errors ==
        "mbcc: error: `fall.mbd` and `cfall.cpp` would be replaced: say `--force`, or take another name\n");
  CHECK(desk.run("dialog -o there/fall.mbd", answers).errors == "mbcc: error: cannot write `there/fall.mbd.draft`\n");
}

TEST_CASE("docs/dialog.md shows that transcript and that model") {
  const std::string page = read_file(std::filesystem::path(MBCC_SOURCE_DIR) / "docs/dialog.md");
  CHECK(page.find("```text\n" + transcript_file("paper.transcript") + "```\n") != std::string::npos);
  CHECK(page.find("```mbd\n" + transcript_file("artigo5.mbd") + "```\n") != std::string::npos);
}

}  // namespace mbcc::test
