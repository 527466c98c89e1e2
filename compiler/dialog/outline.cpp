#include "dialog/outline.hpp"

#include <string>

#include "syntax/parser.hpp"

namespace mbcc::dialog {

namespace {

/// The text of an answer on one line, without comments.
std::string one_line(std::string_view text) {
  std::string line;
  bool in_comment = false;
  bool after_break = false;
  for (const char c : text) {
    in_comment = c == '#' || (in_comment && c != '\n');
    const bool is_blank = c == ' ' || c == '\t' || c == '\r';
    if (c == '\n') {
      line.erase(line.find_last_not_of(" \t\r") + 1);
      after_break = true;
    } else if (!in_comment && !(after_break && is_blank)) {
      line += after_break ? std::string(1, ' ') + c : std::string(1, c);
      after_break = false;
    }
  }
  return line;
}

class OutlineReader {
 public:
  explicit OutlineReader(std::string_view text) { sources_.add("", std::string(text)); }

  Outline read() {
    Diagnostics ignored;
    const ast::ModelFile file = parse(lex(sources_, 0, ignored), ignored);
    found_.first_statement = static_cast<std::uint32_t>(sources_[0].text().size());
    if (!file.statements.empty()) {
      found_.first_statement = file.statements.front().span.begin;
    }
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
    found_.answers.equations.push_back(text(join(first, constraint.sides.back().span)));
    found_.equations.push_back(statement.span);
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

  BlockPlaces block(const ast::Statement& statement, const std::vector<ast::Field>& fields) const {
    BlockPlaces places{statement.span, {}, false};
    if (!fields.empty()) {
      const Span last = fields.back().value.span;
      places.last_value_end = last.end;
      places.one_line = sources_.text({0, last.end, statement.span.end}).find('\n') == std::string_view::npos;
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
