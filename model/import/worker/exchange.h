// SPDX-License-Identifier: Apache-2.0
// Encodes the exchange between the program and its reading child as bytes: a request there, an
// answer back. The child may have been taken over by the file it read, so an answer is not trusted.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// Describes the task of the child. `goesOn` does not travel: a caller that gives up ends the
/// child.
struct ReadRequest {
  std::string kind;                          ///< FileKind::name
  std::vector<std::filesystem::path> files;  ///< the files that are read together
  ReadLimits limits;
  Smoothing smoothing;
  std::vector<Threshold> thresholds;
  bool keepScans = false;
};

std::string encodedRequest(const ReadRequest& request);
/// Decodes a request; the error says that the bytes are no request.
Result<ReadRequest> decodedRequest(std::string_view bytes);

/// Encodes an answer. Surfaces must not be parts of molecules (RawMesh::molecule), which are read
/// elsewhere.
std::string encodedAnswer(const Result<RawMeshes>& answer);
/// Decodes an answer, errors included. It is an error of its own where the bytes are no answer,
/// indices are out of range or coordinates are not finite.
Result<RawMeshes> decodedAnswer(std::string_view bytes);

}  // namespace sline::model
