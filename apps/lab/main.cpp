#include "apps/lab/anatomy_command.h"
#include "apps/lab/breathe_command.h"
#include "apps/lab/carry_command.h"
#include "apps/lab/command.h"
#include "apps/lab/deform_command.h"
#include "apps/lab/drawing_application.h"
#include "apps/lab/drift_command.h"
#include "apps/lab/drift_node_command.h"
#include "apps/lab/figures_command.h"
#include "apps/lab/fit_command.h"
#include "apps/lab/handshake_command.h"
#include "apps/lab/icp_command.h"
#include "apps/lab/mechanics_command.h"
#include "apps/lab/pivot_command.h"
#include "apps/lab/render_command.h"
#include "apps/lab/summary_command.h"
#include "apps/lab/track_command.h"
#include "apps/lab/tre_command.h"

#include <array>

namespace carina::lab
{

std::span<const Command> commands()
{
    static const std::array all{
        anatomyCommand(),   breatheCommand(),   carryCommand(),     deformCommand(),
        driftCommand(),     driftNodeCommand(), figuresCommand(),   fitCommand(),
        handshakeCommand(), icpCommand(),       mechanicsCommand(), pivotCommand(),
        renderCommand(),    summaryCommand(),   trackCommand(),     treCommand()};
    return all;
}

} // namespace carina::lab

int main(int argc, char** argv)
{
    const bool draws = argc > 1
                       && (argv[1] == carina::lab::breatheCommand().name
                           || argv[1] == carina::lab::figuresCommand().name
                           || argv[1] == carina::lab::renderCommand().name);
    const auto application = draws ? carina::lab::drawingApplication(argc, argv)
                                   : std::make_unique<QCoreApplication>(argc, argv);
    return carina::lab::runCommandLine(QCoreApplication::arguments());
}
