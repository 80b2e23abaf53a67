// Whether this process can render with OpenGL 3.3, asked before anything of Qt 3D is made: without
// a context Qt 3D 6.4 warns without end or crashes.
#pragma once

namespace rotorbench {

/// Sets the default surface format the scene's shaders need (core profile 3.3). Call before
/// QApplication is made; openGlWorks() does it too where the order did not matter yet.
void setSceneSurfaceFormat();

/// True if a context can be made current on an offscreen surface. Needs a QGuiApplication; asked
/// once.
bool openGlWorks();

}  // namespace rotorbench
