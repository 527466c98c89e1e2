// Scripts as a whole: two reviewed ones, and what may not get out of its quotes.
// After a wanted change, MBCC_ACCEPT=1 in the environment writes the reviewed texts anew.

#include "figure/script.hpp"

#include <cstdlib>

#include "results.hpp"
#include "support/run_program.hpp"

namespace mbcc::test {
namespace {

using namespace figure;

const std::filesystem::path golden = std::filesystem::path(MBCC_SOURCE_DIR) / "tests/figure/golden";

void check_script(const std::string& name, const std::vector<figure::Table>& results, Format format) {
  const std::string text = gnuplot_script(results, format, "figure");
  if (std::getenv("MBCC_ACCEPT") != nullptr) {
    write_file(golden / name, text);
  }
  CHECK(text == read_file(golden / name));
}

}  // namespace

TEST_CASE("the paper's example is drawn as reviewed") {
  check_script("artigo5.gp", {table_of(read_file(golden / "artigo5.csv"), "artigo5.csv")}, Format::Svg);
}

TEST_CASE("two runs of a pendulum are drawn over each other as reviewed") {
  check_script("pendulums.gp",
               {table_of("t,bob.x,bob.y,bob.vx,bob.vy,bob.ax,bob.ay,angle\n0,1,0,0,0,0,-9.81,1.5\n1,0,-1,-4,0,0,20,0\n",
                         "long.csv"),
                table_of("t,bob.x,bob.y,bob.vx,bob.vy,bob.ax,bob.ay,pull\n0,1,0,0,0,0,-9.81,0\n2,0.5,-1,-3,0,0,20,30\n",
                         "it's short.csv")},
               Format::Pdf);
}

TEST_CASE("names stay in their quotes") {
  const std::string text = gnuplot_script(std::vector{table_of("t,a'; system 'x,b`c`\n0,1,2\n")}, Format::Png, "f'g");
  CHECK(text.find("set label 1 'a'.\"'\".'; system '.\"'\".'x' noenhanced") != std::string::npos);
  CHECK(text.find("set label 1 'b`c`' noenhanced") != std::string::npos);
  CHECK(text.find("set output 'f'.\"'\".'g'\n") != std::string::npos);
}

}  // namespace mbcc::test
