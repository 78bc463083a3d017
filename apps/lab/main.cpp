#include "apps/lab/command.h"

#include <QCoreApplication>

namespace carina::lab {

std::span<const Command> commands() { return {}; }

} // namespace carina::lab

int main(int argc, char** argv)
{
    const QCoreApplication application{argc, argv};
    return carina::lab::runCommandLine(QCoreApplication::arguments());
}
