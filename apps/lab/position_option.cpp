#include "apps/lab/position_option.h"

namespace carina::lab
{
namespace
{

const QString kPosition = QStringLiteral("position");

} // namespace

std::string_view positionName(BodyPosition position)
{
    switch (position) {
    case BodyPosition::Supine:
        break;
    case BodyPosition::Sitting:
        return "sitting";
    case BodyPosition::Prone:
        return "prone";
    case BodyPosition::RightLateral:
        return "right_lateral";
    case BodyPosition::LeftLateral:
        return "left_lateral";
    }
    return "supine";
}

void addPositionOption(QCommandLineParser& parser)
{
    parser.addOption(QCommandLineOption{kPosition, {}, kPosition});
}

Result<BodyPosition> positionOption(const QCommandLineParser& parser, const char* command)
{
    if (!parser.isSet(kPosition))
        return BodyPosition::Supine;
    const std::string word = parser.value(kPosition).toStdString();
    for (const BodyPosition position : kBodyPositions)
        if (positionName(position) == word)
            return position;
    return fail(Errc::OutOfRange, std::string{command} + " knows no --position " + word + ".");
}

} // namespace carina::lab
