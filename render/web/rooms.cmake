# SPDX-License-Identifier: Apache-2.0
# The rooms of which the students' page has its program. Their sources compile without Qt, VTK,
# OpenMesh, oneTBB and OpenImageIO (tests/arch/web_shared.sh).
set(SLINE_PAGE_ROOMS
  model/anatomy model/base model/camera model/cuts model/edit model/fairing model/geometry
  model/lengths model/packed_scene model/scalars model/scene model/scene_json
  render/drawn render/gpu render/labels render/lines render/passes render/picking render/picture render/raster
  render/sight render/software render/strokes render/vectors render/web)
