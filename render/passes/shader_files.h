// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "render/gpu/shader_source.h"

namespace sline::render::passes {

/// Returns every .glsl file of the passes and the common snippets of resources/shaders.
std::span<const gpu::ShaderFile> shaderFiles();

}  // namespace sline::render::passes
