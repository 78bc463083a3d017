#include "apps/lab/drawing_application.h"

#include "apps/viewer/program.h"

#include <QApplication>

namespace carina::lab
{

std::unique_ptr<QCoreApplication> drawingApplication(int& argc, char** argv)
{
    viewer::prepareDisplay();
    return std::make_unique<QApplication>(argc, argv);
}

} // namespace carina::lab
