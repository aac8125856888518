// SPDX-License-Identifier: Apache-2.0
// Assembles GLSL files, which are written once for OpenGL 3.3 and ES 3.0. They include common
// snippets by name, as in `#include "depth.glsl"`. Each snippet is put in its place here, once; the
// version and precision lines are put on top.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"

namespace sline::render::gpu {

/// A .glsl file built into the program: its name without folders, and its text.
struct ShaderFile {
  std::string_view name;
  std::string_view text;
};

/// Tells which of the two shading languages a context speaks.
enum class Dialect { desktop330, es300 };

struct ShaderSource {
  std::string text;                ///< ready for the compiler
  std::vector<std::string> files;  ///< names, by the number that compiler messages start with
};

/// Returns the file with its includes resolved. The error names a file that is absent and the one
/// that includes it.
Result<ShaderSource> shaderSource(std::span<const ShaderFile> files, std::string_view name,
                                  Dialect dialect);

}  // namespace sline::render::gpu
