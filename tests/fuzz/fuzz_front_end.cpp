// libFuzzer on the front end: any bytes are read, refused or resolved, and never crash or hang it.

#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/read_model.hpp"
#include "model/resolve.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mbcc;
  std::string text(data, data + size);
  fuzz::read_model(text);

  Sources sources;
  sources.add("model.mbd", std::move(text));
  Diagnostics diagnostics;
  const ast::ModelFile tree = parse(lex(sources, 0, diagnostics), diagnostics);
  const Importer no_files = [](const std::string&, std::uint32_t) { return std::nullopt; };
  const std::optional<model::System> system = resolve(tree, sources, no_files, diagnostics);
  MBCC_ASSERT(system.has_value() || diagnostics.has_errors());
  if (system) {
    MBCC_ASSERT(!print(*system).empty());
  }
  render(diagnostics, sources);
  return 0;
}
