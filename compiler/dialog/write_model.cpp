#include "dialog/write_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "dialog/outline.hpp"
#include "dialog/revision.hpp"
#include "dialog/statements.hpp"

namespace mbcc::dialog {

namespace {

class ModelWriter {
 public:
  ModelWriter(const Draft& draft, std::optional<Slot> wanted)
      : draft_(draft), base_(outline(draft.base, draft.base_name)), statements_(draft, wanted), revision_(draft.base) {}

  WrittenModel write() {
    title();
    dimension();
    change_particles();
    change_equations();
    add_particles();
    add_equations();
    times();
    const Piece text = revision_.result();
    return {text.text(), text.mark().value_or(Span{})};
  }

 private:
  void title() {
    const Slot slot{Item::Name};
    if (base_.name) {
      revision_.replace(*base_.name, statements_.answered(slot));
    } else if (draft_.base.empty() || draft_.name != std::filesystem::path(draft_.path).stem()) {
      revision_.insert(base_.first_statement, "system " + statements_.answered(slot) + "\n");
    }
  }

  void dimension() {
    const Slot slot{Item::Dimension};
    if (base_.dimension) {
      revision_.replace(*base_.dimension, statements_.answered(slot));
    } else if (draft_.base.empty() || answer(draft_, slot) != row_of(slot.item).implied) {
      revision_.insert(base_.first_statement, "dimension " + statements_.answered(slot) + "\n");
    }
  }

  void change_particles() {
    for (std::size_t i = 0; i < base_.particles.size(); ++i) {
      const BlockPlaces& block = base_.particles[i].block;
      if (i >= particles(draft_)) {
        revision_.replace(revision_.lines_of(block.statement), "");
      } else if (block.end_of_fields) {
        change_fields(i);
      } else {
        revision_.replace(block.statement, statements_.particle(i));
      }
    }
  }

  void change_fields(std::size_t index) {
    const ParticlePlaces& places = base_.particles[index];
    const std::array<std::optional<Span>, 4> values = {places.mass, places.position, places.velocity, places.force};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Slot field{particle_fields[i], index};
      if (!values[i] && statements_.is_told(field)) {
        add_field(places.block, field_name(field.item), statements_.value(field));
      } else if (values[i] && (is_changed(field) || statements_.is_value_wanted(field))) {
        revision_.replace(*values[i], statements_.value(field));
      }
    }
  }

  bool is_changed(Slot field) const {
    if (field.item == Item::Mass) {
      return answer(draft_, field) != answer(base_.answers, field);
    }
    return quantity(draft_, field) != quantity(base_.answers, field) || axes(draft_) != axes(base_.answers);
  }

  void add_field(const BlockPlaces& block, std::string_view name, const Piece& value) {
    const std::string begin = block.one_line ? fmt::format("; {} = ", name) : fmt::format("\n  {:8} = ", name);
    revision_.insert(*block.end_of_fields, begin + value);
  }

  void change_equations() {
    for (std::size_t i = 0; i < base_.equations.size(); ++i) {
      const Slot slot{Item::Equation, i};
      const EquationPlaces& places = base_.equations[i];
      if (i >= equations(draft_)) {
        revision_.replace(revision_.lines_of(places.statement), "");
        continue;
      }
      const std::string& before = answer(base_.answers, slot);
      const std::string& now = answer(draft_, slot);
      if (name_of_equation(now).empty() != name_of_equation(before).empty()) {
        revision_.replace(places.statement, statements_.constraint(i, 0));
      } else if (now != before || statements_.is_wanted(slot)) {
        revision_.replace(places.answer, statements_.answered(slot));
      }
    }
  }

  void add_particles() {
    Piece text;
    for (std::size_t i = base_.particles.size(); i < particles(draft_); ++i) {
      text += statements_.particle(i) + "\n";
    }
    add_group(base_.particles.empty() ? std::nullopt : std::optional(base_.particles.back().block.statement), text);
  }

  void add_equations() {
    std::size_t width = 0;
    for (std::size_t i = base_.equations.size(); i < equations(draft_); ++i) {
      width = std::max(width, name_of_equation(draft_.equations[i]).size());
    }
    Piece text;
    for (std::size_t i = base_.equations.size(); i < equations(draft_); ++i) {
      text += draft_.equations[i].empty() ? "" : statements_.constraint(i, width) + "\n";
    }
    add_group(base_.equations.empty() ? std::nullopt : std::optional(base_.equations.back().statement), text);
  }

  /// Statements behind the last one of their kind, or in a paragraph of their own before `integrate`.
  void add_group(std::optional<Span> last, const Piece& text) {
    if (text.text().empty()) {
      return;
    }
    if (last) {
      revision_.insert(revision_.lines_of(*last).end, text);
    } else if (base_.integrate) {
      revision_.insert(revision_.lines_of(base_.integrate->statement).begin, text + "\n");
    } else {
      revision_.append("\n" + text);
    }
  }

  void times() {
    const std::array<std::optional<Span>, 3> values = {base_.from, base_.to, base_.step};
    Piece added;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Slot slot{time_fields[i]};
      if (values[i]) {
        revision_.replace(*values[i], statements_.answered(slot));
      } else if (!answer(draft_, slot).empty() && base_.integrate && base_.integrate->end_of_fields) {
        add_field(*base_.integrate, field_name(slot.item), statements_.answered(slot));
      } else if (!answer(draft_, slot).empty()) {
        added += Piece(field_name(slot.item)) + " = " + statements_.answered(slot) + "; ";
      }
    }
    if (!added.text().empty()) {
      add_integrate("integrate { " + added + "method = rk4 }");
    }
  }

  void add_integrate(const Piece& statement) {
    if (base_.integrate) {
      revision_.replace(base_.integrate->statement, statement);
    } else {
      revision_.append("\n" + statement + "\n");
    }
  }

  const Draft& draft_;
  const Outline base_;
  const Statements statements_;
  Revision revision_;
};

}  // namespace

WrittenModel write_model(const Draft& draft, std::optional<Slot> wanted) { return ModelWriter(draft, wanted).write(); }

}  // namespace mbcc::dialog
