// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/disk/zip_archive.h"
#include "render/export/order/export_order.h"

namespace sline::render {

/// By which standard a package's page talks to its learning system.
enum class PageStandard { scorm12, scorm2004, cmi5 };

/// What a manifest says of its page.
struct PageAbout {
  std::string title;     ///< plain text
  std::string language;  ///< BCP 47
  ExportCredit credit;
  double passing = 0.5;  ///< the share of right answers from which on it is passed
};

/// Returns the name of the standard as the page's facts have it: "scorm12".
const char* reportName(PageStandard standard);

/// Returns the members of a package of the page's files, of which index.html is the page, with the
/// manifest of the standard: imsmanifest.xml or cmi5.xml.
std::vector<model::ZipMember> pagePackage(PageStandard standard,
                                          const std::map<std::string, std::string>& files,
                                          const PageAbout& about);

}  // namespace sline::render
