// SPDX-License-Identifier: Apache-2.0
// GLSL files are written once for OpenGL 3.3 and ES 3.0. They include common snippets by name with
//   #include "depth.glsl"
// which are put in their place here, once each; the version and precision lines are put on top.
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

/// Which of the two shading languages a context speaks.
enum class Dialect { desktop330, es300 };

struct ShaderSource {
  std::string text;                ///< ready for the compiler
  std::vector<std::string> files;  ///< names by the number that compiler messages start with
};

/// The file with its includes resolved. The error names a file that is absent and the one that
/// asked for it.
Result<ShaderSource> shaderSource(std::span<const ShaderFile> files, std::string_view name,
                                  Dialect dialect);

}  // namespace sline::render::gpu
