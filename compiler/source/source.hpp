#pragma once
// Model text, and the places in it that every later representation points to.

#include <compare>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace mbcc {

/// A half-open range of bytes [begin, end) in one of the files of `Sources`.
struct Span {
  std::uint32_t file = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  friend bool operator==(const Span&, const Span&) = default;
};

/// The smallest span that covers both; both must lie in one file.
Span join(Span first, Span last);

/// Line and column, both from 1; columns count bytes.
struct Position {
  std::uint32_t line = 1;
  std::uint32_t column = 1;

  friend bool operator==(const Position&, const Position&) = default;
};

/// One file: its name as the user wrote it, and its text, which it owns.
class Source {
 public:
  Source(std::string name, std::string text);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  std::string_view line(std::uint32_t number) const;  ///< without its line end; `number` from 1
  Position position(std::uint32_t offset) const;

 private:
  std::string name_;
  std::string text_;
  std::vector<std::uint32_t> line_starts_;
};

/// The model file and what it imports; file 0 is the model. Spans index into it.
class Sources {
 public:
  std::uint32_t add(std::string name, std::string text);
  std::size_t size() const { return files_.size(); }
  const Source& operator[](std::uint32_t file) const { return files_[file]; }
  std::string_view text(Span span) const;
  Position position(Span span) const;  ///< where the span begins
  std::string place(Span span) const;  ///< `file.mbd:12`, the file without directories

 private:
  std::deque<Source> files_;  ///< does not move what is in it: tokens view their text
};

}  // namespace mbcc
