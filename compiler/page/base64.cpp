#include "page/base64.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace mbcc::page {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Collects bytes and writes four characters for three of them.
class Writer {
 public:
  explicit Writer(std::size_t bytes) { text_.reserve((bytes + 2) / 3 * 4); }

  void put(std::uint8_t byte) {
    group_ = group_ << 8 | byte;
    if (++filled_ == 3) {
      write_group(4);
    }
  }

  std::string finish() {
    const int characters = filled_ + 1;
    while (filled_ != 0) {
      group_ <<= 8;
      if (++filled_ == 3) {
        write_group(characters);
      }
    }
    return std::move(text_);
  }

 private:
  void write_group(int characters) {
    for (int i = 0; i < 4; ++i) {
      text_ += i < characters ? alphabet[group_ >> (18 - 6 * i) & 63] : '=';
    }
    group_ = 0;
    filled_ = 0;
  }

  std::string text_;
  std::uint32_t group_ = 0;
  int filled_ = 0;
};

}  // namespace

std::string base64(std::span<const double> values) {
  Writer writer(8 * values.size());
  for (const double value : values) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int shift = 0; shift < 64; shift += 8) {
      writer.put(static_cast<std::uint8_t>(bits >> shift));
    }
  }
  return writer.finish();
}

}  // namespace mbcc::page
