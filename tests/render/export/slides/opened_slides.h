// SPDX-License-Identifier: Apache-2.0
// Reads a presentation back and checks what every reader of packages relies on (ECMA-376 part 2).
#pragma once

#include <QRectF>
#include <QStringList>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace sline::test {

class OpenedSlides {
 public:
  explicit OpenedSlides(const std::string& bytes);

  /// What is wrong with the package or one of its parts; empty for one that is whole.
  const QStringList& faults() const { return m_faults; }
  const std::map<std::string, std::string>& parts() const { return m_parts; }
  bool has(const std::string& part) const { return m_parts.contains(part); }
  /// Returns the root of a part that is XML.
  pugi::xml_node root(const std::string& part) const;
  /// Returns the root of a slide, counted from 1.
  pugi::xml_node slide(int number) const;
  int slides() const;
  /// Returns what the slide of that number points to with that type: the name of a part, or
  /// nothing.
  std::string target(const std::string& part, const std::string& type) const;

 private:
  void checkTypes();
  void checkRelations();
  void checkShapes();
  void checkOrders();

  std::map<std::string, std::string> m_parts;
  std::map<std::string, pugi::xml_document> m_documents;
  QStringList m_faults;
};

/// Returns all words below the element, each paragraph and line on a line of its own.
QString wordsOf(const pugi::xml_node& element);
/// Returns the place of a shape, millimetres of the slide.
QRectF placeOf(const pugi::xml_node& shape);
/// Returns the groups of labels and marks on a slide by their names.
std::map<QString, pugi::xml_node> groupsOn(const pugi::xml_node& slide);

}  // namespace sline::test
