#pragma once
// What a terminal shows: enough of a VT100 for one line of input below whatever was printed before.

#include <string>
#include <string_view>
#include <vector>

namespace mbcc::test {

class Screen {
 public:
  void print(std::string_view bytes);

  /// All lines so far, without blanks at their ends.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::size_t lines() const { return lines_.size(); }
  /// The line of the cursor, up to the cursor.
  [[nodiscard]] std::string before_cursor() const { return lines_.back().substr(0, column_); }

 private:
  void put(char c);
  void control(std::string_view parameters, char command);

  std::vector<std::string> lines_ = {""};
  std::size_t column_ = 0;
  std::string sequence_;  ///< of an unfinished escape sequence
};

}  // namespace mbcc::test
