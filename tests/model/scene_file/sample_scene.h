// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/scene_file/scene_file.h"

namespace sline::test {

/// Every field that can be stored differs from its default somewhere.
model::Scene sampleScene();

/// The first difference, meshes compared bit by bit and not, as `Scene` does, by whether they are
/// the same object; empty where there is none.
std::string difference(const model::Scene& a, const model::Scene& b);

/// The file's bytes with one member's text changed, or with one more member.
std::string withMember(const std::string& file, const std::string& name, const std::string& bytes);
/// One member of the file; empty where there is none.
std::string memberOf(const std::string& file, const std::string& name);

}  // namespace sline::test
