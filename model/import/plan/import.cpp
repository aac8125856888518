// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/import.h"

#include <utility>

#include "model/disk/process.h"
#include "model/import/plan/import_steps.h"

namespace sline::model {

namespace {

/// Reports progress of a part of the work as progress of the whole, between `from` and `to`.
ImportProgress portion(const ImportProgress& progress, float from, float to) {
  if (!progress)
    return {};
  return [&progress, from, to](float done, const std::string& what) {
    return progress(from + (to - from) * done, what);
  };
}

/// Returns the share of the whole that is done when the files are read.
float shareOfReading(const ImportOptions& options) {
  constexpr float each = 0.4f;  // share of reading: workPerTriangle times a file's triangles
  const bool smooths = options.smoothing.mode != Smoothing::Mode::off;
  const bool decimates = options.decimateMm > 0.0f;
  return 1.0f / (1.0f + each * (float(smooths) + float(decimates)));
}

}  // namespace

Result<Imported> importInputs(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, const ImportProgress& progress) {
  const float readBy = shareOfReading(options);
  ReadInputs read =
      TRY(readInputs(inputs, options, ScansWanted::asAsked, portion(progress, 0.0f, readBy)));
  // No other code needs the parts as they were read.
  DecidedParts decided = decideParts(std::move(read.parts), read, options);
  const ImportPlan plan = layOutTree(decided, read, options);
  const ImportProgress rest = portion(progress, readBy, 1.0f);
  ProgressMeter meter(rest, expectedWork(decided.parts, options));
  Result<Imported> imported = makeScene(plan, std::move(decided), read, meter);
  // The intermediate copies of hundreds of files are free now; the system may have them back.
  giveMemoryBack();
  return imported;
}

}  // namespace sline::model
