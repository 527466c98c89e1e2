// The files that a motion is recorded in: residual columns, NumPy's form, memory.

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <string>

#include "sample_run.hpp"

using namespace mbrt::test;
using mbcc::test::ScratchDirectory;

namespace {

/// Largest absolute value of a column.
double largest(const std::vector<double>& column) {
  double found = 0;
  for (const double value : column) {
    found = std::max(found, std::abs(value));
  }
  return found;
}

std::string header_of(const std::string& csv) { return csv.substr(0, csv.find('\n')); }

/// The pages, in kilobytes, that a recording of 1000 rows for each second has had in memory at most.
long peak_memory(const std::string& end, const std::string& flag) {
  const ScratchDirectory scratch;
  std::vector<std::string> words = {SAMPLES, "pendulum", "--quiet", "--step",          "0.001",
                                    "--to",  end,        flag,      scratch / "result"};
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  pid_t child = 0;
  REQUIRE(posix_spawn(&child, SAMPLES, nullptr, nullptr, arguments.data(), nullptr) == 0);
  int status = 0;
  struct rusage used {};
  REQUIRE(wait4(child, &status, 0, &used) == child);
  REQUIRE(status == 0);
  return used.ru_maxrss;
}

}  // namespace

TEST_CASE("with --residuals the errors of the constraints and the energy follow the other columns") {
  const SampleRun plain = run_sample("pendulum");
  const SampleRun run = run_sample("pendulum", {"--residuals"});
  CHECK(header_of(run.csv) ==
        header_of(plain.csv) + ",rod.position_error,rod.velocity_error,rod.acceleration_error,energy");
  CHECK(run.table["x1"] == plain.table["x1"]);
  // Each accepted step has its row: the largest are those that the monitors saw.
  for (const std::string level : {"position", "velocity", "acceleration"}) {
    CHECK(largest(run.table["rod." + level + "_error"]) == run.largest("rod", level));
  }
  CHECK(run.table["energy"][0] == run.summary["energy"]["initial"].get<double>());
  CHECK(run.table.last("energy") == run.summary["energy"]["final"].get<double>());
}

TEST_CASE("residuals between steps are those of the row") {
  const SampleRun run = run_sample("paper", {"--residuals", "--every", "0.0123"});
  const std::string header = header_of(run.csv);
  CHECK(header.find("sphere.position_error,sphere.velocity_error,sphere.acceleration_error,") != std::string::npos);
  CHECK(header.find("constraint_3.position_error") == std::string::npos);  // it is nonholonomic
  CHECK(header.find("energy") == std::string::npos);                       // its forces have no potential
  for (std::size_t i = 0; i < run.table.rows(); ++i) {
    const double x = run.table["x1"][i], y = run.table["y1"][i], z = run.table["z1"][i];
    // Four roundings of numbers up to 1.
    CHECK(run.table["sphere.position_error"][i] == Approx(x * x + y * y + z * z - 1).epsilon(0).margin(1e-15));
  }
}

TEST_CASE("NumPy's form holds the same numbers") {
  const ScratchDirectory scratch;
  for (const std::string rows : {"1", "9", "10"}) {  // the header stays as long
    CHECK(run_plain("pendulum", {"--quiet", "--to", std::to_string(std::stoi(rows) - 1), "--step", "1", "--csv",
                                 scratch / "rows.csv", "--npy", scratch / "rows.npy"})
              .exit_code == 0);
    const auto table = mbcc::test::parse_csv(mbcc::test::read_file(scratch / "rows.csv"));
    const std::string npy = mbcc::test::read_file(scratch / "rows.npy");
    REQUIRE(npy.substr(0, 8) == std::string("\x93NUMPY\x02\0", 8));
    const std::size_t begin = 12 + static_cast<unsigned char>(npy[8]) + 256U * static_cast<unsigned char>(npy[9]);
    CHECK(begin % 64 == 0);
    const std::string literal = npy.substr(12, begin - 12);
    CHECK(literal.substr(0, literal.find('}') + 1) ==
          "{'descr': [('t', '<f8'), ('x1', '<f8'), ('y1', '<f8'), ('vx1', '<f8'), ('vy1', '<f8'), ('ax1', '<f8'), "
          "('ay1', '<f8'), ('angle', '<f8'), ], 'fortran_order': False, 'shape': (" +
              rows + ",), }");
    CHECK(literal.find_first_not_of(' ', literal.find('}') + 1) == literal.size() - 1);
    CHECK(literal.back() == '\n');
    REQUIRE(npy.size() == begin + table.rows() * table.columns.size() * sizeof(double));
    std::vector<double> numbers((npy.size() - begin) / sizeof(double));
    std::memcpy(numbers.data(), npy.data() + begin, npy.size() - begin);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      CHECK(numbers[i] == table.columns[i % table.columns.size()][i / table.columns.size()]);
    }
  }
}

TEST_CASE("NumPy reads it") {
  const std::string python = "/usr/bin/python3";  // whose packages are Debian's
  if (mbcc::test::run_program(python, {"-c", "import numpy"}).exit_code != 0) {
    WARN("not tested: Debian's python3-numpy is not installed");
    return;
  }
  const ScratchDirectory scratch;
  const std::string file = scratch / "rows.npy";
  REQUIRE(run_plain("pendulum", {"--quiet", "--npy", file}).exit_code == 0);
  CHECK(mbcc::test::run_program(python, {"-c",
                                         "import sys, numpy\nrows = numpy.load(sys.argv[1])\n"
                                         "print(rows.dtype.names[1], len(rows), rows['ay1'][0])",
                                         file})
            .output == "x1 201 -9.81\n");
}

TEST_CASE("a failed recording is said, with exit code 2") {
  const auto outcome = run_plain("pendulum", {"--quiet", "--npy", "/dev/full"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.errors == "error: cannot write `/dev/full`: No space left on device\n");
  const auto piped =
      mbcc::test::run_program("/bin/sh", {"-c", SAMPLES " pendulum --quiet --npy /dev/stdout | cat >/dev/null"});
  CHECK(piped.errors == "error: cannot write `/dev/stdout`: Illegal seek\n");
}

TEST_CASE("memory does not grow with the number of rows") {
  for (const std::string flag : {"--csv", "--npy"}) {
    // 100000 rows of 8 numbers would be 6400 kilobytes; a page or two may come and go.
    CHECK(peak_memory("100", flag) < peak_memory("1", flag) + 1000);
  }
}
