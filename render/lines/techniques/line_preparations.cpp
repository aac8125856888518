// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/line_preparations.h"

#include "render/lines/techniques/line_technique.h"

namespace sline::render {

std::shared_ptr<const PreparedLines> LinePreparations::of(LineKind kind,
                                                          const model::Surface& surface) {
  std::shared_ptr<const PreparedLines>& kept = m_kept[std::size_t(kind)];
  {
    const std::lock_guard lock(m_mutex);
    if (kept)
      return kept;
  }
  // A thread that waits within a parallel loop may come here again, so no lock is held meanwhile;
  // where two compute the same, the first counts.
  std::shared_ptr<const PreparedLines> made = techniqueOf(kind).prepare(surface);
  const std::lock_guard lock(m_mutex);
  if (!kept)
    kept = std::move(made);
  return kept;
}

void LinePreparations::make(LineKinds kinds, const model::Surface& surface) {
  for (const LineTechnique& technique : lineTechniques())
    if (technique.prepare && kinds.has(technique.kind))
      of(technique.kind, surface);
}

}  // namespace sline::render
