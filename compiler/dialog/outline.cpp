#include "dialog/outline.hpp"

#include <string>

#include "source/text.hpp"
#include "syntax/parser.hpp"

namespace mbcc::dialog {

namespace {

class OutlineReader {
 public:
  explicit OutlineReader(std::string_view text) { sources_.add("", std::string(text)); }

  Outline read() {
    Diagnostics ignored;
    const ast::ModelFile file = parse(lex(sources_, 0, ignored), ignored);
    const std::string_view text = sources_[0].text();
    const std::size_t first = file.statements.empty() ? text.size() : file.statements.front().span.begin;
    found_.first_statement = static_cast<std::uint32_t>(text.substr(0, first).find_last_of('\n') + 1);
    for (const ast::Statement& statement : file.statements) {
      std::visit([&](const auto& node) { visit(node, statement); }, statement.node);
    }
    found_.answers.particle_count = std::to_string(found_.particles.size());
    found_.answers.equation_count = std::to_string(found_.equations.size());
    return std::move(found_);
  }

 private:
  template <class Other>
  void visit(const Other& /*not asked for*/, const ast::Statement& /*statement*/) {}

  void visit(const ast::System& system, const ast::Statement& /*statement*/) {
    found_.name = system.name_span;
    found_.answers.name = system.name;
  }

  void visit(const ast::Dimension& dimension, const ast::Statement& /*statement*/) {
    found_.dimension = dimension.value.span;
    found_.answers.dimension = text(dimension.value.span);
  }

  void visit(const ast::Particle& particle, const ast::Statement& statement) {
    Particle answers{text(particle.name.span), "", {}, {}, {}};
    ParticlePlaces places{block(statement, particle.fields), {}, {}, {}, {}};
    for (const ast::Field& field : particle.fields) {
      if (field.name == "mass") {
        answers.mass = text(field.value.span);
        places.mass = field.value.span;
      } else if (field.name == "position") {
        read_quantity(field.value, answers.position, places.position);
      } else if (field.name == "velocity") {
        read_quantity(field.value, answers.velocity, places.velocity);
      } else if (field.name == "force") {
        read_quantity(field.value, answers.force, places.force);
      }
    }
    found_.answers.particles.push_back(std::move(answers));
    found_.particles.push_back(places);
  }

  void visit(const ast::Constraint& constraint, const ast::Statement& statement) {
    const Span first = constraint.label ? constraint.label->span : constraint.sides.front().span;
    const Span whole = join(first, constraint.sides.back().span);
    found_.answers.equations.push_back(text(whole));
    found_.equations.push_back({statement.span, whole});
  }

  void visit(const ast::Integrate& integrate, const ast::Statement& statement) {
    found_.integrate = block(statement, integrate.fields);
    for (const ast::Field& field : integrate.fields) {
      if (field.name == "step") {
        found_.answers.step = text(field.value.span);
        found_.step = field.value.span;
      } else if (field.name == "from") {
        found_.answers.from = text(field.value.span);
        found_.from = field.value.span;
      } else if (field.name == "to") {
        found_.answers.to = text(field.value.span);
        found_.to = field.value.span;
      }
    }
  }

  void read_quantity(const ast::Expression& value, Quantity& quantity, std::optional<Span>& place) {
    place = value.span;
    const auto* vector = std::get_if<ast::Vector>(&value.node);
    if (vector == nullptr || vector->components.size() > quantity.components.size()) {
      quantity.components[0] = text(value.span);
      quantity.whole = found_.answers.dimension != "1";
      return;
    }
    for (std::size_t axis = 0; axis < vector->components.size(); ++axis) {
      quantity.components[axis] = text(vector->components[axis].span);
    }
  }

  /// In a block of several lines a field may follow behind the line of the last one, with its comment.
  BlockPlaces block(const ast::Statement& statement, const std::vector<ast::Field>& fields) const {
    BlockPlaces places{statement.span, {}, false};
    if (!fields.empty()) {
      const std::uint32_t end = fields.back().value.span.end;
      const std::size_t line_end = sources_[0].text().find('\n', end);
      places.one_line = line_end >= statement.span.end;
      places.end_of_fields = places.one_line ? end : static_cast<std::uint32_t>(line_end);
    }
    return places;
  }

  std::string text(Span span) const { return one_line(sources_.text(span)); }

  Sources sources_;
  Outline found_;
};

}  // namespace

Outline outline(std::string_view text, std::string_view name) {
  Outline found = OutlineReader(text).read();
  found.answers.base = text;
  if (found.answers.name.empty()) {
    found.answers.name = name;
  }
  found.answers.base_name = found.answers.name;
  return found;
}

}  // namespace mbcc::dialog
