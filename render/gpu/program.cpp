// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/program.h"

#include <algorithm>
#include <cassert>
#include <glm/gtc/type_ptr.hpp>

#include "render/gpu/gl.h"

namespace sline::render::gpu {

namespace {

constexpr const char* remedy = "Report this as a bug, with the name of the graphics driver";

GLenum glType(UniformType type) {
  switch (type) {
    case UniformType::real:
      return GL_FLOAT;
    case UniformType::vec2:
      return GL_FLOAT_VEC2;
    case UniformType::vec3:
      return GL_FLOAT_VEC3;
    case UniformType::vec4:
      return GL_FLOAT_VEC4;
    case UniformType::mat4:
      return GL_FLOAT_MAT4;
    case UniformType::integer:
      return GL_INT;
    case UniformType::ivec2:
      return GL_INT_VEC2;
    case UniformType::ivec4:
      return GL_INT_VEC4;
    case UniformType::texture:
      return GL_SAMPLER_2D;
    case UniformType::intTexture:
      return GL_INT_SAMPLER_2D;
  }
  return GL_NONE;
}

bool isTexture(UniformType type) {
  return type == UniformType::texture || type == UniformType::intTexture;
}

}  // namespace

Result<std::unique_ptr<Program>> Program::create(std::span<const ShaderFile> files, Dialect dialect,
                                                 const ProgramRecipe& recipe) {
  std::unique_ptr<Program> program(new Program);
  program->m_handle = glCreateProgram();
  nameObject(programKind, program->m_handle, recipe.name);
  for (const bool vertex : {true, false}) {
    ShaderSource source =
        TRY(shaderSource(files, vertex ? recipe.vertexFile : recipe.fragmentFile, dialect));
    TRY(program->compile(source, vertex));
  }
  TRY(program->link(recipe.name));
  TRY(program->matchUniforms(recipe));
  return program;
}

Program::~Program() {
  if (m_handle != 0)
    glDeleteProgram(m_handle);
}

Status Program::compile(const ShaderSource& source, bool vertex) {
  const GLuint shader = glCreateShader(vertex ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
  const char* text = source.text.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  glAttachShader(m_handle, shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 1)), '\0');
  if (!ok)
    glGetShaderInfoLog(shader, length, &length, log.data());
  glDeleteShader(shader);  // lives on while attached; browsers forget its number at once
  if (ok)
    return Unit{};
  log.resize(std::size_t(std::max(length, 0)));
  std::string numbers;
  for (std::size_t i = 0; i < source.files.size(); ++i)
    numbers += (i == 0 ? "" : ", ") + std::to_string(i) + " is " + source.files[i];
  return Error{.file = source.files.front(),
               .reason = "the shader does not compile: " + log + " (file " + numbers + ")",
               .remedy = remedy};
}

Status Program::link(std::string_view name) {
  glLinkProgram(m_handle);
  GLint ok = 0;
  glGetProgramiv(m_handle, GL_LINK_STATUS, &ok);
  if (ok)
    return Unit{};
  GLint length = 0;
  glGetProgramiv(m_handle, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 1)), '\0');
  glGetProgramInfoLog(m_handle, length, &length, log.data());
  log.resize(std::size_t(std::max(length, 0)));
  return Error{
      .file = std::string(name), .reason = "the shaders do not link: " + log, .remedy = remedy};
}

Status Program::matchUniforms(const ProgramRecipe& recipe) {
  const auto fault = [&](std::string_view uniform, const char* what) {
    return Error{.file = std::string(recipe.name),
                 .where = "uniform " + std::string(uniform),
                 .reason = what,
                 .remedy = remedy};
  };
  GLint count = 0;
  glGetProgramiv(m_handle, GL_ACTIVE_UNIFORMS, &count);
  for (GLuint i = 0; i < GLuint(count); ++i) {
    char buffer[256];
    GLsizei length = 0;
    GLint elements = 0;
    GLenum type = GL_NONE;
    glGetActiveUniform(m_handle, i, sizeof(buffer), &length, &elements, &type, buffer);
    const std::string_view name(buffer, std::size_t(length));
    const auto declared = std::find_if(recipe.uniforms.begin(), recipe.uniforms.end(),
                                       [&](const Uniform& u) { return u.name == name; });
    if (declared == recipe.uniforms.end())
      return fault(name, "the shaders use it, but the pass does not declare it");
    if (glType(declared->type) != type)
      return fault(name, "the shaders and the pass give it different types");
  }
  int unit = 0;
  glUseProgram(m_handle);
  for (const Uniform& uniform : recipe.uniforms) {
    const std::string name(uniform.name);
    const int location = glGetUniformLocation(m_handle, name.c_str());
    if (location < 0 && !uniform.idle)
      return fault(uniform.name, "the pass declares it, but the shaders do not use it");
    m_slots.push_back({name, uniform.type, location, isTexture(uniform.type) ? unit : 0});
    if (isTexture(uniform.type))
      glUniform1i(location, unit++);
  }
  return Unit{};
}

const Program::Slot& Program::slot(std::string_view name, UniformType type) const {
  static const Slot nowhere{.name = {}, .type = UniformType::real, .location = -1, .unit = 0};
  const auto found = std::find_if(m_slots.begin(), m_slots.end(),
                                  [&](const Slot& s) { return s.name == name && s.type == type; });
  assert(found != m_slots.end());
  glUseProgram(m_handle);
  return found == m_slots.end() ? nowhere : *found;
}

void Program::set(std::string_view name, float value) const {
  glUniform1f(slot(name, UniformType::real).location, value);
}

void Program::set(std::string_view name, const glm::vec2& value) const {
  glUniform2fv(slot(name, UniformType::vec2).location, 1, glm::value_ptr(value));
}

void Program::set(std::string_view name, const glm::vec3& value) const {
  glUniform3fv(slot(name, UniformType::vec3).location, 1, glm::value_ptr(value));
}

void Program::set(std::string_view name, const glm::vec4& value) const {
  glUniform4fv(slot(name, UniformType::vec4).location, 1, glm::value_ptr(value));
}

void Program::set(std::string_view name, std::span<const glm::vec4> values) const {
  const int location = slot(name, UniformType::vec4).location;
  if (!values.empty())
    glUniform4fv(location, GLsizei(values.size()), glm::value_ptr(values.front()));
}

void Program::set(std::string_view name, const glm::mat4& value) const {
  glUniformMatrix4fv(slot(name, UniformType::mat4).location, 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(std::string_view name, int value) const {
  glUniform1i(slot(name, UniformType::integer).location, value);
}

void Program::set(std::string_view name, const glm::ivec2& value) const {
  glUniform2i(slot(name, UniformType::ivec2).location, value.x, value.y);
}

void Program::set(std::string_view name, const glm::ivec4& value) const {
  glUniform4i(slot(name, UniformType::ivec4).location, value.x, value.y, value.z, value.w);
}

void Program::set(std::string_view name, const Texture& texture) const {
  const bool integers =
      texture.format() == TextureFormat::rgba32i || texture.format() == TextureFormat::r32i;
  const Slot& found = slot(name, integers ? UniformType::intTexture : UniformType::texture);
  glActiveTexture(GLenum(GL_TEXTURE0 + found.unit));
  glBindTexture(GL_TEXTURE_2D, texture.handle());
}

}  // namespace sline::render::gpu
