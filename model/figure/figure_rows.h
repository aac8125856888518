// SPDX-License-Identifier: Apache-2.0
// Binds keys of a figure's file to the fields that they stand for.
#pragma once

#include <span>

#include "model/figure/figure.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

using FigureJson = nlohmann::ordered_json;

/// Binds a key to a part of an object. `write` returns null where the part is as usual.
template <class Owner>
struct FigureRow {
  const char* id = "";
  const char* value = "";
  const char* help = "";
  void (*read)(const JsonValue& value, Owner& owner) = nullptr;
  FigureJson (*write)(const Owner& owner) = nullptr;
};

std::span<const FigureRow<Figure>> figureRows();
std::span<const FigureRow<FigurePanel>> panelRows();
std::span<const FigureRow<PanelCamera>> cameraRows();
std::span<const FigureRow<PanelInset>> insetRows();

/// Reads an object by its rows. A key that none has is a fault that names those near it.
template <class Owner>
void readByRows(const JsonValue& value, std::span<const FigureRow<Owner>> rows, Owner& owner);
/// Returns the object with the keys whose parts are not as usual.
template <class Owner>
FigureJson writtenByRows(std::span<const FigureRow<Owner>> rows, const Owner& owner) {
  FigureJson object = FigureJson::object();
  for (const FigureRow<Owner>& row : rows)
    if (FigureJson value = row.write(owner); !value.is_null())
      object[row.id] = std::move(value);
  return object;
}

}  // namespace sline::model
