// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/stages.h"

#include <QLocale>

#include "widgets/text/tr.h"

namespace sline::widgets {

std::vector<Stage> gammaStages() {
  return {{0.0f, tr("Silhouette"), tr("The outer edge alone")},
          {1.0f, tr("Contours"), tr("Every edge that faces away")},
          {2.0f, tr("Suggestive contours"), tr("Lines along folds as well")},
          {3.0f, tr("Hatching"), tr("Tone by strokes")},
          {4.0f, tr("Shading"), tr("Colour behind lines and strokes")},
          {5.0f, tr("Surface"), tr("The shaded surface alone")}};
}

QString gammaText(Gamma gamma) {
  return QLocale().toString(double(gamma.value()), 'f', 2);
}

}  // namespace sline::widgets
