// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/vtk_phong.h"

#include <GL/glew.h>  // before VTK's own OpenGL headers
#include <vtkActor.h>
#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataSilhouette.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>

#include "model/geometry/normals.h"

VTK_MODULE_INIT(vtkRenderingOpenGL2)

namespace sline::bench {

namespace {
vtkNew<vtkPolyData> polyDataOf(const model::Mesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(vtkIdType(mesh.vertexCount()));
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(vtkIdType(mesh.vertexCount()));
  const auto unit = model::vertexNormals(mesh);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    points->SetPoint(vtkIdType(v), &mesh.positions()[v].x);
    normals->SetTuple(vtkIdType(v), &unit[v].x);
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(vtkIdType(mesh.triangleCount()), vtkIdType(3 * mesh.triangleCount()));
  for (const auto& [a, b, c] : mesh.triangles())
    cells->InsertNextCell({vtkIdType(a), vtkIdType(b), vtkIdType(c)});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetNormals(normals);
  return data;
}

void place(vtkCamera* vtk, const model::Camera& camera) {
  vtk->SetPosition(double(camera.eye.x), double(camera.eye.y), double(camera.eye.z));
  vtk->SetFocalPoint(double(camera.target.x), double(camera.target.y), double(camera.target.z));
  vtk->SetViewUp(double(camera.up.x), double(camera.up.y), double(camera.up.z));
  vtk->SetViewAngle(double(camera.fovyDegrees));
}

/// A window of VTK for contexts made elsewhere, minus one false alarm: GLEW loads every entry point
/// and then reports failure because it finds no X11 display behind an EGL context.
class HeadlessWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static HeadlessWindow* New();
  vtkTypeMacro(HeadlessWindow, vtkGenericOpenGLRenderWindow)

      void OpenGLInitContext() override {
    ContextCreationTime.Modified();
    if (Initialized)
      return;
    glewExperimental = GL_TRUE;
    glewInit();
    GlewInitValid = glGenVertexArrays != nullptr;
    MaximumHardwareLineWidth = 1.0f;
    Initialized = GlewInitValid;
  }
};
vtkStandardNewMacro(HeadlessWindow);

}  // namespace

struct VtkPhong::Data {
  vtkNew<HeadlessWindow> window;
  vtkNew<vtkRenderer> renderer;
  model::Box bounds;
};

VtkPhong::VtkPhong(const model::Scene& scene, int width, int height)
    : m_data(std::make_unique<Data>()) {
  m_data->bounds = scene.visibleBounds();
  m_data->window->SetOwnContext(0);
  m_data->window->SetIsCurrent(true);
  m_data->window->SetReadyForRendering(true);
  m_data->window->SetSupportsOpenGL(true);
  m_data->window->SetIsDirect(true);
  m_data->window->SetMultiSamples(0);
  m_data->window->SetShowWindow(false);
  m_data->window->SetUseOffScreenBuffers(true);
  m_data->window->SetSize(width, height);
  m_data->window->AddRenderer(m_data->renderer);
  m_data->renderer->SetBackground(1.0, 1.0, 1.0);
  for (const model::NodeId id : scene.structuresBelow(model::rootId)) {
    const model::ResolvedStyle style = scene.resolve(id);
    if (!style.visible)
      continue;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(polyDataOf(*scene.find(id)->mesh));
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolationToPhong();
    actor->GetProperty()->SetColor(style.colour.red / 255.0, style.colour.green / 255.0,
                                   style.colour.blue / 255.0);
    m_data->renderer->AddActor(actor);
  }
}

VtkPhong::~VtkPhong() {
  m_data->window->Finalize();
}

void VtkPhong::draw(const model::Camera& camera) {
  place(m_data->renderer->GetActiveCamera(), camera);
  m_data->renderer->ResetCameraClippingRange();
  m_data->window->Render();
  m_data->window->WaitForCompletion();
}

struct VtkSilhouette::Data {
  vtkNew<vtkCamera> camera;
  vtkNew<vtkPolyDataSilhouette> filter;
};

VtkSilhouette::VtkSilhouette(const model::MeshPtr& mesh) : m_data(std::make_unique<Data>()) {
  m_data->filter->SetInputData(polyDataOf(*mesh));
  m_data->filter->SetCamera(m_data->camera);
  m_data->filter->SetEnableFeatureAngle(0);
}

VtkSilhouette::~VtkSilhouette() = default;
VtkSilhouette::VtkSilhouette(VtkSilhouette&&) noexcept = default;
VtkSilhouette& VtkSilhouette::operator=(VtkSilhouette&&) noexcept = default;

void VtkSilhouette::update(const model::Camera& camera) {
  place(m_data->camera, camera);
  m_data->filter->Update();
}

double VtkPhong::covered() const {
  const int* size = m_data->window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  m_data->window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels, 0);
  vtkIdType count = 0;
  const vtkIdType all = pixels->GetNumberOfTuples();
  for (vtkIdType i = 0; i < all; ++i)
    count += pixels->GetTypedComponent(i, 0) != 255 || pixels->GetTypedComponent(i, 1) != 255 ||
             pixels->GetTypedComponent(i, 2) != 255;
  return all > 0 ? double(count) / double(all) : 0.0;
}

}  // namespace sline::bench
