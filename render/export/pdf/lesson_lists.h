// SPDX-License-Identifier: Apache-2.0
// Sets a lesson's contents and its index, whose page numbers are links.
#pragma once

#include <QString>
#include <set>
#include <vector>

#include "render/export/pdf/pdf_navigation.h"
#include "render/export/pdf/sheet_header.h"

namespace sline::render {

struct ContentsEntry {
  QString text;
  std::size_t page = 0;  ///< counted from 0, like all pages here
};

struct IndexEntry {
  QString name;
  std::set<std::size_t> pages;
};

/// What both are set on and with.
struct LessonSetting {
  SheetPages& pages;
  PageCount& count;
  const SheetLayout& layout;
  std::vector<PdfLink>& links;
  QString title;  ///< of the lesson
};

/// Sets the contents from a new page on; returns what had to be shortened.
std::vector<QString> setContents(const LessonSetting& setting, const QString& heading,
                                 const std::vector<ContentsEntry>& entries);

/// Returns how many pages both take.
std::size_t contentsPages(const SheetLayout& layout, std::size_t entries);
std::size_t indexPages(const SheetLayout& layout, std::size_t entries);

/// Returns the entries in the order of the language's alphabet, those of one name as one.
std::vector<IndexEntry> sortedIndex(std::vector<IndexEntry> entries, const std::string& language);
/// Sets the index from a new page on; returns what had to be shortened.
std::vector<QString> setIndex(const LessonSetting& setting, const QString& heading,
                              const std::vector<IndexEntry>& entries);

}  // namespace sline::render
