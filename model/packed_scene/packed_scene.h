// SPDX-License-Identifier: Apache-2.0
// Encodes a scene in few bytes, for pages that travel: scene.json and packed meshes. What such a
// page does not show is left out: scans, notes of speakers, file names, and what other programs
// have written into the file.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "model/scene_json/scene_json.h"

namespace sline::model {

/// A scene in two parts: `first` can be shown alone, `rest` brings the structures that may come
/// later, and is empty where there are none.
struct PackedScene {
  std::string first;
  std::string rest;
};

/// Says what is packed how.
struct PackingChoice {
  std::set<NodeId> later;  ///< structures that `rest` brings
  bool names = true;       ///< false: no name of a structure, no label's text, no view's words
};

/// Packs the scene. Meshes keep their shape within 1/131,070 of their largest side; places on
/// surfaces and what is painted there move with them.
PackedScene packedScene(const Scene& scene, const PackingChoice& choice = {});

/// Takes the parts of a packed scene, none of which is trusted.
class UnpackedScene {
 public:
  /// Takes a part. The error says what is wrong with it; the scene is then as it was.
  Status take(std::string_view bytes);
  const Scene& scene() const { return m_scene; }

 private:
  MeshesByName m_meshes;
  PaintsByName m_paints;
  Scene m_scene;
};

}  // namespace sline::model
