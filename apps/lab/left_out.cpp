#include "apps/lab/breathe_command.h"
#include "apps/lab/drawing_application.h"
#include "apps/lab/figures_command.h"
#include "apps/lab/render_command.h"
#include "apps/lab/summary_command.h"

namespace carina::lab
{
namespace
{

/// What takes the place of a command that needs the desktop build.
Result<QJsonObject> refuse(const QStringList&)
{
    return fail(Errc::NoGraphics, "This carina-lab was built without graphics, which this command "
                                  "needs. Configure with CARINA_DESKTOP=ON.");
}

constexpr std::string_view kBreatheHelp = R"(breathe
    Left out of this build, which has no graphics. Configure with CARINA_DESKTOP=ON.
)";

constexpr std::string_view kFiguresHelp = R"(figures
    Left out of this build, which has no graphics. Configure with CARINA_DESKTOP=ON.
)";

constexpr std::string_view kRenderHelp = R"(render
    Left out of this build, which has no graphics. Configure with CARINA_DESKTOP=ON.
)";

constexpr std::string_view kSummaryHelp = R"(summary
    Left out of this build, which has no graphics. Configure with CARINA_DESKTOP=ON.
)";

} // namespace

Command breatheCommand() { return {"breathe", kBreatheHelp, refuse}; }

Command figuresCommand() { return {"figures", kFiguresHelp, refuse}; }

Command renderCommand() { return {"render", kRenderHelp, refuse}; }

Command summaryCommand() { return {"summary", kSummaryHelp, refuse}; }

std::unique_ptr<QCoreApplication> drawingApplication(int& argc, char** argv)
{
    return std::make_unique<QCoreApplication>(argc, argv);
}

} // namespace carina::lab
