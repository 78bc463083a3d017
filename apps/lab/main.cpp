#include "apps/lab/command/drawing_application.h"
#include "apps/lab/commands.h"

#include <algorithm>

int main(int argc, char** argv)
{
    using carina::lab::Command;
    const std::span<const Command> commands = carina::lab::commands();
    const bool draws = std::ranges::any_of(commands, [&](const Command& command) {
        return command.draws && argc > 1 && std::string_view{command.name} == argv[1];
    });
    const auto application = draws ? carina::lab::drawingApplication(argc, argv)
                                   : std::make_unique<QCoreApplication>(argc, argv);
    return carina::lab::runCommandLine(commands, QCoreApplication::arguments());
}
