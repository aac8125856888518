// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/shader_source.h"

#include <algorithm>

namespace sline::render::gpu {

namespace {

constexpr std::string_view desktopHeader = "#version 330 core\n";
constexpr std::string_view esHeader =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n"
    "precision highp sampler2D;\n"
    "precision highp isampler2D;\n";
constexpr std::string_view includeWord = "#include \"";

class Resolver {
 public:
  Resolver(std::span<const ShaderFile> files, ShaderSource& source)
      : m_files(files), m_source(source) {}

  Status append(std::string_view name, std::string_view asker) {
    if (std::find(m_source.files.begin(), m_source.files.end(), name) != m_source.files.end())
      return Unit{};
    const auto file = std::find_if(m_files.begin(), m_files.end(),
                                   [&](const ShaderFile& f) { return f.name == name; });
    if (file == m_files.end())
      return Error{.file = std::string(asker),
                   .reason = "the shader file \"" + std::string(name) + "\" is not built in",
                   .remedy = "Add it to the list of .glsl files"};
    const std::string number = std::to_string(m_source.files.size());
    m_source.files.emplace_back(name);
    m_source.text += "#line 1 " + number + "\n";
    return appendLines(*file, number);
  }

 private:
  Status appendLines(const ShaderFile& file, const std::string& number) {
    std::string_view rest = file.text;
    for (int line = 1; !rest.empty(); ++line) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      const std::string_view text = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (!text.starts_with(includeWord)) {
        (m_source.text += text) += '\n';
        continue;
      }
      const std::string_view quoted = text.substr(includeWord.size());
      TRY(append(quoted.substr(0, quoted.find('"')), file.name));
      m_source.text += "#line " + std::to_string(line + 1) + " " + number + "\n";
    }
    return Unit{};
  }

  std::span<const ShaderFile> m_files;
  ShaderSource& m_source;
};

}  // namespace

Result<ShaderSource> shaderSource(std::span<const ShaderFile> files, std::string_view name,
                                  Dialect dialect) {
  ShaderSource source;
  source.text = dialect == Dialect::es300 ? esHeader : desktopHeader;
  TRY(Resolver(files, source).append(name, name));
  return source;
}

}  // namespace sline::render::gpu
