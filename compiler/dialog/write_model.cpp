#include "dialog/write_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "dialog/item.hpp"
#include "dialog/outline.hpp"
#include "dialog/piece.hpp"

namespace mbcc::dialog {

namespace {

/// `span` becomes `text`.
struct Edit {
  Span span;
  Piece text;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// What stands before the `:` of an equation; empty if it has no name.
std::string_view label(std::string_view equation) {
  const std::size_t colon = equation.find(':');
  return colon == std::string_view::npos ? "" : trimmed(equation.substr(0, colon));
}

class ModelWriter {
 public:
  ModelWriter(const Draft& draft, std::optional<Slot> wanted)
      : draft_(draft), wanted_(wanted), base_(outline(draft.base, draft.base_name)) {}

  WrittenModel write() {
    title();
    dimension();
    for (std::size_t i = 0; i < base_.particles.size(); ++i) {
      i < particles(draft_) ? change_particle(i) : remove(base_.particles[i].block.statement);
    }
    for (std::size_t i = 0; i < base_.equations.size(); ++i) {
      i < equations(draft_) ? change_equation(i) : remove(base_.equations[i]);
    }
    add_particles();
    add_equations();
    times();
    return apply();
  }

 private:
  // -- answers as text

  Piece given(Slot slot) const {
    const std::string& typed = answer(draft_, slot);
    const std::string_view text = typed.empty() ? row_of(slot.item).implied : typed;
    return slot == wanted_ ? Piece::marked(text) : Piece(text);
  }

  std::size_t components(Slot vector) const { return component_count(draft_, vector); }

  Piece vector(Slot vector) const {
    if (components(vector) == 1) {
      return given(vector);
    }
    Piece text = "(";
    for (vector.axis = 0; vector.axis < components(vector); ++vector.axis) {
      text += vector.axis == 0 ? "" : ", ";
      text += given(vector);
    }
    return text + ")";
  }

  Piece value(Slot field) const { return field.item == Item::Mass ? given(field) : vector(field); }

  bool is_wanted(Slot field) const { return wanted_ && wanted_->item == field.item && wanted_->index == field.index; }

  /// A field that says more than its absence would.
  bool is_told(Slot field) const {
    if (field.item == Item::Mass || field.item == Item::Position || is_wanted(field)) {
      return true;
    }
    for (field.axis = 0; field.axis < components(field); ++field.axis) {
      const std::string& typed = answer(draft_, field);
      if (!typed.empty() && typed != row_of(field.item).implied) {
        return true;
      }
    }
    return false;
  }

  bool is_changed(Slot field) const {
    if (field.item == Item::Mass) {
      return answer(draft_, field) != answer(base_.answers, field);
    }
    return !(quantity(draft_, field) == quantity(base_.answers, field)) || axes(draft_) != axes(base_.answers);
  }

  Piece particle(std::size_t index) const {
    Piece text = "particle " + draft_.particles[index].name + " {\n";
    for (const Item item : particle_fields) {
      if (is_told({item, index})) {
        text += fmt::format("  {:8} = ", field_name(item));
        text += value({item, index}) + "\n";
      }
    }
    return text + "}\n";
  }

  Piece equation(std::size_t index, std::size_t label_width) const {
    const Slot slot{Item::Equation, index};
    const std::string& typed = answer(draft_, slot);
    const bool has_label = !label(typed).empty();
    if (slot == wanted_) {
      return (has_label ? "constraint " : "constraint : ") + given(slot);
    }
    const std::string_view body = has_label ? trimmed(std::string_view(typed).substr(typed.find(':') + 1)) : typed;
    return fmt::format("constraint {:{}}: {}", label(typed), label_width == 0 ? 0 : label_width + 1, body);
  }

  // -- changes of the base

  void edit(Span span, Piece text) { edits_.push_back({span, std::move(text)}); }
  void insert(std::uint32_t place, Piece text) { edit({0, place, place}, std::move(text)); }

  void title() {
    const Slot slot{Item::Name};
    if (base_.name) {
      edit(*base_.name, given(slot));
    } else {
      insert(base_.first_statement, "system " + given(slot) + "\n");
    }
  }

  void dimension() {
    const Slot slot{Item::Dimension};
    if (base_.dimension) {
      edit(*base_.dimension, given(slot));
    } else if (draft_.base.empty() || answer(draft_, slot) != row_of(slot.item).implied) {
      insert(base_.first_statement, "dimension " + given(slot) + "\n");
    }
  }

