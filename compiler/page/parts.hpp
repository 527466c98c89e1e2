#pragma once
// What a page is made of, embedded at build time.

#include <string_view>

namespace mbcc::page {

/// `page.html.in`, the template; `page.js` and `page.css`, our modules with the browser libraries; `licences.txt`,
/// those of the libraries. All but the template are empty where mbcc was built without node and npm.
std::string_view part(std::string_view name);

}  // namespace mbcc::page
