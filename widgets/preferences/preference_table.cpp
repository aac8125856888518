// SPDX-License-Identifier: Apache-2.0
#include "widgets/preferences/preferences.h"

#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

std::vector<PreferenceRow> appearanceRows() {
  const QString page = tr("Appearance");
  return {{{QStringLiteral("appearance/theme"), tr("Theme"),
            tr("Light or dark controls; the picture has a background of its own"),
            ChoiceField{{{QStringLiteral("system"), tr("As the system")},
                         {QStringLiteral("light"), tr("Light")},
                         {QStringLiteral("dark"), tr("Dark")}}}},
           page,
           QStringLiteral("system")},
          {{QStringLiteral("appearance/toolTexts"), tr("Text under the toolbar’s icons"),
            tr("What each button does in a word"), SwitchField{}},
           page,
           false}};
}

std::vector<PreferenceRow> languageRows() {
  const QString page = tr("Language");
  return {{{QStringLiteral("language/interface"), tr("Interface"),
            tr("The language of menus and texts; takes effect at once"),
            ChoiceField{{{QStringLiteral("system"), tr("As the system")},
                         // Each name is in its own language, so that its speakers find it.
                         {QStringLiteral("en"), QStringLiteral("English")},
                         {QStringLiteral("de"), QStringLiteral("Deutsch")},
                         {QStringLiteral("nl"), QStringLiteral("Nederlands")},
                         {QStringLiteral("nb"), QStringLiteral("Norsk bokmål")}}}},
           page,
           QStringLiteral("system")},
          {{QStringLiteral("language/structures"), tr("Structures"),
            tr("What known structures are called on screen; files keep their own names"),
            ChoiceField{{{QStringLiteral("file"), tr("As in the file")},
                         {QStringLiteral("interface"), tr("In the interface’s language")},
                         {QStringLiteral("latin"), tr("Latin")},
                         {QStringLiteral("en"), tr("English")},
                         {QStringLiteral("de"), tr("German")},
                         {QStringLiteral("nl"), tr("Dutch")},
                         {QStringLiteral("nb"), tr("Norwegian")}}}},
           page,
           QStringLiteral("interface")}};
}

std::vector<PreferenceRow> pictureRows() {
  const QString page = tr("Picture");
  return {
      {{QStringLiteral("picture/background"), tr("Background"),
        tr("What the picture is drawn on; on the dark one ink is light"),
        ChoiceField{{{QStringLiteral("white"), tr("White")},
                     {QStringLiteral("paper"), tr("Paper")},
                     {QStringLiteral("dark"), tr("Dark")}}}},
       page,
       QStringLiteral("paper")},
      {{QStringLiteral("picture/openingLook"), tr("Look of what is opened"),
        tr("Where a file says nothing of how it looks: a plate draws what it is about in detail "
           "and everything else as context, the other styles in their manner"),
        // The ids are those of model::drawingStyles, except for the first and the last.
        ChoiceField{{{QStringLiteral("auto"), tr("Plate")},
                     {QStringLiteral("even-pen"), tr("Even Pen")},
                     {QStringLiteral("textbook"), tr("Textbook")},
                     {QStringLiteral("woodcut"), tr("Woodcut")},
                     {QStringLiteral("pencil"), tr("Pencil")},
                     {QStringLiteral("operating-note"), tr("Operating Note")},
                     {QStringLiteral("lecture-hall"), tr("Lecture Hall")},
                     {QStringLiteral("plain"), tr("Plain")}}}},
       page,
       QStringLiteral("auto")},
      {{QStringLiteral("picture/cube"), tr("Orientation cube"),
        tr("The body's sides in the corner of the picture; a click looks from there"),
        SwitchField{}},
       page,
       true},
      {{QStringLiteral("picture/scaleBar"), tr("Scale bar"),
        tr("True at the depth of what the picture turns around"), SwitchField{}},
       page,
       true},
      {{QStringLiteral("picture/names"), tr("Names under the mouse"),
        tr("What a structure is called where the mouse rests"), SwitchField{}},
       page,
       true},
      {{QStringLiteral("picture/frameTime"), tr("Time that a picture takes"),
        tr("In milliseconds, in the corner of the picture"), SwitchField{}},
       page,
       false}};
}

