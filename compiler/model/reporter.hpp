#pragma once
// Passes findings on to the user's diagnostics, each once: what an unrolled loop finds in every pass is one mistake.

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <tuple>

#include "diagnostics/diagnostic.hpp"

namespace mbcc::model {

inline bool covers(Span outer, Span inner) {
  return outer.file == inner.file && outer.begin <= inner.begin && inner.end <= outer.end;
}

/// How a finding came about: a place that led to it, and what led to that place.
struct Trace {
  Span span;
  std::string message;
  const Trace* outer = nullptr;
};

class Reporter {
 public:
  /// While it lives, findings have the notes of `trace`.
  class Within {
   public:
    Within(Reporter& reporter, const Trace& trace) : reporter_(reporter), before_(reporter.trace_) {
      reporter.trace_ = &trace;
    }
    ~Within() { reporter_.trace_ = before_; }
    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;

   private:
    Reporter& reporter_;
    const Trace* before_;
  };

  explicit Reporter(Diagnostics& diagnostics)
      : diagnostics_(diagnostics),
        errors_before_(diagnostics.errors()),
        before_(static_cast<std::ptrdiff_t>(diagnostics.all().size())) {}

  /// As Diagnostics::report, but silent if the same finding has been reported at the same place.
  template <class... Arguments>
  Diagnostic& report(Finding finding, Span span, const Arguments&... arguments) {
    if (!seen_.emplace(finding, span.file, span.begin, span.end).second) {
      return repeated_ = Diagnostic{finding, severity_of(finding), span, {}, {}};
    }
    Diagnostic& diagnostic = diagnostics_.report(finding, span, arguments...);
    for (const Trace* trace = trace_; trace != nullptr; trace = trace->outer) {
      if (!trace->message.empty()) {
        diagnostic.note(trace->span, trace->message);
      }
    }
    return diagnostic;
  }

  /// Whether part of what `span` covers could not be read.
  bool is_damaged(Span span) const {
    const auto is_inside = [&](const Diagnostic& before) { return covers(span, before.span); };
    return std::any_of(diagnostics_.all().begin(), diagnostics_.all().begin() + before_, is_inside);
  }

  Diagnostics& diagnostics() { return diagnostics_; }
  bool found_errors() const { return diagnostics_.errors() > errors_before_; }

  /// Statements that could not be read may have declared names that are then missing, which is no new mistake.
  bool statements_are_lost() const { return errors_before_ > 0 || names_are_lost_; }
  /// As if names were declared in a text that nobody can look at.
  void lose_names() { names_are_lost_ = true; }
  bool names_are_lost() const { return names_are_lost_; }

 private:
  Diagnostics& diagnostics_;
  std::size_t errors_before_;
  std::ptrdiff_t before_;  ///< findings, of all kinds, that others had made
  bool names_are_lost_ = false;
  const Trace* trace_ = nullptr;
  std::set<std::tuple<Finding, std::uint32_t, std::uint32_t, std::uint32_t>> seen_;
  Diagnostic repeated_;  ///< takes the notes of a report that is not passed on
};

}  // namespace mbcc::model
