#pragma once
// Numbers as text that a browser decodes at once.

#include <span>
#include <string>

namespace mbcc::page {

/// The bytes of `values`, little-endian, in base64 (RFC 4648).
std::string base64(std::span<const double> values);

}  // namespace mbcc::page
