# SPDX-License-Identifier: Apache-2.0
# Writes the .glsl files into one C++ file, so that programs carry their shaders with them:
#   cmake -DOUTPUT=file.cpp -DFILES=a.glsl,b.glsl -P embed_shaders.cmake
string(REPLACE "," ";" FILES "${FILES}")
set(entries "")
foreach(file IN LISTS FILES)
  get_filename_component(name "${file}" NAME)
  file(READ "${file}" text)
  string(APPEND entries "    {\"${name}\", R\"GLSL(${text})GLSL\"},\n")
endforeach()
file(WRITE "${OUTPUT}"
"// Made by embed_shaders.cmake from the .glsl files.
#include \"render/passes/shader_files.h\"

#include <array>

namespace sline::render::passes {

std::span<const gpu::ShaderFile> shaderFiles() {
  static constexpr auto files = std::to_array<gpu::ShaderFile>({
${entries}  });
  return files;
}

}  // namespace sline::render::passes
")