  void change_particle(std::size_t index) {
    const ParticlePlaces& places = base_.particles[index];
    if (!places.block.last_value_end) {
      edit(lines_of(places.block.statement), particle(index));
      return;
    }
    const std::array<std::optional<Span>, 4> values = {places.mass, places.position, places.velocity, places.force};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Slot field{particle_fields[i], index};
      if (!values[i] && is_told(field)) {
        add_field(places.block, field_name(field.item), value(field));
      } else if (values[i] && (is_changed(field) || is_wanted(field))) {
        edit(*values[i], value(field));
      }
    }
  }

  void add_field(const BlockPlaces& block, std::string_view name, const Piece& value) {
    const std::string begin = block.one_line ? fmt::format("; {} = ", name) : fmt::format("\n  {:8} = ", name);
    insert(*block.last_value_end, begin + value);
  }

  void change_equation(std::size_t index) {
    const Slot slot{Item::Equation, index};
    if (slot == wanted_ || answer(draft_, slot) != answer(base_.answers, slot)) {
      edit(base_.equations[index], equation(index, 0));
    }
  }

  void add_particles() {
    Piece text;
    for (std::size_t i = base_.particles.size(); i < particles(draft_); ++i) {
      text += particle(i);
    }
    add_group(base_.particles.empty() ? std::nullopt : std::optional(base_.particles.back().block.statement), text);
  }

  void add_equations() {
    std::size_t width = 0;
    for (std::size_t i = base_.equations.size(); i < equations(draft_); ++i) {
      width = std::max(width, label(draft_.equations[i]).size());
    }
    Piece text;
    for (std::size_t i = base_.equations.size(); i < equations(draft_); ++i) {
      text += draft_.equations[i].empty() ? "" : equation(i, width) + "\n";
    }
    add_group(base_.equations.empty() ? std::nullopt : std::optional(base_.equations.back()), text);
  }

  /// Statements behind the last one of their kind, or in a paragraph of their own before `integrate`.
  void add_group(std::optional<Span> last, const Piece& text) {
    if (text.text().empty()) {
      return;
    }
    if (last) {
      insert(lines_of(*last).end, text);
    } else if (base_.integrate) {
      insert(lines_of(base_.integrate->statement).begin, text + "\n");
    } else {
      insert(static_cast<std::uint32_t>(draft_.base.size()), "\n" + text);
    }
  }

  void times() {
    const std::array<std::optional<Span>, 3> values = {base_.from, base_.to, base_.step};
    Piece block;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Slot slot{time_fields[i]};
      if (values[i]) {
        edit(*values[i], given(slot));
      } else if (slot == wanted_ || !answer(draft_, slot).empty()) {
        if (base_.integrate && base_.integrate->last_value_end) {
          add_field(*base_.integrate, field_name(slot.item), given(slot));
        } else {
          block += Piece(field_name(slot.item)) + " = " + given(slot) + "; ";
        }
      }
    }
    if (!block.text().empty()) {
      block = "integrate { " + block + "method = rk4 }\n";
      base_.integrate ? edit(lines_of(base_.integrate->statement), block)
                      : insert(static_cast<std::uint32_t>(draft_.base.size()), "\n" + block);
    }
  }

  void remove(Span statement) { edit(lines_of(statement), ""); }

  /// The statement with its indentation, the rest of its last line and that line's end, unless other statements stand
  /// there.
  Span lines_of(Span statement) const {
    const std::string_view text = draft_.base;
    const std::size_t before = text.find_last_of('\n', statement.begin == 0 ? 0 : statement.begin - 1);
    const std::size_t first = before == std::string_view::npos || statement.begin == 0 ? 0 : before + 1;
    if (text.find_first_not_of(" \t", first) == statement.begin) {
      statement.begin = static_cast<std::uint32_t>(first);
    }
    const std::size_t next = text.find_first_not_of(" \t\r", statement.end);
    if (next == std::string_view::npos || text[next] == '#' || text[next] == '\n') {
      const std::size_t line_end = text.find('\n', statement.end);
      statement.end = static_cast<std::uint32_t>(line_end == std::string_view::npos ? text.size() : line_end + 1);
    }
    return statement;
  }

  WrittenModel apply() {
    std::stable_sort(edits_.begin(), edits_.end(),
                     [](const Edit& a, const Edit& b) { return a.span.begin < b.span.begin; });
    const std::string_view base = draft_.base;
    Piece text;
    std::size_t done = 0;
    for (const Edit& edit : edits_) {
      text += base.substr(done, edit.span.begin - done);
      text += edit.text;
      done = edit.span.end;
    }
    text += base.substr(done);
    return {text.text(), text.mark().value_or(Span{})};
  }

  const Draft& draft_;
  std::optional<Slot> wanted_;
  Outline base_;
  std::vector<Edit> edits_;
};

}  // namespace

WrittenModel write_model(const Draft& draft, std::optional<Slot> wanted) { return ModelWriter(draft, wanted).write(); }

}  // namespace mbcc::dialog
