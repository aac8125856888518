// SPDX-License-Identifier: Apache-2.0
// Describes what can be set of a figure and of a panel, as fields.
#pragma once

#include <QCoreApplication>
#include <functional>
#include <vector>

#include "model/figure/figure.h"
#include "model/scene/scene.h"
#include "widgets/form/field.h"

namespace sline::widgets {

/// A field and how it is read from a figure and written into it.
struct FigureField {
  Field field;  ///< its id is "figure" or "panel" and the key of the figure's file: "figurePen"
  std::function<QVariant(const model::Figure&)> read;
  std::function<void(model::Figure&, const QVariant&)> write;
};

class FigureFields {
  Q_DECLARE_TR_FUNCTIONS(sline::widgets::FigureFields)
 public:
  /// Returns the fields of the page.
  static std::vector<FigureField> ofPage();
  /// Returns the fields of a panel that shows the scene, which may be null.
  static std::vector<FigureField> ofPanel(const model::Figure& figure, std::size_t index,
                                          const model::Scene* scene);
  /// Returns what a list calls the panel: "a  Front".
  static QString nameOf(const model::Figure& figure, std::size_t index);
  /// Returns what the side of the body, or a saved view, is called.
  static QString viewName(const std::string& view);

 private:
  /// Returns the fields with what is said of each under the mouse.
  static std::vector<FigureField> told(std::vector<FigureField> fields);
  static std::vector<FigureField> ofSize();
  static std::vector<FigureField> ofInset(std::size_t index);
  static std::vector<FigureField> ofCamera(const model::Figure& figure, std::size_t index);
};

}  // namespace sline::widgets
