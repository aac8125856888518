// SPDX-License-Identifier: Apache-2.0
// Finds the rows that match a typed text: words in any order, in any of the names of a structure or
// of the groups above it, whatever the case and the accents; of several such wishes one is enough.
#pragma once

#include <QHash>

#include "model/edit/node_sets.h"
#include "widgets/session/session.h"
#include "widgets/session/typed_wishes.h"
#include "widgets/structure_tree/structure_names.h"

namespace sline::widgets {

class RowFilter {
 public:
  void setNames(StructureNames names);
  const StructureNames& names() const { return m_names; }
  /// Sets the text; returns false where it asks for the same as before (TypedWishes).
  bool setText(const QString& text) { return m_wishes.setText(text); }
  bool active() const { return m_wishes.active(); }

  struct Left {
    model::NodeSet rows;  ///< the matches, all below them and the groups above them
    NodeIds structures;   ///< the matching structures, in tree order
  };
  Left apply(const model::Scene& scene);

 private:
  const SearchedNames& namesOf(const std::string& name);

  StructureNames m_names;
  TypedWishes m_wishes;
  QHash<QString, SearchedNames> m_known;  ///< by name
};

}  // namespace sline::widgets
