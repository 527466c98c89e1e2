// Lines, columns and spans.

#include "source/source.hpp"

#include <catch2/catch.hpp>

namespace mbcc {

TEST_CASE("lines end in \\n or \\r\\n, the last one in either or nothing") {
  const Source source("model.mbd", "first\r\n\nthird");
  CHECK(source.line(1) == "first");
  CHECK(source.line(2).empty());
  CHECK(source.line(3) == "third");
  CHECK(Source("model.mbd", "one\n").line(2).empty());
  CHECK(Source("model.mbd", "").line(1).empty());
}

TEST_CASE("positions count lines and bytes from 1") {
  const Source source("model.mbd", "ab\n\u00E9c\n");
  CHECK(source.position(0) == Position{1, 1});
  CHECK(source.position(2) == Position{1, 3});
  CHECK(source.position(3) == Position{2, 1});
  CHECK(source.position(5) == Position{2, 3});
  CHECK(source.position(7) == Position{3, 1});
}

TEST_CASE("joined spans cover both") {
  CHECK(join({0, 2, 4}, {0, 6, 9}) == Span{0, 2, 9});
  CHECK(join({1, 2, 9}, {1, 3, 5}) == Span{1, 2, 9});
}

TEST_CASE("sources know the text and the place of a span") {
  Sources sources;
  CHECK(sources.add("models/a.mbd", "let a = 1\n") == 0);
  CHECK(sources.add("b.mbd", "\nlet b = 2") == 1);
  CHECK(sources.size() == 2);
  CHECK(sources.text({0, 4, 5}) == "a");
  CHECK(sources.text({1, 5, 6}) == "b");
  CHECK(sources.position({1, 5, 6}) == Position{2, 5});
  CHECK(sources.place({0, 4, 5}) == "a.mbd:1");
  CHECK(sources.place({1, 5, 6}) == "b.mbd:2");
}

}  // namespace mbcc
