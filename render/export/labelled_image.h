// SPDX-License-Identifier: Apache-2.0
// Labels in a picture made of pixels; for programs without a window and without Qt's headers.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/export/order/label_style.h"
#include "render/picture/image.h"

namespace sline::render {

/// What setting text needs, made where the program has none. Hold one as long as text is set.
class Typesetting {
 public:
  static Result<std::unique_ptr<Typesetting>> create();
  ~Typesetting();
  Typesetting(const Typesetting&) = delete;
  Typesetting& operator=(const Typesetting&) = delete;

 private:
  struct Data;
  explicit Typesetting(std::unique_ptr<Data> data);
  std::unique_ptr<Data> m_data;
};

struct LabelledPicture {
  model::Scene scene;
  model::Camera camera;
  LabelStyle style;
  float heightMm = usualHeightMm;  ///< of the picture on paper
};

struct LabelReport {
  struct Line {
    int number = 0;
    std::string text;
  };
  std::vector<Line> key;             ///< of all labels in the picture, by number
  std::vector<std::string> leftOut;  ///< texts for which there was no room
};

/// Draws the scene's labels over the picture that was drawn of it.
LabelReport drawLabels(Image& image, const LabelledPicture& picture,
                       const Typesetting& typesetting);

/// The share of a picture's width that columns of labels leave to the anatomy, 0 … 1; `aspect` is
/// width / height.
float shareBesideLabels(const LabelledPicture& picture, float aspect,
                        const Typesetting& typesetting);

}  // namespace sline::render
