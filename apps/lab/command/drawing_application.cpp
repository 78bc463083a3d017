#include "apps/lab/command/drawing_application.h"

#include "apps/program/program.h"

#include <QApplication>

namespace carina::lab
{

std::unique_ptr<QCoreApplication> drawingApplication(int& argc, char** argv)
{
    program::prepareDisplay();
    return std::make_unique<QApplication>(argc, argv);
}

} // namespace carina::lab
