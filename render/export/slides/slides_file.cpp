// SPDX-License-Identifier: Apache-2.0
#include "render/export/slides/slides_file.h"

#include "model/disk/whole_file.h"
#include "render/export/slides/slide_package.h"

namespace sline::render {

Status writeSlides(const ExportOrder& order, const std::filesystem::path& target,
                   const ExportProgress& progress) {
  const auto named = [&target](Error error) {
    error.file = target.string();
    return error;
  };
  const Result<SlideDeck> deck = slideDeck(order, progress);
  if (!deck.ok())
    return named(deck.error());
  if (progress && !progress(0.95, "writing the slides"))
    return givenUp(target);
  const Result<std::string> bytes = slidePackage(*deck);
  return bytes.ok() ? model::writeText(target, *bytes) : Status(named(bytes.error()));
}

}  // namespace sline::render
