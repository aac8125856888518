// SPDX-License-Identifier: Apache-2.0
// Lists what is known of a structure or a group: where it came from, how large it is, how import
// changed it, how it is drawn and which node decides that.
#pragma once

#include <QDialog>
#include <vector>

#include "model/geometry/extent.h"
#include "model/scene/known_frame.h"
#include "widgets/session/other_sides.h"
#include "widgets/session/session.h"

class QFormLayout;

namespace sline::widgets {

struct Property {
  QString id;  ///< its name in tests
  QString label;
  QString text;
};

/// Returns all properties except area and volume, which take long on a large mesh.
std::vector<Property> propertiesOf(const model::Scene& scene, const NodeIds& ids,
                                   const OtherSides& otherSides);
/// Returns the area of the structures, and the volume of those that are closed, in the unit that
/// their scene is drawn in.
std::vector<Property> extentProperties(const std::vector<model::Node>& structures,
                                       model::DrawnUnit unit);

/// Shows the properties as they are when it opens, as text that can be selected and copied, and
/// fields in which one says whose work the surfaces are.
class StructureProperties : public QDialog {
  Q_OBJECT
 public:
  /// `explanation` says why a single structure is drawn as it is; it may be empty.
  StructureProperties(Session& session, const NodeIds& ids, const QString& explanation,
                      QWidget* parent = nullptr);

 private:
  void add(const std::vector<Property>& properties);
  void addCredit(Session& session, const NodeIds& ids);
  void copy() const;

  QFormLayout* m_form;
  QStringList m_lines;
};

}  // namespace sline::widgets
