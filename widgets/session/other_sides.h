// SPDX-License-Identifier: Apache-2.0
// Knows which structures lie on the other side of the body than their names say.
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "model/scene/scene.h"
#include "widgets/session/background_queue.h"

namespace sline::widgets {

/// Compares names and places anew only where either has changed, and beside the window: the words
/// of thousands of names take their time. Until then what was known of the document holds.
class OtherSides : public QObject {
  Q_OBJECT
 public:
  /// Takes the scene as it is now, of that opening.
  void follow(const model::Scene& scene, int opening);

  /// Tells whether the structure lies on the other side.
  bool has(model::NodeId structure) const;
  /// Says so of all in a sentence (model::otherSidesText), in English; empty where there are none.
  const std::string& text() const { return m_text; }

 signals:
  void changed();

 private:
  /// What the answer depends on, of one structure.
  struct Compared {
    std::string name;
    std::string frame;
    model::Evidence sides;
    model::Evidence ofName;
    model::MeshPtr mesh;
    bool of(const model::Node& node) const;
  };
  bool holdsFor(const model::Scene& scene) const;
  void take(std::vector<model::NodeId> structures, std::string text);

  std::vector<Compared> m_comparedOf;
  int m_opening = 0;
  std::vector<model::NodeId> m_structures;
  std::string m_text;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
