// SPDX-License-Identifier: Apache-2.0
// Reads 3D Slicer's scene file (.mrml, XML; Slicer 3, 4 and 5): which models it shows, where their
// files are, their colours, places and hierarchy; its points and rulers; its camera and saved
// views.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/camera/camera.h"
#include "model/import/slicer/fiducials.h"
#include "model/import/source/raw_mesh.h"
#include "model/scene/style.h"

namespace sline::model {

struct SlicerGroup {
  std::string id;  ///< id of its node in the scene
  std::string name;
  std::optional<std::size_t> parent;  ///< index of an earlier group
  Style style;
};

struct SlicerModel {
  std::string id;
  std::string name;
  std::filesystem::path file;  ///< exists
  std::optional<std::size_t> group;
  Style style;
  std::optional<glm::dmat4> toWorld;  ///< RAS → RAS, millimetres; parents' transforms included
  Frame frame = Frame::ras;           ///< the file's, unless its own header says another
  std::string frameReason;
  bool segments = false;  ///< it is a segmentation: its surfaces have names and colours of their
                          ///< own
};

/// Holds a saved view, or, if it has the camera alone, the last view of the scene.
struct SlicerView {
  std::string name;
  Camera camera;                ///< LPS, millimetres
  std::vector<Style> groups;    ///< one for each of the scene's groups
  std::vector<Style> models;    ///< likewise; empty with `groups`: it leaves them as they are
  std::vector<bool> fiducials;  ///< which of the scene's fiducials are shown; empty: as they are
};

struct SlicerScene {
  std::vector<SlicerGroup> groups;  ///< parents first
  std::vector<SlicerModel> models;  ///< in the scene's order
  std::vector<Fiducial> fiducials;
  std::vector<std::string> fiducialIds;  ///< ids of the nodes from which `fiducials` come
  std::vector<SlicerView> views;
  std::size_t named = 0;  ///< models and segmentations with a file, whether or not it is there
  std::vector<ImportWarning> warnings;
};

/// Holds what a scene says of the coordinates in the file of one of its models.
struct SlicerFileFrame {
  std::filesystem::path file;  ///< below the scene's folder, as it stands there; need not exist
  Frame frame = Frame::ras;    ///< as in SlicerModel
  std::string frameReason;
  std::optional<glm::dmat4> toWorld;
};

/// Returns what the scene says of the files of its models, for who reads these without it.
Result<std::vector<SlicerFileFrame>> fileFramesOfSlicer(const std::filesystem::path& scene,
                                                        const ReadLimits& limits);

/// Reads the scene. Broken XML or a file that is no scene is an error; models with a file that is
/// absent, lies outside the scene's folder or hangs on a cycle of references are left out or
/// untransformed, with a warning.
Result<SlicerScene> readSlicerScene(const std::filesystem::path& file, const ReadLimits& limits);

}  // namespace sline::model
