// SPDX-License-Identifier: Apache-2.0
// What is known of a structure or a group: where it came from, how large it is, what import did to
// it, how it is drawn and who says so.
#pragma once

#include <QDialog>
#include <vector>

#include "model/geometry/extent.h"
#include "widgets/session/session.h"

class QFormLayout;

namespace sline::widgets {

struct Property {
  QString id;  ///< what tests call it
  QString label;
  QString text;
};

/// All but area and volume, which take long on a large mesh.
std::vector<Property> propertiesOf(const model::Scene& scene, const NodeIds& ids);
/// Of the structures at or below the nodes; the volume of those that are closed.
std::vector<Property> extentProperties(const std::vector<model::MeshPtr>& meshes);

/// The properties as they are when it opens, as text that can be selected and copied.
class StructureProperties : public QDialog {
  Q_OBJECT
 public:
  StructureProperties(const Session& session, const NodeIds& ids, QWidget* parent = nullptr);

 private:
  void add(const std::vector<Property>& properties);
  void copy() const;

  QFormLayout* m_form;
  QStringList m_lines;
};

}  // namespace sline::widgets
