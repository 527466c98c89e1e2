// The grammar of grammar/model.ebnf in Spirit X3, over tokens: each rule has the name of its production.

#include "syntax/parser.hpp"

#include <functional>
#include <utility>

#include "diagnostics/assert.hpp"
#include "syntax/x3/actions.hpp"
#include "syntax/x3/terminals.hpp"

namespace mbcc::grammar {
namespace {

// -- terminals --

const auto name = token(TokenKind::Name, expected::name);
const auto natural = token(TokenKind::Natural);
const auto equals = token(TokenKind::Equal);
const auto separator = token(TokenKind::Separator);
const auto another = token(TokenKind::Comma);
const auto comma = token(TokenKind::Comma, "an operator or `,`");
const auto paren_left = token(TokenKind::ParenLeft);
const auto paren_right = token(TokenKind::ParenRight, "an operator or `)`");
const auto list_end = token(TokenKind::ParenRight, "an operator, `,` or `)`");
const auto no_names = token(TokenKind::ParenRight, "a name or `)`");
const auto names_end = token(TokenKind::ParenRight, "`,` or `)`");
const auto bracket_left = token(TokenKind::BracketLeft);
const auto bracket_right = token(TokenKind::BracketRight, "an operator, `,` or `]`");
const auto brace_left = token(TokenKind::BraceLeft);
const auto in = contextual("in", "`in`");

bool is_sign(const Token& token) { return token.kind == TokenKind::Plus || token.kind == TokenKind::Minus; }
bool is_times(const Token& token) { return token.kind == TokenKind::Star || token.kind == TokenKind::Slash; }
bool compares(const Token& token) { return is_comparison(token.kind); }
bool is_word(const Token& token) { return token.kind == TokenKind::Name || is_reserved(token.kind); }
bool declares_variable(const Token& token) {
  return token.kind == TokenKind::Coordinate || token.kind == TokenKind::Speed || token.kind == TokenKind::State;
}
bool tells_motion(const Token& token) {
  return token.kind == TokenKind::Kinematics || token.kind == TokenKind::Equation;
}
bool tells_energy(const Token& token) { return token.kind == TokenKind::Kinetic || token.kind == TokenKind::Potential; }
bool names_field(const Token& token) { return token.kind == TokenKind::Name || token.kind == TokenKind::Force; }
bool ends_statement(const Token& token) {
  return token.kind == TokenKind::Separator || token.kind == TokenKind::BraceRight ||
         token.kind == TokenKind::EndOfFile;
}
/// A statement's word inside a block means that the block's `}` is missing.
bool ends_fields(const Token& token) {
  return ends_statement(token) || (begins_statement(token.kind) && !names_field(token));
}
bool has_no_meaning_here(const Token& token) { return !ends_statement(token) && token.kind != TokenKind::BraceLeft; }

const auto sign = token_where(is_sign, "a sign");
const auto times = token_where(is_times, "an operator");
const auto comparison_sign = token_where(compares, expected::comparison);
const auto word = token_where(is_word, expected::name);
const auto field_name = token_where(names_field, expected::field_or_end);
const auto anything = token_where(has_no_meaning_here, "a token");
const auto end = &token_where(ends_statement, "the end of the statement");
const auto end_of_value = &token_where(ends_statement, "an operator or the end of the statement");
const auto end_of_part = &token_where(ends_statement, "`{` or the end of the statement");
const auto end_of_fields = &token_where(ends_fields, expected::field_or_end);

/// One or several, with commas between them.
template <class Parser>
auto list(const Parser& element) {
  return element >> *(another > element);
}

// -- expressions --

const x3::rule<class expression_id, ast::Expression> expression("an expression");
const x3::rule<class term_id, ast::Expression> term("an operand");
const x3::rule<class factor_id, ast::Expression> factor("an operand");
const x3::rule<class power_id, ast::Expression> power("an operand");
const x3::rule<class exponent_id, ast::Expression> exponent("an operand");
const x3::rule<class operand_id, ast::Expression> operand("an operand");
const x3::rule<class number_id, ast::Expression> number("a number");
const x3::rule<class atom_id, ast::Expression> atom("an operand");
const x3::rule<class sum_id, ast::Sum> sum("a sum");
const x3::rule<class conditional_id, ast::Call> conditional("an `if`");
const x3::rule<class comparison_id, ast::Expression> comparison("an expression");
const x3::rule<class call_id, ast::Call> call("a function");
const x3::rule<class parentheses_id, std::vector<ast::Expression>> parentheses("`(`");
const x3::rule<class reference_id, ast::Reference> reference("a name");
const x3::rule<class step_id, ast::Step> step("a name");
const x3::rule<class member_id, ast::Step> member("a name");
const x3::rule<class indices_id, std::vector<ast::Expression>> indices("`[`");
const x3::rule<class range_id, std::vector<ast::Expression>> range("an expression");
const x3::rule<class signs_id, std::vector<Token>> signs("a sign");

const auto expression_def = term[take] >> *(sign > term)[combine];
const auto term_def = factor[take] >> *(times > factor)[combine];
const auto factor_def = power[take] | (signs > power)[apply_signs];
const auto power_def = operand[take] >> *(token(TokenKind::Caret) > exponent)[combine];
const auto exponent_def = operand[take] | (signs > operand)[apply_signs];
const auto operand_def = number[take] | (atom[take] >> *token(TokenKind::Prime)[apply_prime]);
const auto number_def = placed(natural[take_number] | token(TokenKind::Real)[take_number]);
const auto atom_def = placed(sum[take_node] | conditional[take_node] | call[take_node] | reference[take_node] |
                             parentheses[take_parentheses]);
const auto sum_def = token(TokenKind::Sum) > paren_left >
                     nested(name[text_into(&ast::Sum::index, &ast::Sum::index_span)] > in >
                            range[into(&ast::Sum::bounds)] > comma >
                            expression[append_to(&ast::Sum::body)]) > paren_right;
const auto conditional_def = token(TokenKind::If)[text_into(&ast::Call::function, &ast::Call::function_span)] >
                             paren_left > nested(comparison[append_to(&ast::Call::arguments)] > comma >
                                                 expression[append_to(&ast::Call::arguments)] > comma >
                                                 expression[append_to(&ast::Call::arguments)]) > paren_right;
const auto comparison_def = expression[take] > (comparison_sign > expression)[compare];
const auto call_def = (name[text_into(&ast::Call::function, &ast::Call::function_span)] >> paren_left) >
                      nested(list(expression[append_to(&ast::Call::arguments)])) > list_end;
const auto parentheses_def = paren_left > nested(list(expression[append])) > list_end;
const auto reference_def = step[append_to(&ast::Reference::steps)] >>
                           *(token(TokenKind::Dot) > member[append_to(&ast::Reference::steps)]);
const auto step_def = placed(name[text_into(&ast::Step::name)] >> -indices[into(&ast::Step::indices)]);
const auto member_def = placed(word[text_into(&ast::Step::name)] >> -indices[into(&ast::Step::indices)]);
const auto indices_def = bracket_left > nested(list(expression[append])) > bracket_right;
const auto range_def = expression[append] > token(TokenKind::DotDot, "an operator or `..`") > expression[append];
const auto signs_def = +sign[append];

BOOST_SPIRIT_DEFINE(expression, term, factor, power, exponent, operand, number, atom, sum, conditional, comparison,
                    call, parentheses, reference, step, member, indices, range, signs)

// -- statements --

const x3::rule<class model_id, ast::ModelFile> model("a model");
const x3::rule<class statements_id, std::vector<ast::Statement>> statements("a statement");
const x3::rule<class whole_statement_id, ast::Statement> whole_statement("a statement");
const x3::rule<class statement_id, ast::StatementNode> statement(expected::statement.data());
const x3::rule<class system_id, ast::System> system("a statement");
const x3::rule<class dimension_id, ast::Dimension> dimension("a statement");
const x3::rule<class particle_id, ast::Particle> particle("a statement");
const x3::rule<class particle_name_id, ast::Declarator> particle_name(expected::name_or_number.data());
const x3::rule<class variable_id, ast::Variable> variable("a statement");
const x3::rule<class motion_id, ast::Motion> motion("a statement");
const x3::rule<class moving_id, ast::Expression> moving("a name");
const x3::rule<class energy_id, ast::Energy> energy("a statement");
const x3::rule<class constraint_id, ast::Constraint> constraint("a statement");
const x3::rule<class let_id, ast::Let> let("a statement");
const x3::rule<class constant_id, ast::Constant> constant("a statement");
const x3::rule<class parameter_id, ast::Parameter> parameter("a statement");
const x3::rule<class output_id, ast::Output> output("a statement");
const x3::rule<class force_on_id, ast::ForceOn> force_on("a statement");
const x3::rule<class target_id, ast::Expression> target("a particle");
const x3::rule<class gravity_id, ast::Gravity> gravity("a statement");
const x3::rule<class import_file_id, ast::Import> import_file("a statement");
const x3::rule<class integrate_id, ast::Integrate> integrate("a statement");
const x3::rule<class module_definition_id, ast::Module> module_definition("a statement");
const x3::rule<class formals_id, std::vector<ast::Formal>> formals("`(`");
const x3::rule<class formal_id, ast::Formal> formal("a name");
const x3::rule<class part_id, ast::Part> part("a statement");
const x3::rule<class givens_id, std::vector<ast::Field>> givens("`(`");
const x3::rule<class given_id, ast::Field> given("a name");
const x3::rule<class point_id, ast::Point> point("a statement");
const x3::rule<class port_id, ast::Port> port("a statement");
const x3::rule<class for_loop_id, ast::For> for_loop("a statement");
const x3::rule<class unsupported_id, ast::Unsupported> unsupported("a statement");
const x3::rule<class group_id> group("`{`");
const x3::rule<class block_id, std::vector<ast::Field>> block("`{`");
const x3::rule<class field_id, ast::Field> field("a field");
const x3::rule<class declared_id, ast::Declarator> declared(expected::name.data());
const x3::rule<class plain_name_id, ast::Declarator> plain_name(expected::name.data());

const auto model_def = statements[append_statements] >>
                       *(token(TokenKind::BraceRight)[unmatched_brace] >> statements[append_statements]) >>
                       token(TokenKind::EndOfFile);
const auto statements_def = -whole_statement[append_finished] >> *(separator >> -whole_statement[append_finished]);
const auto whole_statement_def = recovering(placed(!end >> x3::expect[statement][into(&ast::Statement::node)]));
const auto statement_def = system[take] | dimension[take] | particle[take] | variable[take] | motion[take] |
                           energy[take] | constraint[take] | let[take] | constant[take] | parameter[take] |
                           output[take] | force_on[take] | gravity[take] | import_file[take] | integrate[take] |
                           module_definition[take] | part[take] | point[take] | port[take] | for_loop[take] |
                           unsupported[take];

const auto system_def = token(TokenKind::System) > name[text_into(&ast::System::name, &ast::System::name_span)] > end;
const auto dimension_def = token(TokenKind::Dimension) > expression[into(&ast::Dimension::value)] > end_of_value;
const auto particle_def =
    token(TokenKind::Particle) > particle_name[into(&ast::Particle::name)] > block[into(&ast::Particle::fields)] > end;
const auto particle_name_def = placed(declared[take] | natural[take_particle_number]);
const auto variable_def =
    token_where(declares_variable, expected::statement)[made_into(&ast::Variable::kind, tree::variable_kind)] >
    declared[into(&ast::Variable::name)] > block[into(&ast::Variable::fields)] > end;
const auto motion_def = token_where(tells_motion,
                                    expected::statement)[made_into(&ast::Motion::kind, tree::motion_kind)] >
                        moving[into(&ast::Motion::target)] > token(TokenKind::Prime) > equals
                        > expression[into(&ast::Motion::value)] > end_of_value;
const auto moving_def = placed(reference[take_node]);
const auto energy_def =
    token_where(tells_energy, expected::statement)[made_into(&ast::Energy::kind, tree::energy_kind)] >
    expression[into(&ast::Energy::value)] > end_of_value;
const auto constraint_def = token(TokenKind::Constraint) > -declared[into(&ast::Constraint::label)] >
                            token(TokenKind::Colon,
                                  "`:` before the equation") > expression[append_to(&ast::Constraint::sides)] >
                            *(equals > expression[append_to(&ast::Constraint::sides)]) > end_of_value;
const auto let_def = token(TokenKind::Let) > declared[into(&ast::Let::name)] > equals >
                     expression[into(&ast::Let::value)] > end_of_value;
const auto constant_def = token(TokenKind::Constant) > declared[into(&ast::Constant::name)] > equals >
                          expression[into(&ast::Constant::value)] > end_of_value;
const auto parameter_def = token(TokenKind::Parameter) > declared[into(&ast::Parameter::name)] > equals >
                           expression[into(&ast::Parameter::value)] > end_of_value;
const auto output_def = token(TokenKind::Output) > declared[into(&ast::Output::name)] > equals >
                        expression[into(&ast::Output::value)] > end_of_value;
const auto force_on_def = token(TokenKind::Force) >
                          contextual("on", "`on` and a particle") > target[into(&ast::ForceOn::target)] > equals
                          > expression[into(&ast::ForceOn::value)] > end_of_value;
const auto target_def = placed(reference[take_node] | natural[take_number]);
const auto gravity_def = token(TokenKind::Gravity) > expression[into(&ast::Gravity::value)] > end_of_value;
const auto import_file_def = token(TokenKind::Import) > token(TokenKind::Text, "a file in quotes")[take_path] > end;
const auto integrate_def = token(TokenKind::Integrate) > block[into(&ast::Integrate::fields)] > end;
const auto module_definition_def = token(TokenKind::Module) > plain_name[into(&ast::Module::name)] >
                                   formals[into(&ast::Module::formals)] > brace_left >
                                   nested(statements[into(&ast::Module::body)]) >
                                   token(TokenKind::BraceRight, "a statement or `}`") > end;
const auto formals_def = paren_left > (no_names | (list(formal[append]) > names_end));
const auto formal_def = plain_name[into(&ast::Formal::name)] >> -(equals > expression[into(&ast::Formal::value)]);
const auto part_def = token(TokenKind::Part) > declared[into(&ast::Part::name)] > equals >
                      name[text_into(&ast::Part::module, &ast::Part::module_span)] >
                      givens[into(&ast::Part::arguments)] > -block[into(&ast::Part::ports)] > end_of_part;
const auto givens_def = paren_left > (no_names | (list(given[append]) > list_end));
const auto given_def =
    name[text_into(&ast::Field::name, &ast::Field::name_span)] > equals > expression[into(&ast::Field::value)];
const auto point_def = token(TokenKind::Point) > declared[into(&ast::Point::name)] > equals >
                       expression[into(&ast::Point::value)] > end_of_value;
const auto port_def = token(TokenKind::Port) > plain_name[into(&ast::Port::name)] > end;
const auto for_loop_def = token(TokenKind::For) > name[text_into(&ast::For::index, &ast::For::index_span)] > in >
                          range[into(&ast::For::bounds)] > token(TokenKind::BraceLeft, "an operator or `{`") >
                          nested(statements[into(&ast::For::body)]) >
                          token(TokenKind::BraceRight, "a statement or `}`") > end;
const auto unsupported_def = token(TokenKind::LaterWord)[text_into(&ast::Unsupported::keyword)] >> *(anything | group);
const auto group_def = brace_left > nested(*(anything | separator | group)) > token(TokenKind::BraceRight);

const auto block_def = brace_left > (-field[append_finished] >> *(separator >> -field[append_finished])) >
                       token(TokenKind::BraceRight, expected::field_or_end);
const auto field_def =
    recovering((!end_of_fields >> x3::expect[field_name][text_into(&ast::Field::name, &ast::Field::name_span)]) >
               equals > expression[into(&ast::Field::value)] > end_of_value);
const auto declared_def = placed(name[text_into(&ast::Declarator::name)] >> -indices[into(&ast::Declarator::indices)]);

const auto plain_name_def = placed(name[text_into(&ast::Declarator::name)]);

BOOST_SPIRIT_DEFINE(model, statements, whole_statement, statement, system, dimension, particle, particle_name, variable,
                    motion, moving, energy, constraint, let, constant, parameter, output, force_on, target, gravity,
                    import_file, integrate, module_definition, formals, formal, part, givens, given, point, port,
                    for_loop, unsupported, group, block, field, declared, plain_name)

}  // namespace
}  // namespace mbcc::grammar

namespace mbcc {

ast::ModelFile parse(const TokenBuffer& tokens, Diagnostics& diagnostics) {
  grammar::State state{SyntaxErrors(tokens, diagnostics)};
  ast::ModelFile model;
  TokenIterator first = tokens.begin();
  const auto parser = boost::spirit::x3::with<grammar::state_tag>(std::ref(state))[grammar::model];
  const bool read = boost::spirit::x3::parse(first, tokens.end(), parser, model);
  MBCC_ASSERT(read && first == tokens.end());
  return model;
}

}  // namespace mbcc
