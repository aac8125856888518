// SPDX-License-Identifier: Apache-2.0
// A scene as bytes, for what the program keeps between two starts: exact, quick to read, of one
// version only. It is no format for people's work; who cannot read it makes the scene again.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Tree, ids, names, styles, meshes, provenance, sections and saved views, marked with `key`: what
/// was stored and by which version of its maker.
std::string storedScene(const Scene& scene, std::string_view key);

/// The scene again, equal in every bit. The bytes are not trusted: the error says what is wrong
/// with them, be it a foreign file, another key, a cut or a changed byte.
Result<Scene> sceneFromStore(std::string_view bytes, std::string_view key);

/// The same in a file, which appears whole or not at all; its folder is made where it is missing.
Status writeSceneStore(const std::filesystem::path& file, const Scene& scene, std::string_view key);
Result<Scene> readSceneStore(const std::filesystem::path& file, std::string_view key);

}  // namespace sline::model
