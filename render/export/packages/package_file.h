// SPDX-License-Identifier: Apache-2.0
// Writes files that learning systems take.
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Writes questions with pictures (`pictureQuestions`) as one XML file for Moodle.
Status writeMoodle(const ExportOrder& order, const std::filesystem::path& target,
                   const ExportProgress& progress);
/// Writes them as a content package of QTI 2.1.
Status writeQti(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);
/// Writes them as content for H5P.
Status writeH5p(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);

/// Writes the students' page as a package that tells its answers by that standard.
Status writeScorm12(const ExportOrder& order, const std::filesystem::path& target,
                    const ExportProgress& progress);
Status writeScorm2004(const ExportOrder& order, const std::filesystem::path& target,
                      const ExportProgress& progress);
Status writeCmi5(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress);

}  // namespace sline::render
