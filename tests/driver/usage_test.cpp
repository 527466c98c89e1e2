// How mbcc answers to its command line: every refusal, and its exit code.

#include "fixture.hpp"

namespace mbcc::test {

TEST_CASE("wrong usage is exit code 2 and one line that says what would be right") {
  const Workshop shop;
  const std::string model = shop.write("pendulum.mbd", pendulum);
  const auto refusal = [](const std::vector<std::string>& arguments) {
    const Outcome outcome = run_mbcc(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.output.empty());
    return outcome.errors;
  };
  const std::string none = shop.path("none.mbd");
  CHECK(refusal({}) ==
        "mbcc: error: which model? `mbcc MODEL.mbd -o SIM.cpp` compiles one, `mbcc run MODEL.mbd` runs it; see "
        "`mbcc --help`\n");
  CHECK(refusal({model}) ==
        "mbcc: error: where should the program go: name a file with `-o`, `-o -` for standard output\n");
  CHECK(refusal({none, "-o", "-"}) == "mbcc: error: cannot read `" + none + "`\n");
  CHECK(refusal({"run", none}) == "mbcc: error: cannot read `" + none + "`\n");
  CHECK(refusal({"run"}) == "mbcc: error: `mbcc run` takes a model first: `mbcc run MODEL.mbd [flags]`\n");
  CHECK(refusal({"run", "--to", "1"}) == "mbcc: error: `mbcc run` takes a model first: `mbcc run MODEL.mbd [flags]`\n");
  CHECK(refusal({"check"}) == "mbcc: error: MODEL is required (see `mbcc --help`)\n");
  CHECK(refusal({"check", model, "--diagnostics=xml"}) ==
        "mbcc: error: --diagnostics: xml not in {text,json} (see `mbcc --help`)\n");
  CHECK(refusal({"dump", model, "--stage=code"}) ==
        "mbcc: error: there is no stage `code`: tokens, syntax, system, equations, derivatives, program\n");
  CHECK(refusal({"dump", model, "--stage=syntax", "--partials"}) ==
        "mbcc: error: `--partials` goes with `--stage=derivatives`\n");
  CHECK(refusal({"help", "nothing"}) ==
        "mbcc: error: there is no help on `nothing`: topics are `language`, `functions`, `run`, `plot`, `dialog`, "
        "`exit`, `manual`\n");
  CHECK(refusal({model, "-o", shop.path("no/such/folder.cpp")}) ==
        "mbcc: error: cannot write `" + shop.path("no/such/folder.cpp") + "`\n");
  CHECK(refusal({model, "-o", "-", "--method", "rk5"}) ==
        "mbcc: error: --method: rk5 not in {rk4,dop853,taylor,radau,auto} (see `mbcc --help`)\n");
  CHECK(refusal({"dialog", "-"}) ==
        "mbcc: error: a dialog reads answers and prints questions: name files for its models\n");
  CHECK(refusal({"dialog", none}) == "mbcc: error: cannot read `" + none + "`\n");
  CHECK(refusal({"verify", model, none}) == "mbcc: error: cannot read `" + none + "`\n");
  CHECK(refusal({"check", shop.path("")}) == "mbcc: error: cannot read `" + shop.path("") + "`\n");
}

TEST_CASE("commands of later versions are refused by name") {
  for (const std::string command : {"equilibrium", "linearize", "sweep"}) {
    const Outcome outcome = run_mbcc({command});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.errors == "mbcc: error: `mbcc " + command + "` is not available in this version of mbcc\n");
  }
}

TEST_CASE("help and version are no mistakes") {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{{"--help"},
                                                                                         {"help"},
                                                                                         {"-h"},
                                                                                         {"help", "language"},
                                                                                         {"help", "run"},
                                                                                         {"help", "dialog"},
                                                                                         {"help", "functions"},
                                                                                         {"help", "exit"},
                                                                                         {"check", "--help"}}) {
    const Outcome outcome = run_mbcc(arguments);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.errors.empty());
    CHECK(outcome.output.size() > 100);
  }
  CHECK(run_mbcc({"--version"}).output.rfind("mbcc ", 0) == 0);
}

TEST_CASE("a wrong model is exit code 1, and a warning only if it is to count as an error") {
  const Workshop shop;
  const std::string bad = shop.write("wrong.mbd", wrong);
  const std::string doubtful = shop.write("warned.mbd", warned);
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"check", bad}, {bad, "-o", "-"}, {"run", bad}, {"dump", bad, "--stage=system"}}) {
    const Outcome outcome = run_mbcc(command);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.output.empty());
    CHECK(outcome.errors ==
          bad +
              ":3:12: error: `x2` is not a variable: there is no particle 2, numbers run from 1 to 1\n"
              "output r = x2\n"
              "           ^~\n");
  }
  CHECK(run_mbcc({"check", doubtful}).exit_code == 0);
  const Outcome strict = run_mbcc({"check", doubtful, "--werror"});
  CHECK(strict.exit_code == 1);
  CHECK(strict.errors.find("warning: `let` `r` is not used") != std::string::npos);
  CHECK(strict.errors.find("mbcc: error: warnings count as errors here (`--werror`)\n") != std::string::npos);
}

TEST_CASE("diagnostics are data if asked for") {
  const Workshop shop;
  const std::string bad = shop.write("wrong.mbd", wrong);
  const Outcome outcome = run_mbcc({"check", bad, "--diagnostics=json"});
  CHECK(outcome.exit_code == 1);
  const nlohmann::json diagnostics = nlohmann::json::parse(outcome.errors);
  REQUIRE(diagnostics.size() == 1);
  CHECK(diagnostics[0]["file"] == bad);
  CHECK(diagnostics[0]["line"] == 3);
  CHECK(diagnostics[0]["column"] == 12);
  CHECK(diagnostics[0]["severity"] == "error");
  CHECK(nlohmann::json::parse(run_mbcc({"check", shop.write("p.mbd", pendulum), "--diagnostics=json"}).errors).empty());
}

TEST_CASE("the flag --strict holds a model to the paper's grammar") {
  const Workshop shop;
  const std::string model = shop.write("pendulum.mbd", pendulum);
  CHECK(run_mbcc({"check", model}).exit_code == 0);
  const Outcome outcome = run_mbcc({"check", model, "--strict"});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.errors.find("the paper's grammar") != std::string::npos);
  const std::string examples = std::string(MBCC_SOURCE_DIR) + "/examples/";
  CHECK(run_mbcc({"check", examples + "artigo5_strict/artigo5_strict.mbd", "--strict"}).exit_code == 0);
}

}  // namespace mbcc::test