std::vector<PreferenceRow> labelRows() {
  const QString page = tr("Labels");
  constexpr int smallest = 5;
  constexpr int largest = 36;
  return {{{QStringLiteral("labels/mode"), tr("Labels show"),
            tr("Numbers are for a key beside the picture, blank lines for a test"),
            ChoiceField{{{QStringLiteral("texts"), tr("Texts")},
                         {QStringLiteral("numbers"), tr("Numbers")},
                         {QStringLiteral("blank"), tr("Blank lines")},
                         {QStringLiteral("off"), tr("Nothing")}}}},
           page,
           QStringLiteral("texts")},
          {{QStringLiteral("labels/language"), tr("Language"),
            tr("What labels say, where they have words in that language; else the scene’s own"),
            ChoiceField{{{QStringLiteral("structures"), tr("As the structures")},
                         {QStringLiteral("scene"), tr("The scene’s own")},
                         {QStringLiteral("en"), tr("English")},
                         {QStringLiteral("de"), tr("German")},
                         {QStringLiteral("la"), tr("Latin")},
                         {QStringLiteral("nl"), tr("Dutch")},
                         {QStringLiteral("nb"), tr("Norwegian")},
                         {QStringLiteral("en+la"), tr("English / Latin")},
                         {QStringLiteral("de+la"), tr("German / Latin")},
                         {QStringLiteral("nl+la"), tr("Dutch / Latin")},
                         {QStringLiteral("nb+la"), tr("Norwegian / Latin")}}}},
           page,
           QStringLiteral("structures")},
          {{QStringLiteral("labels/points"), tr("Size of letters"),
            tr("As on paper, whatever the size of the picture"),
            NumberField{.low = smallest, .high = largest, .unit = tr("pt"), .lowestText = {}}},
           page,
           10}};
}

std::vector<PreferenceRow> navigationRows() {
  const QString page = tr("Mouse");
  return {{{QStringLiteral("navigation/mouse"), tr("Mouse buttons as in"),
            tr("Which buttons and keys turn, move and zoom the picture; H shows them"),
            ChoiceField{{{QStringLiteral("sline"), tr("Sline")},
                         {QStringLiteral("slicer"), tr("3D Slicer")},
                         {QStringLiteral("blender"), tr("Blender")}}}},
           page,
           QStringLiteral("sline")},
          {{QStringLiteral("navigation/flights"), tr("Short flights between views"),
            tr("Off: the picture changes at once"), SwitchField{}},
           page,
           true}};
}

std::vector<PreferenceRow> fileRows() {
  return {{{QStringLiteral("files/importOptions"), tr("Always show import options"),
            tr("Before meshes are opened: units, smoothing and what is left out"), SwitchField{}},
           tr("Files"),
           false},
          {{QStringLiteral("files/outside"), tr("Files from outside open in"),
            tr("What a file manager or a command names while a window is open"),
            ChoiceField{{{QStringLiteral("running"), tr("The open window")},
                         {QStringLiteral("own"), tr("A window of their own")}}}},
           tr("Files"),
           QStringLiteral("running")},
          {{QStringLiteral("files/journal"), tr("Keep unsaved work"),
            tr("Each change is kept at once, and offered after a crash"), SwitchField{}},
           tr("Files"),
           true}};
}

}  // namespace

std::vector<PreferenceRow> preferenceRows() {
  std::vector<PreferenceRow> rows = appearanceRows();
  for (const std::vector<PreferenceRow>& more :
       {languageRows(), pictureRows(), labelRows(), navigationRows(), fileRows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace sline::widgets
