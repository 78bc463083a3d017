#include "apps/lab/breathe_command.h"

namespace carina::lab
{
namespace
{

Result<QJsonObject> refuse(const QStringList&)
{
    return fail(Errc::NoGraphics, "breathe draws, and this carina-lab was built without graphics. "
                                  "Configure with CARINA_DESKTOP=ON.");
}

constexpr std::string_view kHelp = R"(breathe
    Left out of this build, which has no graphics. Configure with CARINA_DESKTOP=ON.
)";

} // namespace

Command breatheCommand() { return {"breathe", kHelp, refuse}; }

std::unique_ptr<QCoreApplication> drawingApplication(int& argc, char** argv)
{
    return std::make_unique<QCoreApplication>(argc, argv);
}

} // namespace carina::lab
