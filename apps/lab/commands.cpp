#include "apps/lab/commands.h"

#include <array>

namespace carina::lab
{

std::span<const Command> commands()
{
    static const std::array all{anatomyCommand(), //
                                breatheCommand(),     intubateCommand(),
                                mechanicsCommand(), //
                                rubricCommand(),    //
                                deformCommand(),    //
                                fitCommand(),         icpCommand(),       pivotCommand(),
                                toolCommand(),        treCommand(), //
                                igtlCommand(),        ndiCommand(),       polarisCommand(),
                                polarisRateCommand(), predictCommand(),   probeCommand(),
                                devicesCommand(),     lagCommand(),       romCommand(),
                                trackCommand(),       cameraCommand(),    printMarkersCommand(),
                                driftCommand(),       driftNodeCommand(),
                                figuresCommand(), //
                                attackCommand(),      guestsCommand(),    carryCommand(),
                                handshakeCommand(),   sceneCommand(),     soakCommand(), //
                                renderCommand(),      summaryCommand()};
    return all;
}

} // namespace carina::lab
