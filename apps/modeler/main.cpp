#include "window/application.h"

int main(int argc, char** argv) { return sinew::modeler::run(argc, argv); }
