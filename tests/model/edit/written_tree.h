// SPDX-License-Identifier: Apache-2.0
// Writes scenes' trees as text: "A(B!(b c) a) d!" has groups in capitals, "!" after a locked node.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "model/scene/scene.h"
#include "tests/support/shapes.h"

namespace sline::test {

inline model::Scene readTree(const QString& text) {
  const model::MeshPtr ball = sphere(1.0f, 0);
  model::Scene scene;
  std::vector<model::NodeId> groups{model::rootId};
  for (qsizetype at = 0; at < text.size();) {
    if (text[at] == '(' || text[at] == ' ') {
      ++at;
    } else if (text[at] == ')') {
      groups.pop_back();
      ++at;
    } else {
      model::Node node{.parent = groups.back()};
      for (; at < text.size() && text[at].isLetterOrNumber(); ++at)
        node.name += text[at].toLatin1();
      if (at < text.size() && text[at] == '!') {
        node.locked = true;
        ++at;
      }
      const bool group = at < text.size() && text[at] == '(';
      node.mesh = group ? nullptr : ball;
      const model::NodeId id = scene.append(node);
      if (group)
        groups.push_back(id);
    }
  }
  return scene;
}

inline QString writtenTree(const model::Scene& scene, model::NodeId parent = model::rootId) {
  QStringList parts;
  for (const model::NodeId id : scene.children(parent)) {
    const model::Node& node = *scene.find(id);
    QString part = QString::fromStdString(node.name) + (node.locked ? "!" : "");
    if (node.isGroup())
      part += "(" + writtenTree(scene, id) + ")";
    parts << part;
  }
  return parts.join(' ');
}

/// Returns the node of that name. "root" is the root; an unknown name gives an id that is unknown
/// too.
inline model::NodeId nodeNamed(const model::Scene& scene, const QString& name) {
  for (const model::Node& node : scene.nodes())
    if (name.toStdString() == node.name)
      return node.id;
  return name == "root" || name.isEmpty() ? model::rootId : model::NodeId{12345};
}

inline std::vector<model::NodeId> nodesNamed(const model::Scene& scene, const QString& names) {
  std::vector<model::NodeId> ids;
  for (const QString& name : names.split(' ', Qt::SkipEmptyParts))
    ids.push_back(nodeNamed(scene, name));
  return ids;
}

}  // namespace sline::test
