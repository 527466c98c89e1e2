#pragma once
// The emitted class: its member functions and data.

#include <string>

#include "emit/kernel_writer.hpp"
#include "model/system.hpp"
#include "program/program.hpp"
#include "source/source.hpp"

namespace mbcc::cpp {

/// `text` fit for a `//` comment: on one line, and not ending in what would continue it.
std::string comment_text(std::string_view text);

/// What the scene does not need is not written: no islands, no solver; no outputs, no function for them.
class ClassWriter {
 public:
  ClassWriter(const program::Program& program, const model::System& system, const Sources& sources);

  std::string summary() const;    ///< one line of documentation
  std::string functions() const;  ///< public
  std::string members() const;    ///< private

 private:
  Body body(const program::Kernel& kernel, const Comments& comments = {}) const;
  std::string island_comment(std::size_t island) const;
  std::string initial_state() const;
  std::string set_time() const;
  std::string rates() const;
  std::string series() const;
  std::string tangent() const;
  std::string project() const;
  std::string shifts(std::string_view name, const program::Kernel& kernel) const;
  std::string island_functions() const;
  std::string constraint_errors() const;
  std::string change(std::string_view purpose, std::string_view name, const program::Kernel& kernel) const;
  std::string coupling(std::size_t island) const;
  std::string energy() const;
  std::string outputs() const;
  std::string applied_forces() const;
  std::string island_members(std::size_t island) const;
  std::string climb(std::size_t island, program::Unknowns unknowns, const std::string& solve) const;
  std::string nonholonomic_rows_ignored(std::size_t island) const;

  const program::Program& program_;
  const model::System& system_;
  const Sources& sources_;
  Naming naming_;
};

}  // namespace mbcc::cpp
