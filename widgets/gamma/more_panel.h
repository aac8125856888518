// SPDX-License-Identifier: Apache-2.0
// Holds controls that are rarely needed, folded away until the user opens them.
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/session/session.h"

class QSettings;
class QToolButton;

namespace sline::widgets {

class StyleEditor;

class MorePanel : public QWidget {
  Q_OBJECT
 public:
  /// Makes the panel; the settings remember whether it is open.
  MorePanel(Session& session, QSettings& settings, QWidget* parent = nullptr);
  void showSelection();
  bool isOpen() const { return m_open; }
  /// Enables the content; a disabled panel can still be opened.
  void setUsable(bool usable) { m_content->setEnabled(usable); }

 signals:
  void opened();
  void brushWanted();

 private:
  void unfold(bool open);

  QSettings& m_settings;
  QToolButton* m_fold;
  QWidget* m_content;
  bool m_open = false;
  std::vector<StyleEditor*> m_editors;
};

}  // namespace sline::widgets
