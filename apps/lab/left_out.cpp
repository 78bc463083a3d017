#include "apps/lab/command/drawing_application.h"
#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"

namespace carina::lab
{
namespace
{

Result<QJsonObject> refuse(const Words&)
{
    return fail(Errc::NoGraphics, "This carina-lab was built without graphics, which this command "
                                  "needs. Configure with CARINA_DESKTOP=ON.");
}

/// What takes the place of a command that needs the desktop build.
Command leftOut(const char* name)
{
    return {.name = name,
            .theme = "left out",
            .summary = "needs graphics, which this build does not have",
            .uses = {{.lines = {""},
                      .text = "Left out of this build, which has no graphics. Configure with "
                              "CARINA_DESKTOP=ON."}},
            .mostFiles = 1000,
            .experiment = refuse};
}

} // namespace

Command breatheCommand() { return leftOut("breathe"); }
Command figuresCommand() { return leftOut("figures"); }
Command printMarkersCommand() { return leftOut("print-markers"); }
Command renderCommand() { return leftOut("render"); }
Command summaryCommand() { return leftOut("summary"); }

std::unique_ptr<QCoreApplication> drawingApplication(int& argc, char** argv)
{
    return std::make_unique<QCoreApplication>(argc, argv);
}

} // namespace carina::lab
