// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/technique_texts.h"

#include <QCoreApplication>  // QT_TRANSLATE_NOOP

#include "render/lines/techniques/technique_list.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

/// Lists what the list of techniques says, so that it is translated.
[[maybe_unused]] constexpr const char* said[] = {
    QT_TRANSLATE_NOOP("sline::widgets", "Suggestive contours"),
    QT_TRANSLATE_NOOP("sline::widgets", "ConFIS"),
    QT_TRANSLATE_NOOP("sline::widgets", "Apparent ridges"),
    QT_TRANSLATE_NOOP("sline::widgets", "Ridges and valleys"),
    QT_TRANSLATE_NOOP("sline::widgets", "Photic extremum lines"),
    QT_TRANSLATE_NOOP("sline::widgets", "Laplacian lines"),
    QT_TRANSLATE_NOOP("sline::widgets", "Demarcating curves"),
    QT_TRANSLATE_NOOP("sline::widgets", "Highlight lines"),
    QT_TRANSLATE_NOOP("sline::widgets", "Streamline hatching"),
    QT_TRANSLATE_NOOP("sline::widgets", "Noise LIC"),
    QT_TRANSLATE_NOOP("sline::widgets", "Dκr·F² must be above"),
    QT_TRANSLATE_NOOP("sline::widgets", "acos(nv) must be above, radians"),
    QT_TRANSLATE_NOOP("sline::widgets", "T/F_c, the thickness of the contour's margin"),
    QT_TRANSLATE_NOOP("sline::widgets", "|H|·F_c must be above where H has an extremum"),
    QT_TRANSLATE_NOOP("sline::widgets",
                      "the least distance between lines, 1/720 of the picture's height"),
    QT_TRANSLATE_NOOP("sline::widgets", "q1·F must be above"),
    QT_TRANSLATE_NOOP("sline::widgets", "|κ1|·F must be above"),
    QT_TRANSLATE_NOOP("sline::widgets", "|κ1''|/|κ1|³ across the line must be above"),
    QT_TRANSLATE_NOOP("sline::widgets", "|∇f|·F must be above"),
    QT_TRANSLATE_NOOP("sline::widgets", "C(g,g,g)·F² must be above"),
    QT_TRANSLATE_NOOP("sline::widgets", "−Dκr·F² must be above"),
    QT_TRANSLATE_NOOP("sline::widgets", "κ1²·F² must be above"),
    QT_TRANSLATE_NOOP("sline::widgets",
                      "the distance between lines in full shade, 1/720 of the picture's height"),
    QT_TRANSLATE_NOOP("sline::widgets", "the shade must be above, 0 in the light to 1")};

}  // namespace

QString linesName(model::Technique technique) {
  return tr(render::factsOf(technique).name);
}

QString thresholdMeaning(const char* meaning) {
  return tr(meaning);
}

}  // namespace sline::widgets
