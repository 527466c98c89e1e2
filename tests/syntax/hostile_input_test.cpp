// Nothing that a file can hold crashes or hangs the front end. tests/fuzz looks further and longer.

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "fuzz/read_model.hpp"

namespace mbcc {
namespace {

std::vector<std::string> seeds() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(MBCC_SOURCE_DIR "/tests/fuzz/seeds")) {
    paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const std::string& path : paths) {
    std::ifstream file(path, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return texts;
}

class Mutator {
 public:
  explicit Mutator(std::vector<std::string> texts) : texts_(std::move(texts)) {}

  /// A part of a seed with some bytes or pieces changed; now and then bytes at random.
  std::string text() {
    std::string text = below(8) == 0 ? noise(below(200)) : piece(400);
    for (std::size_t changes = below(4); changes > 0; --changes) {
      const std::size_t at = below(text.size() + 1);
      const std::string inserted = below(2) == 0 ? piece(20) : noise(below(3));
      text.replace(at, std::min(below(10), text.size() - at), inserted);
    }
    return text;
  }

 private:
  std::size_t below(std::size_t bound) { return random_() % bound; }
  std::string noise(std::size_t length) {
    std::string bytes;
    while (bytes.size() < length) {
      bytes += static_cast<char>(below(256));
    }
    return bytes;
  }
  std::string piece(std::size_t longest) {
    const std::string& seed = texts_[below(texts_.size())];
    return seed.substr(below(seed.size()), below(longest));
  }

  std::vector<std::string> texts_;
  std::mt19937 random_{7};
};

std::string times(std::size_t count, std::string_view text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) {
    all += text;
  }
  return all;
}

}  // namespace

TEST_CASE("mutated models are read or refused") {
  Mutator mutator(seeds());
  std::size_t accepted = 0, refused = 0;
  for (int i = 0; i < 20000; ++i) {
    ++(fuzz::read_model(mutator.text()).diagnostics.has_errors() ? refused : accepted);
  }
  CHECK(accepted > 100);
  CHECK(refused > 10000);
}

TEST_CASE("deep, long and hopeless input is read or refused in a time that grows with its length") {
  constexpr std::size_t many = 20000;
  const std::vector<std::string> texts = {
      "let a = " + times(200, "(") + "1" + times(200, ")"),
      "let a = " + times(many, "(") + "1" + times(many, ")"),
      "let a = 1" + times(many, "+ x1"),
      "let a = x1" + times(many, "'"),
      "let a = " + times(many, "-") + "x1",
      "let a = x1" + times(many, "^-x1"),
      "let a = " + times(many, "f(") + times(many, "p["),
      times(200, "for i in 1..2 {\n") + times(200, "}\n"),
      times(many, "for i in 1..2 {\n"),
      times(many, "particle 1 {\n"),
      "body " + times(many, "{"),
      times(many, "}"),
      times(many, "let a = +\n"),
      times(many, "\xFF \x01"),
      "particle 1 {" + times(many, "mass = 1 1\n"),
  };
  for (const std::string& text : texts) {
    INFO(text.substr(0, 40));
    const auto start = std::chrono::steady_clock::now();
    fuzz::read_model(text);
    // A fraction of a second on any machine; what grows with the square of 20,000 takes minutes.
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
  }
}

}  // namespace mbcc
