#pragma once
// A result as one HTML file that needs nothing else: figures, the moving scene, and the data of both.

#include <string>

#include "figure/table.hpp"
#include "page/scene.hpp"

namespace mbcc::page {

/// Whether the browser libraries were there when mbcc was built; if not, pages have their data but show nothing.
bool available();

/// The text of the page, which calls itself `title`; `source` names what it was made from. A long result is thinned so
/// that the page stays below 3 MB if there are not thousands of columns.
std::string write_page(const figure::Table& table, const Skeleton& skeleton, const std::string& title,
                       const std::string& source);

}  // namespace mbcc::page
