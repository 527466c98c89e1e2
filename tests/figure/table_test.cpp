// Recorded results as tables, and what is said of files that are none.

#include "figure/table.hpp"

#include <cmath>

#include "results.hpp"

namespace mbcc::test {

using figure::Table;

TEST_CASE("a result is read as columns, to the last digit") {
  const Table table = table_of("t,x1,\"p[1,2].x\"\n0,0.10000000000000001,-1e-300\n0.5,nan,inf\n");
  CHECK(table.name == "result.csv");
  CHECK(table.names == std::vector<std::string>{"t", "x1", "p[1,2].x"});
  CHECK(table.columns[0] == std::vector<double>{0, 0.5});
  CHECK(table["x1"][0] == 0.1);
  CHECK(std::isnan(table["x1"][1]));
  CHECK(table["p[1,2].x"][0] == -1e-300);
  CHECK(std::isinf(table["p[1,2].x"][1]));
  CHECK(table["y1"].empty());
}

TEST_CASE("time comes first, wherever it stands") {
  const Table table = table_of("x1,y1,t\n1,2,0\n");
  CHECK(table.names == std::vector<std::string>{"t", "x1", "y1"});
  CHECK((table.time()[0] == 0 && table["x1"][0] == 1 && table["y1"][0] == 2));
}

TEST_CASE("lines may end as elsewhere, and the last one need not end at all") {
  CHECK(table_of("t,a\r\n0,1\r\n1,2").columns[1] == std::vector<double>{1, 2});
  CHECK(table_of("t\n0\n1\n").time().size() == 2);
}

TEST_CASE("what is no result is said with its place") {
  CHECK(complaint_about("") ==
        "result.csv:1:1: error: the file is empty: a result begins with the names of its columns\n\n^\n");
  CHECK(complaint_about("x1,T\n0,1\n") ==
        "result.csv:1:1: error: no column is called `t`: a result has the time in one\nx1,T\n^~~~\n");
  CHECK(complaint_about("t,x1\n") == "result.csv:2:1: error: the result has no rows\n\n^\n");
  CHECK(complaint_about("t,\"a,b\",\"a,b\"\n0,1,2\n") ==
        "result.csv:1:10: error: `a,b` names two columns\nt,\"a,b\",\"a,b\"\n         ^~~\n");
  CHECK(complaint_about("t,x1\n0,1\n1,2,3\n") == "result.csv:3:1: error: 3 cells under 2 names\n1,2,3\n^~~~~\n");
  CHECK(complaint_about("t,x1\n0,1\n\n") == "result.csv:3:1: error: 1 cells under 2 names\n\n^\n");
  CHECK(complaint_about("t,x1\n0,1.5m\n") == "result.csv:2:3: error: `1.5m` is not a number\n0,1.5m\n  ^~~~\n");
  CHECK(complaint_about("t,x1\n0,\n") == "result.csv:2:3: error: `` is not a number\n0,\n  ^\n");
  CHECK(complaint_about("t,x1\n0,\"\n") == "result.csv:2:3: error: `\"` is not a number\n0,\"\n  ^\n");
}

}  // namespace mbcc::test
