#include "diagnostics/diagnostic.hpp"

#include <algorithm>
#include <array>

namespace mbcc {
namespace {

struct Row {
  std::string_view name;
  Severity severity;
  std::string_view text;
};

constexpr std::array table = {
#define MBCC_DIAGNOSTIC(name, severity, text) Row{#name, Severity::severity, text},
#include "diagnostics/diagnostics.def"
#undef MBCC_DIAGNOSTIC
};

const Row& row(Finding finding) { return table[static_cast<std::size_t>(finding)]; }

}  // namespace

std::string_view name_of(Finding finding) { return row(finding).name; }
Severity severity_of(Finding finding) { return row(finding).severity; }
std::string_view text_of(Finding finding) { return row(finding).text; }

Diagnostic& Diagnostics::add(Diagnostic diagnostic) {
  all_.push_back(std::move(diagnostic));
  return all_.back();
}

std::size_t Diagnostics::errors() const {
  const auto is_error = [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::Error; };
  return static_cast<std::size_t>(std::count_if(all_.begin(), all_.end(), is_error));
}

}  // namespace mbcc
