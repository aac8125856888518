// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "render/gpu/shader_source.h"
#include "render/gpu/texture.h"

namespace sline::render::gpu {

enum class UniformType { real, vec2, vec3, vec4, mat4, integer, ivec2, ivec4, texture, intTexture };

struct Uniform {
  std::string_view name;
  UniformType type = UniformType::real;
  /// Nothing that is drawn depends on it, as other programs share its shader: some drivers leave it
  /// out, others do not.
  bool idle = false;
};

/// Describes a program completely; a pass declares its uniforms here and nowhere else.
struct ProgramRecipe {
  std::string_view name;
  std::string_view vertexFile;
  std::string_view fragmentFile;
  std::vector<Uniform> uniforms;
};

/// A program is a linked pair of shaders that has exactly the declared uniforms.
class Program {
 public:
  /// Creates the program. The error carries the compiler's or linker's words, or names the uniform
  /// that the shaders lack, have in addition, or have in another type.
  static Result<std::unique_ptr<Program>> create(std::span<const ShaderFile> files, Dialect dialect,
                                                 const ProgramRecipe& recipe);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Sets a uniform that was declared with that type; one that was not is a fault of the program's
  /// own, and nothing is set then.
  void set(std::string_view name, float value) const;
  void set(std::string_view name, const glm::vec2& value) const;
  void set(std::string_view name, const glm::vec3& value) const;
  void set(std::string_view name, const glm::vec4& value) const;
  /// Sets the first elements of an array, which is declared as "name[0]".
  void set(std::string_view name, std::span<const glm::vec4> values) const;
  void set(std::string_view name, const glm::mat4& value) const;
  void set(std::string_view name, int value) const;
  void set(std::string_view name, const glm::ivec2& value) const;
  void set(std::string_view name, const glm::ivec4& value) const;
  void set(std::string_view name, const Texture& texture) const;

  std::uint32_t handle() const { return m_handle; }

 private:
  struct Slot {
    std::string name;
    UniformType type;
    int location;
    int unit;  ///< textures only
  };
  Program() = default;
  Status compile(const ShaderSource& source, bool vertex);
  Status link(std::string_view name);
  Status matchUniforms(const ProgramRecipe& recipe);
  const Slot& slot(std::string_view name, UniformType type) const;

  std::uint32_t m_handle = 0;
  std::vector<Slot> m_slots;
};

}  // namespace sline::render::gpu
