#pragma once
// What one run of name resolution works on.

#include "model/arena.hpp"
#include "model/reporter.hpp"
#include "model/symbols.hpp"

namespace mbcc::model {

/// Keeps a small text from becoming an endless model: counts statements, passes and terms as loops make them.
class Budget {
 public:
  explicit Budget(Reporter& report) : report_(report) {}

  static constexpr std::size_t most_statements = 1'000'000;
  static constexpr std::size_t most_parts = 100'000;  ///< each has tables of its own
  static constexpr std::size_t most_terms = 5'000'000;
  static constexpr std::size_t most_nodes = 50'000'000;  ///< two gigabytes of them

  /// False, with a finding at `span` the first time, if there is no more to spend; then everything must stop.
  bool spend_statement(Span span) { return spend(++statements_, most_statements, "statements after unrolling", span); }
  bool spend_part(Span span) { return spend(++parts_, most_parts, "parts", span); }
  bool spend_term(Span span) { return spend(++terms_, most_terms, "terms of sums", span); }
  bool allows_nodes(std::size_t nodes, Span span) { return spend(nodes, most_nodes, "operations", span); }
  bool is_exhausted() const { return exhausted_; }

  /// For a reason that the caller reports.
  void exhaust() { exhausted_ = true; }

 private:
  bool spend(std::size_t spent, std::size_t most, std::string_view what, Span span) {
    if (spent > most && !exhausted_) {
      exhausted_ = true;
      report_.report(Finding::TooLarge, span, most, what);
    }
    return !exhausted_;
  }

  Reporter& report_;
  std::size_t statements_ = 0;
  std::size_t parts_ = 0;
  std::size_t terms_ = 0;
  bool exhausted_ = false;
};

// Note [storage order]: few particles keep their coordinates and speeds in order of declaration, each particle's side
// by side. From `stored_by_axis` particles on, x of all of them comes first, then y, then z, so that loops over
// particles run over numbers that follow each other (measured: a chain of 100 links, 12 % of a step). Columns of
// results are in order of declaration in any case: System::declared_coordinates.

struct Context {
  Context(const Sources& texts, Diagnostics& diagnostics) : sources(texts), report(diagnostics), budget(report) {}

  static constexpr std::size_t stored_by_axis = 16;

  /// Index of a particle's coordinate and speed along an axis: Note [storage order]. Known once all are declared.
  std::uint32_t motion_index(const Particle& particle, std::size_t axis) const {
    const std::size_t count = symbols.particles.size();
    return static_cast<std::uint32_t>(count < stored_by_axis
                                          ? particle.position * static_cast<std::size_t>(dimension) + axis
                                          : axis * count + particle.position);
  }

  const Sources& sources;
  Reporter report;
  Budget budget;
  Symbols symbols;
  Arena arena;
  int dimension = 3;  ///< 0: the model does not say it properly, so that nothing can be said about vectors
};

}  // namespace mbcc::model
