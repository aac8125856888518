// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/vtk/vtk_messages.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <algorithm>

namespace sline::model {

namespace {
thread_local VtkMessages* listener = nullptr;

/// Receives the messages of VTK, which has one sink for all its objects. An observer on the reader
/// would miss what its arrays and parsers report, so the sink itself is replaced, once; messages of
/// threads without a listener go to the standard error stream as they always did. VTK's logger,
/// which would print each message besides, is turned off there.
class MessageSink : public vtkOutputWindow {
 public:
  static MessageSink* New();
  MessageSink() { m_usual->SetDisplayModeToAlwaysStdErr(); }

  void DisplayText(const char* text) override { pass(text, &vtkOutputWindow::DisplayText); }
  void DisplayErrorText(const char* text) override {
    pass(text, &vtkOutputWindow::DisplayErrorText);
  }
  void DisplayWarningText(const char* text) override {
    pass(text, &vtkOutputWindow::DisplayWarningText);
  }
  void DisplayGenericWarningText(const char* text) override {
    pass(text, &vtkOutputWindow::DisplayGenericWarningText);
  }
  void DisplayDebugText(const char* text) override {
    pass(text, &vtkOutputWindow::DisplayDebugText);
  }

 private:
  void pass(const char* text, void (vtkOutputWindow::*display)(const char*)) {
    if (listener)
      listener->add(text);
    else
      (m_usual->*display)(text);
  }
  vtkNew<vtkOutputWindow> m_usual;
};
vtkStandardNewMacro(MessageSink)

    void installSink() {
  static const bool installed = [] {
    const vtkNew<MessageSink> sink;
    vtkOutputWindow::SetInstance(sink);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    return true;
  }();
  (void)installed;
}
}  // namespace

VtkMessages::VtkMessages() {
  installSink();
  listener = this;
}

VtkMessages::~VtkMessages() {
  listener = nullptr;
}

void VtkMessages::add(const char* text) {
  if (m_first.empty() && text)
    m_first = text;
}

std::string VtkMessages::first() const {
  // The text is "ERROR: In FILE, line N\nvtkClass (0x…): the message\n\n".
  std::string text = m_first;
  if (const std::size_t address = text.find("): "); address != std::string::npos)
    text.erase(0, address + 3);
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.'))
    text.pop_back();
  return text.substr(0, 300);
}

}  // namespace sline::model
