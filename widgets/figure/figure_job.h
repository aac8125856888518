// SPDX-License-Identifier: Apache-2.0
// Draws and writes a figure on a thread of its own, with progress and cancel.
#pragma once

#include <filesystem>
#include <memory>

#include "render/export/figure/figure_page.h"
#include "widgets/session/background_job.h"

namespace sline::widgets {

/// All that a figure's page is made of.
struct FigureWork {
  model::Figure figure;
  render::FigureScenes scenes;
  render::ExportOrder options;  ///< `figureOptions`
  /// What was drawn before; panels that it shows the same are taken from there. May be null.
  std::shared_ptr<const render::ComposedFigure> before;
};

/// Plans and draws the figure.
Result<render::ComposedFigure> composed(const FigureWork& work,
                                        const render::ExportProgress& progress);

class FigureJob : public BackgroundJob {
  Q_OBJECT
 public:
  /// Writes the figure, unless it has what cannot be printed; a file that was there before stays
  /// where the job fails or is cancelled.
  FigureJob(FigureWork work, std::filesystem::path target, QObject* parent = nullptr);
  ~FigureJob() override { end(); }
  const std::filesystem::path& target() const { return m_target; }

 private:
  Status write(const Progress& progress) const;

  const FigureWork m_work;
  const std::filesystem::path m_target;
};

}  // namespace sline::widgets
