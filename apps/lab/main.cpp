#include "apps/lab/command.h"
#include "apps/lab/track_command.h"

#include <QCoreApplication>

#include <array>

namespace carina::lab {

std::span<const Command> commands()
{
    static const std::array all{trackCommand()};
    return all;
}

} // namespace carina::lab

int main(int argc, char** argv)
{
    const QCoreApplication application{argc, argv};
    return carina::lab::runCommandLine(QCoreApplication::arguments());
}
