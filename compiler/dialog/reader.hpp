#pragma once
// Where answers come from: a terminal or a pipe, and the talk between one of them and a session.

#include <concepts>
#include <string>
#include <string_view>

#include "dialog/session.hpp"

namespace mbcc::dialog {

/// What came of a question.
struct Reply {
  enum class Kind { Line, End, Interrupt };
  Kind kind = Kind::Line;
  std::string text;  ///< the line, or what stood in it when the user went away
};

template <class R>
concept Reader = requires(R& reader, const Question& question, std::string_view lines) {
  { reader.ask(question) } -> std::same_as<Reply>;
  reader.say(lines);
};

/// Asks until the session has ended.
template <Reader R>
void converse(Session& session, R& reader) {
  reader.say(session.begin());
  while (!session.ending()) {
    const Reply reply = reader.ask(session.question());
    switch (reply.kind) {
      case Reply::Kind::Line:
        reader.say(session.answer(reply.text));
        break;
      case Reply::Kind::End:
        reader.say(session.leave(reply.text, Ending::Unfinished));
        break;
      case Reply::Kind::Interrupt:
        reader.say(session.leave(reply.text, Ending::Interrupted));
        break;
    }
  }
}

}  // namespace mbcc::dialog
