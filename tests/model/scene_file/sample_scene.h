// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/scene_file/scene_file.h"

namespace sline::test {

/// Returns a scene in which every field that can be stored differs from its default somewhere.
model::Scene sampleScene();

/// Returns the first difference, or an empty text if there is none. Meshes are compared bit by bit
/// and not, as `Scene` does, by whether they are the same object.
std::string difference(const model::Scene& a, const model::Scene& b);

/// Returns the file's bytes with one member's text changed, or with one more member.
std::string withMember(const std::string& file, const std::string& name, const std::string& bytes);
/// Returns one member of the file; empty if there is none.
std::string memberOf(const std::string& file, const std::string& name);

}  // namespace sline::test
