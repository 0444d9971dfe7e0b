/// @file application.h
/// The command line of the modeler, and what a program needs before it has a window.
#pragma once

namespace sinew::modeler {

/// The OpenGL that viewports draw with; before the application is made.
void ask_for_opengl();

/// @return the exit status: 0 done, 1 no display, 2 the call is wrong
int run(int argc, char** argv);

}  // namespace sinew::modeler
