// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/presentation_keys.h"

#include <algorithm>
#include <array>

namespace sline::widgets {

namespace {

struct KeyRow {
  Qt::Key key;
  PresentationWish wish;
  Qt::KeyboardModifiers with = Qt::NoModifier;
};

constexpr std::array presentationKeys{KeyRow{Qt::Key_Right, PresentationWish::next},
                                      KeyRow{Qt::Key_Down, PresentationWish::next},
                                      KeyRow{Qt::Key_Space, PresentationWish::next},
                                      KeyRow{Qt::Key_PageDown, PresentationWish::next},
                                      KeyRow{Qt::Key_N, PresentationWish::next},
                                      KeyRow{Qt::Key_Left, PresentationWish::back},
                                      KeyRow{Qt::Key_Up, PresentationWish::back},
                                      KeyRow{Qt::Key_Backspace, PresentationWish::back},
                                      KeyRow{Qt::Key_PageUp, PresentationWish::back},
                                      KeyRow{Qt::Key_P, PresentationWish::back},
                                      KeyRow{Qt::Key_Home, PresentationWish::first},
                                      KeyRow{Qt::Key_End, PresentationWish::last},
                                      KeyRow{Qt::Key_Return, PresentationWish::enter},
                                      KeyRow{Qt::Key_Enter, PresentationWish::enter},
                                      KeyRow{Qt::Key_B, PresentationWish::black},
                                      KeyRow{Qt::Key_Period, PresentationWish::black},
                                      KeyRow{Qt::Key_W, PresentationWish::white},
                                      KeyRow{Qt::Key_Comma, PresentationWish::white},
                                      KeyRow{Qt::Key_L, PresentationWish::laser},
                                      KeyRow{Qt::Key_D, PresentationWish::pen},
                                      KeyRow{Qt::Key_P, PresentationWish::pen, Qt::ControlModifier},
                                      KeyRow{Qt::Key_E, PresentationWish::wipe},
                                      KeyRow{Qt::Key_S, PresentationWish::notes},
                                      KeyRow{Qt::Key_R, PresentationWish::reveal},
                                      KeyRow{Qt::Key_Q, PresentationWish::quiz},
                                      KeyRow{Qt::Key_Escape, PresentationWish::end}};

Qt::KeyboardModifiers modifiersOf(QKeyCombination key) {
  return key.keyboardModifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier);
}

}  // namespace

std::optional<PresentationWish> wishOf(QKeyCombination key) {
  const auto found = std::find_if(
      presentationKeys.begin(), presentationKeys.end(),
      [key](const KeyRow& row) { return row.key == key.key() && row.with == modifiersOf(key); });
  return found == presentationKeys.end() ? std::nullopt : std::optional(found->wish);
}

std::optional<int> digitOf(QKeyCombination key) {
  const int digit = int(key.key()) - int(Qt::Key_0);
  return digit >= 0 && digit <= 9 && modifiersOf(key) == Qt::NoModifier ? std::optional(digit)
                                                                        : std::nullopt;
}

}  // namespace sline::widgets
