#include "apps/lab/drawing_application.h"

#include "widgets/scene/graphics.h"

#include <QApplication>

namespace carina::lab
{

std::unique_ptr<QCoreApplication> drawingApplication(int& argc, char** argv)
{
    // Without a display the platform for X would end the program; offscreen says there is no
    // OpenGL.
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    prepareGraphics();
    return std::make_unique<QApplication>(argc, argv);
}

} // namespace carina::lab
