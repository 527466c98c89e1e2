#pragma once
// What mbcc has to say to its user, as data. Rendering is another file's work.

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "source/source.hpp"

namespace mbcc {

enum class Severity { Error, Warning };

/// One enumerator per row of diagnostics.def.
enum class Finding {
#define MBCC_DIAGNOSTIC(name, severity, text) name,
#include "diagnostics/diagnostics.def"
#undef MBCC_DIAGNOSTIC
};

std::string_view name_of(Finding finding);
Severity severity_of(Finding finding);
std::string_view text_of(Finding finding);  ///< a {fmt} format string

/// Points at another place that matters to a diagnostic ("first declared here").
struct Note {
  Span span;
  std::string message;
};

struct Diagnostic {
  Finding finding;
  Severity severity;
  Span span;
  std::string message;
  std::vector<Note> notes;

  Diagnostic& note(Span where, std::string what) {
    notes.push_back({where, std::move(what)});
    return *this;
  }
};

/// Collects findings in the order in which they are made.
class Diagnostics {
 public:
  /// Formats the finding's text with `arguments`. The reference is valid until the next report.
  template <class... Arguments>
  Diagnostic& report(Finding finding, Span span, const Arguments&... arguments) {
    return add({finding, severity_of(finding), span, fmt::format(fmt::runtime(text_of(finding)), arguments...), {}});
  }
  Diagnostic& add(Diagnostic diagnostic);

  const std::vector<Diagnostic>& all() const { return all_; }
  std::size_t errors() const;
  std::size_t warnings() const { return all_.size() - errors(); }
  bool has_errors() const { return errors() != 0; }

 private:
  std::vector<Diagnostic> all_;
};

}  // namespace mbcc
