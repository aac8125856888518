// SPDX-License-Identifier: Apache-2.0
// Reads the tree of a .mrml scene: ModelHierarchy nodes (Slicer 3 and 4) or the SubjectHierarchy
// (4.9 and later). Private to the reader.
#pragma once

#include <string>
#include <unordered_map>

#include "model/import/slicer/mrml_scene.h"
#include "model/import/slicer/nodes.h"

namespace sline::model {

struct SlicerDocument {
  XmlNode scene;
  const SlicerNodes& nodes;
  std::filesystem::path file;
};

/// Appends the scene's groups (those with a model somewhere below) and returns the group of each
/// model by the model's id.
std::unordered_map<std::string, std::size_t> readSlicerHierarchy(const SlicerDocument& document,
                                                                 SlicerScene& result);

/// Returns colour, opacity and visibility of a ModelDisplay node; an empty node says nothing.
Style slicerStyle(const XmlNode& display);

/// Returns opacity and visibility of a SegmentationDisplay node; its segments have colours of their
/// own.
Style slicerSegmentsStyle(const XmlNode& display);

}  // namespace sline::model
