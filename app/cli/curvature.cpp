// SPDX-License-Identifier: Apache-2.0
// Implements `sline curvature`: writes principal curvatures and their derivatives at each vertex as
// CSV.
#include "model/geometry/curvature.h"
#include "model/disk/whole_file.h"

#include <array>
#include <charconv>
#include <glm/geometric.hpp>

#include "app/cli/commands/command.h"
#include "app/cli/files/targets.h"
#include "model/geometry/normals.h"

namespace sline::cli {

namespace {

struct CurvatureFlags {
  InputFlags input;
  std::string output;
};

constexpr std::string_view header =
    "x,y,z,nx,ny,nz,k1,k2,e1x,e1y,e1z,e2x,e2y,e2z,dcurv0,dcurv1,dcurv2,dcurv3\n";

/// Appends one number with 9 digits, which restore a float exactly, and with a point in every
/// locale.
void appendNumber(std::string& text, float value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, 9)
                       .ptr;
  if (!text.empty() && text.back() != '\n')
    text += ',';
  text.append(digits.data(), end);
}

void appendPoint(std::string& text, const glm::vec3& p) {
  for (int i = 0; i < 3; ++i)
    appendNumber(text, p[i]);
}

void appendMesh(std::string& text, const model::Mesh& mesh) {
  const std::vector<glm::vec3> normals = model::vertexNormals(mesh);
  const model::Curvature curvature = model::curvature(mesh, normals);
  text.reserve(text.size() + mesh.vertexCount() * 200);
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
    appendPoint(text, mesh.positions()[i]);
    appendPoint(text, normals[i]);
    appendNumber(text, curvature.k[i].x);
    appendNumber(text, curvature.k[i].y);
    appendPoint(text, curvature.e1[i]);
    appendPoint(text, glm::cross(normals[i], curvature.e1[i]));
    for (int c = 0; c < 4; ++c)
      appendNumber(text, curvature.derivative[i][c]);
    text += '\n';
  }
}

Exit runCurvature(const CurvatureFlags& flags) {
  InputFlags input = flags.input;
  if (input.smooth.empty())
    input.smooth = "off";
  const Result<model::ImportOptions> options = importOptions(input);
  if (!options.ok())
    return complain(options.error(), Exit::wrongUse);
  const Target table{.flag = "--output", .name = flags.output, .endings = {"csv"}};
  if (const Status fine = checkTargets({&table, 1}, flags.input.inputs); !fine.ok())
    return complain(fine.error(), Exit::wrongUse);
  Progress progress;
  const Result<model::Imported> imported = readInputs(input, *options, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  std::string text(header);
  for (const model::Node& node : imported->scene.nodes())
    if (!node.isGroup())
      appendMesh(text, *node.mesh);
  const Status written = model::writeText(flags.output, text);
  return written.ok() ? Exit::done : complain(written.error(), Exit::failed);
}

void declareCurvature(CLI::App& command, CurvatureFlags& flags) {
  command.add_option("MESH", flags.input.inputs, inputHelp)->required()->expected(1);
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  command.add_option("-o,--output", flags.output, "Where to write the table")
      ->required()
      ->type_name("FILE.csv");
  command.add_option("--smooth", flags.input.smooth, smoothHelp)
      ->type_name("auto|off|N")
      ->default_str("off");
  addFrame(command, flags.input);
  addTogether(command, flags.input);
  addThreshold(command, flags.input);
  command.footer(
      "One row per vertex, in the file's order where nothing had to be repaired: position (mm),\n"
      "unit normal, principal curvatures k1 and k2 (1/mm, positive where convex, |k1| ≥ |k2|),\n"
      "their unit directions e1 and e2, and the derivative of curvature along them (1/mm²):\n"
      "C(e1,e1,e1), C(e1,e1,e2), C(e1,e2,e2), C(e2,e2,e2).");
}

}  // namespace

void addCurvature(CLI::App& program, Exit& exit) {
  addCommand<CurvatureFlags>(program, exit,
                             {"curvature", "Write the curvature of each vertex as CSV"},
                             declareCurvature, runCurvature);
}

}  // namespace sline::cli
