#include "dialog/check.hpp"

#include <algorithm>
#include <cmath>

#include "dialog/item.hpp"
#include "dialog/write_model.hpp"
#include "syntax/parser.hpp"

namespace mbcc::dialog {

namespace {

constexpr std::size_t name_length = 7;     // dialog A of the paper
constexpr std::size_t most_asked = 10000;  // more than anybody types; the whole draft is examined with each answer

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Checker {
 public:
  Checker(const Draft& draft, Slot slot, const std::string& typed, const Workshop& workshop, Colours colours)
      : draft_(draft), slot_(slot), typed_(typed), workshop_(workshop), colours_(colours) {}

  Verdict check() {
    if (typed_.empty()) {
      return {false, "", "an answer is needed here: `?` explains the question\n"};
    }
    switch (row_of(slot_.item).check) {
      case Check::Name:
        return check_name();
      case Check::Dimension:
        check_dimension();
        break;
      case Check::Particles:
        check_count(draft_.base.empty() ? 1 : 0);
        break;
      case Check::Equations:
        check_count(0);
        break;
      case Check::Expression:
        check_expression("let answer = ");
        break;
      case Check::Equation:
        check_expression(typed_.find(':') == std::string::npos ? "constraint : " : "constraint ");
        break;
    }
    return verdict();
  }

 private:
  Verdict check_name() {
    if (typed_ == draft_.base_name) {
      return verdict();  // that of the model that the dialog started from
    }
    const auto wrong = std::find_if(typed_.begin(), typed_.end(), [](char c) { return !is_letter(c) && !is_digit(c); });
    const std::string name = typed_.substr(0, name_length);
    if (!is_letter(typed_.front())) {
      found_.report(Finding::AnswerNoName, Span{0, 0, 1});
    } else if (wrong != typed_.end()) {
      const auto place = static_cast<std::uint32_t>(wrong - typed_.begin());
      found_.report(Finding::AnswerNoName, Span{0, place, place + 1});
    } else {
      parse_alone("system ", name);
    }
    Verdict verdict = this->verdict();
    if (verdict.accepted && name != typed_) {
      verdict.text = name;
      verdict.message = fmt::format("only the first {} characters count: {}\n", name_length, name);
    }
    return verdict;
  }

  void check_dimension() {
    const std::optional<std::size_t> value = natural(typed_);
    if (!value) {
      found_.report(Finding::AnswerNotNatural, everything());
    } else if (*value < 1 || *value > 3) {
      found_.report(Finding::DimensionRange, everything(), *value);
    }
  }

  void check_count(std::size_t least) {
    const std::optional<std::size_t> value = natural(typed_);
    if (!value) {
      found_.report(Finding::AnswerNotNatural, everything());
    } else if (*value < least) {
      found_.report(Finding::AnswerTooSmall, everything(), least);
    } else if (*value > most_asked) {
      found_.report(Finding::AnswerTooLarge, everything(), most_asked);
    }
  }

  void check_expression(std::string_view begin) {
    parse_alone(begin, typed_);
    if (!found_.has_errors()) {
      check_in_model();
    }
  }

  /// The answer as all that stands between `begin` and the next statement: nothing in it may end that earlier.
  void parse_alone(std::string_view begin, const std::string& answer) {
    Sources sources;
    Diagnostics diagnostics;
    const auto shift = static_cast<std::uint32_t>(begin.size());
    sources.add("", fmt::format("{}{}\nlet next = 0\n", begin, answer));
    const ast::ModelFile file = parse(lex(sources, 0, diagnostics), diagnostics);
    const auto size = static_cast<std::uint32_t>(answer.size());
    take(diagnostics, {0, shift, shift + size});
    if (found_.has_errors()) {
      return;
    }
    const std::uint32_t end = file.statements.front().span.end - shift;
    if (end < size) {
      found_.report(Finding::AnswerEnds, Span{0, end, size});
    }
  }

  /// The answer in its place in the whole model.
  void check_in_model() {
    Draft draft = draft_;
    answer(draft, slot_) = typed_;
    const WrittenModel model = write_model(draft, slot_);
    const Findings findings = workshop_.examine(draft.path, model.text, Depth::Language);
    take(findings.diagnostics, model.wanted);
    if (slot_.item == Item::To && !found_.has_errors()) {
      explain_last_step(findings.times);
    }
  }

  void explain_last_step(const model::Integration& times) {
    const double span = times.to.value_or(0) - times.from.value_or(0);
    const double steps = span / times.step.value_or(span);
    constexpr double rounding = 1e-9;  // the grid of steps has room for it
    if (steps > std::floor(steps) + rounding && steps < std::ceil(steps) - rounding) {
      found_.report(Finding::LastStepShorter, everything(), *times.step, span, span - std::floor(steps) * *times.step);
    }
  }

  /// Takes over what is said about `answer`, a place in another text; what only ends or begins in it counts as well.
  void take(const Diagnostics& diagnostics, Span answer) {
    const auto touches = [&](Span span) { return span.begin <= answer.end && span.end >= answer.begin; };
    const auto moved = [&](Span span) {
      const std::uint32_t begin = std::clamp(span.begin, answer.begin, answer.end);
      const std::uint32_t end = std::clamp(span.end, begin, answer.end);
      return Span{0, begin - answer.begin, end - answer.begin};
    };
    for (Diagnostic diagnostic : diagnostics.all()) {
      if (diagnostic.span.file == 0 && touches(diagnostic.span)) {
        diagnostic.span = moved(diagnostic.span);
        diagnostic.notes.clear();  // they point at other answers, of which nothing is to be seen here
        found_.add(std::move(diagnostic));
      }
    }
  }

  Span everything() const { return {0, 0, static_cast<std::uint32_t>(typed_.size())}; }

  Verdict verdict() const {
    Sources sources;
    sources.add(label(draft_, slot_), typed_);
    return {!found_.has_errors(), typed_, render(found_, sources, colours_)};
  }

  const Draft& draft_;
  Slot slot_;
  const std::string& typed_;
  const Workshop& workshop_;
  Colours colours_;
  Diagnostics found_;  ///< in the answer: spans count from its first character
};

}  // namespace

Verdict check_answer(const Draft& draft, Slot slot, const std::string& typed, const Workshop& workshop,
                     Colours colours) {
  return Checker(draft, slot, typed, workshop, colours).check();
}

}  // namespace mbcc::dialog
