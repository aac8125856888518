// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan.h"

namespace sline::model {

Result<ImportPlan> planImport(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, const ImportProgress& progress) {
  ImportOptions quick = options;
  quick.smoothing.mode = Smoothing::Mode::off;
  quick.decimateMm = 0.0f;
  Result<Imported> imported = importInputs(inputs, quick, progress);
  if (!imported.ok())
    return imported.error();
  return ImportPlan{.inputs = {inputs.begin(), inputs.end()},
                    .options = options,
                    .scene = std::move(imported->scene),
                    .report = std::move(imported->report)};
}

Result<Imported> carriedOut(const ImportPlan& plan, const ImportProgress& progress) {
  return importInputs(plan.inputs, plan.options, progress);
}

}  // namespace sline::model
