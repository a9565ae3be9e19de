#pragma once
/// One page that shows what differs: works from a file, in any browser, without a network.

#include "tools/compare/compare.h"

#include <string>
#include <vector>

namespace linkdig::compare {

/// The whole page. Frames without pictures in their details are listed without them.
std::string html_of_results(const std::vector<CaseResult>& results, ig::Scan scan);

/// The page's style and script; between them and around stands the data.
extern const char* const report_page_head;
extern const char* const report_page_script;

} // namespace linkdig::compare
