#include "src/app/help/run.h"

int main(int argc, char** argv) { return snell::app::run(argc, argv); }
