// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/known_lines.h"

#include <array>
#include <cstdio>

#include "render/export/comparison/noisy_mesh.h"
#include "render/lines/techniques/line_technique.h"
#include "tests/support/found_lines.h"

namespace sline::bench {

namespace {

constexpr int cells = 186;

std::string rowOf(const char* id, const test::Agreement& agreement) {
  std::array<char, 120> row{};
  std::snprintf(row.data(), row.size(), "%-22s %8.3f %10.3f %10.0f %10.0f\n", id, agreement.recall,
                agreement.precision, agreement.knownMm, agreement.drawnMm);
  return row.data();
}

}  // namespace

std::string measureKnownLines() {
  const test::KnownSheet sheet = test::scannedSheet();
  const model::MeshPtr clean = sheet.mesh(cells);
  std::string text;
  for (const float jitter : {0.0f, 0.05f, 0.1f}) {
    const model::MeshPtr mesh =
        jitter > 0.0f
            ? render::withNoise(*clean, {.kind = render::NoiseKind::jitter, .amount = jitter})
            : clean;
    const model::SurfacePtr surface = model::prepareSurface(mesh);
    std::array<char, 160> title{};
    std::snprintf(title.data(), title.size(),
                  "%zu triangles, jitter of %.2f mean edges, F %.2f mm, F_c %.2f mm\n"
                  "technique                recall  precision   known mm   drawn mm\n",
                  mesh->triangleCount(), double(jitter), double(surface->featureSize),
                  double(surface->filigreeSize));
    text += title.data();
    for (const render::LineTechnique& technique : render::lineTechniques())
      if (test::knownKindOf(technique.kind))
        text += rowOf(technique.id, test::agreementOn(sheet, cells, *surface, technique.kind));
    text += rowOf("confis", test::confisAgreementOn(sheet, cells, *surface));
  }
  return text;
}

}  // namespace sline::bench
