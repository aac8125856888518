// SPDX-License-Identifier: Apache-2.0
#include "widgets/figure/figure_job.h"

#include <utility>

#include "render/export/figure/figure_checks.h"

namespace sline::widgets {

Result<render::ComposedFigure> composed(const FigureWork& work,
                                        const render::ExportProgress& progress) {
  const render::FigurePlan plan = TRY(render::planFigure(work.figure, work.scenes, work.options));
  return render::composeFigure(plan, progress, work.before.get());
}

FigureJob::FigureJob(FigureWork work, std::filesystem::path target, QObject* parent)
    : BackgroundJob([this](const Progress& progress) { return write(progress); }, parent),
      m_work(std::move(work)),
      m_target(std::move(target)) {}

Status FigureJob::write(const Progress& progress) const {
  constexpr double drawing = 0.5;  // its share of the work, as far as one can tell
  return caught(
      [&]() -> Status {
        const render::ComposedFigure figure =
            TRY(composed(m_work, [&](double share, std::string_view what) {
              return progress(drawing * share, what);
            }));
        if (const std::vector<Error> faults = render::printFaults(figure); !faults.empty())
          return faults.front();
        return render::writeFigure(figure, m_work.options, m_target,
                                   [&](double share, std::string_view what) {
                                     return progress(drawing + (1.0 - drawing) * share, what);
                                   });
      },
      {.memory = "Take a smaller size, or close other programs",
       .library = "Export another kind of file"});
}

}  // namespace sline::widgets

#include "moc_figure_job.cpp"
