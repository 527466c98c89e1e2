#include "syntax/foreign_signs.hpp"

#include <algorithm>
#include <array>

namespace mbcc {
namespace {

constexpr std::string_view logic = "there is no `and`, `or` and `not`; choose with one `if` inside another";
constexpr std::string_view comment = "a comment begins with `#`";
constexpr std::string_view plain_quote = "a text stands in plain quotes, `\"`";
constexpr std::string_view plain_prime = "a rate is written with a plain `'`";
constexpr std::string_view plain_space = "write a plain space";

// Longer signs before their beginnings.
constexpr std::array table = {
    ForeignSign{"||", logic},
    ForeignSign{"|", "write `abs(a)` for a number and `norm(a)` for a vector"},
    ForeignSign{"&&", logic},
    ForeignSign{"&", logic},
    ForeignSign{"!", logic},
    ForeignSign{"**", "a power is written `^`"},
    ForeignSign{"//", comment, true},
    ForeignSign{"%", comment, true},
    ForeignSign{"\\", "a statement goes on in the next line inside brackets, and after an operator or a comma"},
    ForeignSign{"\u2212", "write a plain `-`"},
    ForeignSign{"\u2013", "write a plain `-`"},
    ForeignSign{"\u00D7", "write `*`"},
    ForeignSign{"\u00B7", "write `*`"},
    ForeignSign{"\u22C5", "write `*`"},
    ForeignSign{"\u00F7", "write `/`"},
    ForeignSign{"\u00B2", "write `^2`"},
    ForeignSign{"\u00B3", "write `^3`"},
    ForeignSign{"\u221A", "write `sqrt(a)`"},
    ForeignSign{"\u03C0", "write `pi`"},
    ForeignSign{"\u2264", "write `<=`"},
    ForeignSign{"\u2265", "write `>=`"},
    ForeignSign{"\u2260", "write `!=`"},
    ForeignSign{"\u2026", "write two dots, `..`"},
    ForeignSign{"\u2032", plain_prime},
    ForeignSign{"\u2019", plain_prime},
    ForeignSign{"\u201C", plain_quote},
    ForeignSign{"\u201D", plain_quote},
    ForeignSign{"\u00A0", plain_space},
    ForeignSign{"\u202F", plain_space},
};

}  // namespace

const ForeignSign* find_foreign_sign(std::string_view text) {
  const auto begins_text = [text](const ForeignSign& row) { return text.substr(0, row.sign.size()) == row.sign; };
  const auto found = std::find_if(table.begin(), table.end(), begins_text);
  return found == table.end() ? nullptr : &*found;
}

}  // namespace mbcc
