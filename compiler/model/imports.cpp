#include "model/imports.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

namespace mbcc::model {
namespace {

class Gathering {
 public:
  Gathering(const Sources& sources, const Importer& import, Reporter& report)
      : sources_(sources), import_(import), report_(report) {}

  Statements run(const ast::ModelFile& model) {
    open_.push_back({std::filesystem::path(sources_[0].name()).lexically_normal().string(), 0, {}});
    add(model);
    return std::move(gathered_);
  }

 private:
  /// A file that is being read: its path, which is its identity, and the import that asked for it.
  struct Open {
    std::string path;
    std::uint32_t file;
    Span import;
  };

  void add(const ast::ModelFile& model) {
    for (const ast::Statement& statement : model.statements) {
      if (const auto* import = std::get_if<ast::Import>(&statement.node)) {
        follow(*import);
      } else {
        gathered_.all.push_back(&statement);
      }
    }
  }

  void follow(const ast::Import& import) {
    const std::filesystem::path importing = sources_[open_.back().file].name();
    const std::string path = (importing.parent_path() / import.path).lexically_normal().string();
    if (closes_cycle(import, path) || std::find(done_.begin(), done_.end(), path) != done_.end()) {
      return;
    }
    done_.push_back(path);
    const std::size_t errors = report_.diagnostics().errors();
    std::optional<ImportedFile> read = import_(import.path, open_.back().file);
    if (!read) {
      report_.report(Finding::CannotImport, import.path_span, import.path);
    }
    if (report_.diagnostics().errors() > errors) {
      report_.lose_names();
    }
    if (read) {
      gathered_.imported.push_back(std::move(read->model));
      open_.push_back({path, read->file, import.path_span});
      add(gathered_.imported.back());
      open_.pop_back();
    }
  }

  bool closes_cycle(const ast::Import& import, const std::string& path) {
    const auto first = std::find_if(open_.begin(), open_.end(), [&](const Open& open) { return open.path == path; });
    if (first == open_.end()) {
      return false;
    }
    Diagnostic& finding = report_.report(Finding::ImportCycle, import.path_span, import.path);
    for (auto between = first + 1; between != open_.end(); ++between) {
      finding.note(between->import, "by way of this import");
    }
    return true;
  }

  const Sources& sources_;
  const Importer& import_;
  Reporter& report_;
  Statements gathered_;
  std::vector<Open> open_;
  std::vector<std::string> done_;
};

}  // namespace

Statements gather(const ast::ModelFile& model, const Sources& sources, const Importer& import, Reporter& report) {
  return Gathering(sources, import, report).run(model);
}

}  // namespace mbcc::model
