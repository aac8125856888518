// SPDX-License-Identifier: Apache-2.0
// What the program and its reading child say to each other, as bytes: a request there, an answer
// back. The child may have been taken over by the file it read, so an answer is not trusted.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// What the child is asked to do. `goesOn` does not travel: who gives up ends the child.
struct ReadRequest {
  std::string kind;                          ///< FileKind::name
  std::vector<std::filesystem::path> files;  ///< that are read together
  ReadLimits limits;
  Smoothing smoothing;
  std::vector<Threshold> thresholds;
  bool keepScans = false;
};

std::string encodedRequest(const ReadRequest& request);
/// The error says that the bytes are no request.
Result<ReadRequest> decodedRequest(std::string_view bytes);

/// Surfaces must not be parts of molecules (RawMesh::molecule), which are read elsewhere.
std::string encodedAnswer(const Result<RawMeshes>& answer);
/// The answer again, errors included. An error of its own where the bytes are no answer, indices
/// are out of range or coordinates are not finite.
Result<RawMeshes> decodedAnswer(std::string_view bytes);

}  // namespace sline::model
