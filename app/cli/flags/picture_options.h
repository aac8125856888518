// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/flags/drawing_flags.h"
#include "app/cli/flags/focus_options.h"
#include "app/cli/flags/label_flags.h"
#include "app/cli/flags/option_kinds.h"
#include "app/cli/flags/picture_flags.h"
#include "app/cli/flags/section_options.h"
#include "app/cli/flags/style_flags.h"
#include "render/lines/techniques/technique_list.h"

namespace sline::cli {

/// Declares the flag of the thresholds of techniques.
inline void addLineThresholdOption(CLI::App& command, PictureFlags& flags) {
  many(command.add_option("--line-threshold", flags.lineThresholds,
                          "How strong lines must be to be drawn, of all structures: a technique's "
                          "first threshold (laplacian=3) or one by its name; may be given again. " +
                              render::thresholdHelp()))
      ->type_name("TECHNIQUE[.THRESHOLD]=VALUE");
}

/// Declares those flags of `PictureFlags` that are about colours and pens; returns the one of inks.
inline CLI::Option* addStyleOptions(CLI::App& command, PictureFlags& flags) {
  many(command.add_option("--color,--colour", flags.colours,
                          "The colour of a structure, or of all in a group"))
      ->type_name("NAME=#rrggbb");
  CLI::Option* ink = many(
      command.add_option("--ink-color,--ink-colour", flags.inkColours,
                         "The colour of lines and hatching, of all (--ink-color #30405a), of a "
                         "structure or of all in a group"));
  ink->type_name("[NAME=]#rrggbb");
  for (const StyleFlag& flag : styleFlags())
    many(command.add_option_function<std::vector<std::string>>(
             flag.flag,
             [&flags, &flag](const std::vector<std::string>& typed) {
               flags.styles[flag.flag] = typed;
             },
             flag.help))
        ->type_name(flag.value);
  addLineThresholdOption(command, flags);
  command
      .add_option("--fill", flags.fill,
                  "What hides behind unfilled structures: none lets it show through, paper hides "
                  "it, tint covers it with a thin wash of colour, veil lets it show faintly")
      ->type_name("none|paper|tint|veil");
  return ink;
}

/// Declares the flags that set the colours and manner in which all is drawn.
inline void addAppearanceOptions(CLI::App& command, PictureFlags& flags) {
  CLI::Option* ink = addStyleOptions(command, flags);
  CLI::Option* background =
      command.add_option("--background", flags.background, "What lies behind the drawing");
  background->type_name("white|paper|dark|transparent")->default_str("white");
  command.add_option("--drawing", flags.drawing, drawingHelp())->type_name("NAME");
  command
      .add_option("--hatching", flags.hatching,
                  "strokes that follow the form, or the grey hatching that Sline's paper prints, "
                  "to compare with")
      ->type_name("strokes|as-printed")
      ->capture_default_str();
  command
      .add_option("--light", flags.light,
                  "Where the light is that hatching's shadows turn away from; else where the "
                  "scene has it, or upper-left")
      ->type_name("upper-left|above|upper-right");
  command.add_flag("--key-light,!--no-key-light", flags.keyLight,
                   "Shades with that light, too, besides the one at the eye, or not; else as the "
                   "scene says");
  command
      .add_flag("--bw", flags.blackAndWhite,
                "For print in black and white: black ink on white paper; what is shaded is hatched "
                "instead and hides what lies behind it")
      ->excludes(background)
      ->excludes(ink);
}

/// Declares the flags that say which structures are drawn, and how detailed each is.
inline void addDetailOptions(CLI::App& command, PictureFlags& flags) {
  many(command.add_option("--gamma", flags.gammas,
                          "0 silhouette … 5 shaded surface, for all (--gamma 2) or for a structure "
                          "or group (--gamma liver=4); may be given again"))
      ->type_name("[NAME=]G");
  many(
      command.add_option(
          "--gamma-by", flags.gammaMaps,
          "Lets gamma vary over surfaces: by occlusion (0 in the open … 1 in a cavity), by "
          "curvature (1 on a sphere, negative in hollows), by the distance from a structure or "
          "group (mm) or as painted in the scene file (0 … 1), of all (--gamma-by occlusion), of a "
          "structure or of all in a group "
          "(--gamma-by liver=distance:tumour). A curve of 2 to 8 pairs says what is added to gamma "
          "at which value: --gamma-by \"liver=distance:tumour@0:+3,40:-1\""))
      ->type_name("[NAME=]SCALAR[@CURVE]");
  many(command.add_option("--only", flags.only,
                          "Draws these structures and groups alone; may be given again"))
      ->type_name("NAME");
  addFocusOptions(command, flags.focus);
}

/// Declares --look, which is auto unless the user says otherwise.
inline void addLookOption(CLI::App& command, PictureFlags& flags) {
  flags.look = "auto";
  command
      .add_option("--look", flags.look,
                  "auto: where neither the scene nor --gamma, --fill or --focus says how all of it "
                  "looks, what the scene is about is drawn in detail, everything else as context, "
                  "from where it is seen best; plain: contours, from the front")
      ->type_name("auto|plain")
      ->capture_default_str();
}

/// Declares the flag of a camera file; it excludes `view`, which names a camera otherwise.
inline void addCameraOption(CLI::App& command, PictureFlags& flags, CLI::Option* view) {
  command
      .add_option("--camera", flags.cameraFile,
                  "A camera in millimetres, LPS: {\"projection\":\"perspective\",\"eye_mm\":"
                  "[x,y,z],\"target_mm\":[x,y,z],\"up\":[x,y,z],\"opening_degrees\":30}, or "
                  "\"orthographic\" with \"height_mm\"")
      ->type_name("FILE.json")
      ->excludes(view);
}

/// Declares the flags of `PictureFlags` on a sub-command, except where the picture goes.
inline void addDrawingOptions(CLI::App& command, PictureFlags& flags) {
  command.add_option("--size", flags.size, "Width and height in pixels, 16 to 20000 each")
      ->type_name("WxH")
      ->capture_default_str();
  command
      .add_option(
          "--samples", flags.samples,
          "Draws this many times as large both ways and averages, for smooth edges: 1 to 4; "
          "auto takes 2, for more than 8 million pixels 1")
      ->type_name("auto|N")
      ->capture_default_str();
  CLI::Option* view = command
                          .add_option("--view", flags.view,
                                      "A saved view of the scene, shown as it was saved; else "
                                      "anterior, posterior, left, right, superior or inferior, "
                                      "fitted to what is visible; anterior if not given, or where "
                                      "--look auto sees most")
                          ->type_name("NAME");
  addCameraOption(command, flags, view);
  addDetailOptions(command, flags);
  addAppearanceOptions(command, flags);
  addSectionOptions(command, flags.sections);
}

/// Declares the same flags and the output file, which is needed.
inline void addPictureOptions(CLI::App& command, PictureFlags& flags) {
  command
      .add_option("-o,--output", flags.output,
                  "The picture: png, tiff, exr or jpg by its extension")
      ->required()
      ->type_name("FILE");
  addDrawingOptions(command, flags);
  addLookOption(command, flags);
  declareLabels(command, flags.labels);
}

}  // namespace sline::cli
