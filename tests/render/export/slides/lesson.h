// SPDX-License-Identifier: Apache-2.0
// Makes scenes of labelled balls for slides.
#pragma once

#include "render/export/order/export_order.h"

namespace sline::test {

/// Adds a ball of that radius with a label, or an annotation of another kind, in millimetres.
model::AnnotationId addBall(model::Scene& scene, const glm::vec3& at, float radius,
                            const std::string& label,
                            model::AnnotationKind kind = model::AnnotationKind::label);

/// Makes the camera see the whole scene from in front.
void fitCamera(render::ExportOrder& order);

/// Returns an order of those labels, on balls in a row or in several, seen from in front.
render::ExportOrder lessonOf(const std::vector<std::string>& labels);

/// Adds a saved view of what the order shows; its words are empty.
model::View& addView(render::ExportOrder& order, std::vector<model::View>& views,
                     const std::string& name);

/// Names that could break a file or a program: quotes, markup, other scripts, controls, length.
const std::vector<std::string>& oddNames();

/// Returns the order of a deck that numbers distinguish: of odd names and views, of each option.
render::ExportOrder oddLesson(int number);

}  // namespace sline::test
