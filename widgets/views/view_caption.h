// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "render/lettering/caption.h"
#include "render/lettering/link_places.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

/// Shows what a view says over the picture, set as pictures and films have it. The mouse goes
/// through it.
class ViewCaption : public QWidget {
  Q_OBJECT
 public:
  explicit ViewCaption(Viewport& viewport);

  /// Tells where in the picture the caption stands.
  enum class Place {
    foot,   ///< in the middle, above the letter of the side that is below
    corner  ///< at the left, above `clear`
  };
  /// Shows the marked-up text; one that says nothing hides it. `clear`: pixels at the picture's
  /// foot that something else takes.
  void say(const std::string& markup, Place place, int clear = 0);
  /// Places the caption anew, for a picture of another size.
  void place();
  /// Returns where links lie in what is shown, in the picture.
  std::vector<render::LinkPlace> links() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<render::Caption> made() const;

  Viewport& m_viewport;
  std::string m_markup;
  Place m_place = Place::foot;
  int m_clear = 0;
  std::optional<render::Caption> m_caption;
};

}  // namespace sline::widgets
