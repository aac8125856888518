// SPDX-License-Identifier: Apache-2.0
// Shows a scene in a web page: what the page's script asks for, in terms of the same scene, camera
// and picture as everywhere. It knows no texts and no language; the page has those.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "model/camera/free_sides.h"
#include "model/geometry/mesh_trees.h"
#include "model/packed_scene/packed_scene.h"
#include "render/gpu/device.h"
#include "render/labels/layout.h"
#include "render/picking/pick_index.h"
#include "render/picture/motion_quality.h"
#include "render/picture/picture.h"

namespace sline::render::web {

/// The picture's size: device pixels, of which there are `ratio` for each of the page's pixels.
struct PageSize {
  int width = 1;
  int height = 1;
  float ratio = 1.0f;
};

/// How much room a label's text needs, in the page's pixels.
struct TextRoom {
  model::AnnotationId id;
  glm::vec2 box{0.0f};
};

class PageEngine {
 public:
  /// Takes a part of the scene (packed_scene.h); what was changed by hand stays changed.
  Status take(std::string_view part);
  /// Tells the picture's size, at least one pixel each way.
  void setSize(const PageSize& size);

  void orbit(const glm::vec2& pixels);
  void pan(const glm::vec2& pixels);
  void roll(float degrees);
  /// Magnifies around what is seen at a place of the page.
  void zoom(float factor, const glm::vec2& at);
  /// Shows these structures whole, or everything where there are none.
  void fit(std::span<const model::NodeId> ids);
  void look(model::AnatomicalView from);
  const model::Camera& camera() const { return m_camera; }
  void setCamera(const model::Camera& camera);
  /// Goes to a saved view: what it shows is shown at once, 0 begins at the camera as it is, 1 is
  /// there. Whatever the share is that comes first, it begins a way: there is none before.
  void goTo(std::size_t view, double share);

  void setGamma(std::span<const model::NodeId> ids, float gamma);
  float gamma(model::NodeId id) const;
  void setVisible(std::span<const model::NodeId> ids, bool visible);
  bool visible(model::NodeId id) const;
  void resetLook();
  void select(std::vector<model::NodeId> ids) { m_selected = std::move(ids); }

  /// Says which labels are shown, and their texts' sizes; those that are not in the list are not.
  /// `seen`: nor are those of what one does not see; of the others the first `seenLabels`.
  void setLabels(std::vector<TextRoom> labels, bool seen = false);
  static constexpr std::size_t seenLabels = 24;
  /// The labels as the last picture has them; millimetres of which `millimetres` make a pixel of
  /// the page.
  const LabelLayout& labels() const { return m_layout; }
  const std::vector<LabelItem>& labelItems() const { return m_items; }

  /// Makes the picture that needs a current OpenGL ES 3.0 context; without a picture all but `draw`
  /// works.
  Status openPicture();
  /// Makes the picture that the processor draws, as a workstation without a card does.
  void openPlainPicture();
  /// The share of the canvas' pixels each way that `draw` should have while the camera moves.
  float scale(bool moving) const { return moving ? m_quality.fineness().scale : 1.0f; }
  /// Draws into the context's own framebuffer, or into `pixels`. While the camera moves, surfaces
  /// are as coarse as they must be. Returns whether nothing is missing that one drawn at rest has.
  Result<bool> draw(bool moving);
  /// The pixels of the plain picture, RGBA of 8 bits each, red in the lowest, in rows from the top.
  std::span<const std::uint32_t> pixels() const { return m_pixels; }
  /// Tells how long the picture took that was drawn last, until all of it was there: a browser's
  /// OpenGL draws while the program goes on.
  void took(double milliseconds);
  /// Returns the segments of all lines that the scene's styles ask for, in the patient's frame,
  /// before anything hides them: two ends each. They are the same as the workstation's.
  std::vector<glm::vec3> segments();
  /// Finds labels' places and lays them out for the camera.
  void layOutLabels(bool moving);

  struct Pick {
    model::NodeId structure;
    model::AnnotationId label;  ///< whose text is there, or the dot that is not dashed
  };
  Pick pick(const glm::vec2& at);

  /// What is drawn: the scene with the view's looks and what was changed by hand.
  const model::Scene& shown() const { return m_shown; }
  /// One pixel of the page is 1/96 inch.
  static constexpr float millimetres = 25.4f / 96.0f;

 private:
  /// Says what was done by hand to nodes and all below them.
  struct Change {
    std::vector<model::NodeId> ids;
    std::variant<float, bool> to;  ///< Γ, or whether they are shown
  };

  PictureTarget target(const gpu::TextureSize& size);
  float aspect() const { return float(m_size.width) / float(m_size.height); }
  glm::vec2 pageSize() const;
  /// Returns the room that cameras leave for labels.
  model::FreeSides freeSides() const;
  glm::vec3 pivot() const;
  void change(Change change);
  /// Does it to what is shown; nodes that are not there yet stay as they are.
  void apply(const Change& change);
  void show();
  /// Returns what is shown, in which those labels are visible that may stand in its picture.
  model::Scene labelled(bool moving) const;
  /// Lays the labels out; those of what is seen are left out where they would have to go to the far
  /// side of the anatomy.
  LabelLayout laidOut(LabelRequest& request, const LabelLayout* before) const;

  model::UnpackedScene m_unpacked;
  std::optional<std::size_t> m_view;  ///< whose looks are shown
  std::vector<Change> m_changes;      ///< by hand, in the order of time
  std::vector<model::NodeId> m_selected;
  model::Scene m_shown;
  model::Camera m_camera;
  model::Camera m_flightFrom;
  std::optional<std::size_t> m_flyingTo;  ///< absent where no way has begun that goes on
  bool m_hasCamera = false;
  PageSize m_size;

  std::unique_ptr<Picture> m_picture;
  bool m_plain = false;                   ///< the processor draws it
  std::unique_ptr<gpu::Target> m_canvas;  ///< else
  std::vector<std::uint32_t> m_pixels;
  MotionQuality m_quality;
  std::optional<Fineness> m_judged;  ///< that of the last picture of a moving camera

  PickIndex m_index;
  model::MeshTrees m_trees;
  std::vector<TextRoom> m_rooms;
  bool m_onlySeen = false;
  std::vector<LabelItem> m_items;
  LabelLayout m_layout;
  glm::vec3 m_settled{0.0f};  ///< towards the eye, when the camera last rested
};

}  // namespace sline::render::web
