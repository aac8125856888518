// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/label_sights.h"

#include "widgets/text/tr.h"

namespace sline::widgets {

QString sightText(LabelSight sight, const model::Annotation& annotation) {
  switch (sight) {
    case LabelSight::hidden:
      return annotation.found
                 ? tr("Nowhere to be seen in this picture: its leader is dashed.")
                 : tr("The place set by hand is hidden in this picture: its leader is dashed.");
    case LabelSight::withoutRoom:
      return tr("Not in this picture: there is no room for it.");
    case LabelSight::offPicture:
      return tr("Not in this picture: its place is beyond the edge.");
    case LabelSight::notDrawn:
      return tr("Not in this picture: nothing is drawn at its place.");
  }
  return {};
}

}  // namespace sline::widgets
