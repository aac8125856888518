// SPDX-License-Identifier: Apache-2.0
// What a surface of the cerebral cortex is called, from the way programs call its file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sline::model {

/// "left pial surface" of "lh.pial", of "sub-01_hemi-L_pial.surf.gii" and of
/// "100307.L.pial.32k_fs_LR.surf.gii"; empty where the file's name does not say both. `more` are
/// words that the file says of itself ("CortexLeft Pial") and count like those of its name.
std::string corticalName(const std::filesystem::path& file, std::string_view more = {});

/// False where the name says that the surface was blown up, cut open or made a sphere.
bool isCalledAnatomical(const std::filesystem::path& file);

}  // namespace sline::model
