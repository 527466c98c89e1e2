#include "dialog/pipe.hpp"

#include <fmt/format.h>

namespace mbcc::dialog {

Reply Pipe::ask(const Question& question) {
  Reply reply;
  if (!std::getline(input_, reply.text)) {
    say(question.prompt + "\n");
    return {Reply::Kind::End, ""};
  }
  say(fmt::format("{}{}\n", question.prompt, reply.text.empty() ? question.prefill : reply.text));
  return reply;
}

void Pipe::say(std::string_view lines) {
  std::fwrite(lines.data(), 1, lines.size(), output_);
  std::fflush(output_);
}

}  // namespace mbcc::dialog
