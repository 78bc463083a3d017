#include "apps/lab/command/drawing_application.h"

#include "apps/program/program.h"

namespace carina::lab
{

std::unique_ptr<QCoreApplication> drawingApplication(int& argc, char** argv)
{
    return program::makeApplication(argc, argv);
}

} // namespace carina::lab
