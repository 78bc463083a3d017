#include "models/airway/head_positions.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

constexpr std::array kUsualPositions{
    UsualHeadPosition{"neutral", QT_TRANSLATE_NOOP("Airway", "Neutral"), {}},
    UsualHeadPosition{"sniffing", QT_TRANSLATE_NOOP("Airway", "Sniffing"), kSniffing},
    UsualHeadPosition{"extended", QT_TRANSLATE_NOOP("Airway", "Extended"), kHeadExtended},
    UsualHeadPosition{"flexed", QT_TRANSLATE_NOOP("Airway", "Flexed"), kNeckFlexed}};

class HeadWords
{
    Q_DECLARE_TR_FUNCTIONS(Airway)

public:
    static QString neckFlexed(int deg) { return tr("neck %1° flexed").arg(deg); }
    static QString neckExtended(int deg) { return tr("neck %1° extended").arg(deg); }
    static QString neckStraight() { return tr("neck 0°"); }
    static QString headFlexed(int deg) { return tr("head %1° flexed").arg(deg); }
    static QString headExtended(int deg) { return tr("head %1° extended").arg(deg); }
    static QString headStraight() { return tr("head 0°"); }
    static QString both(const QString& neck, const QString& head)
    {
        return tr("%1, %2", "neck; head").arg(neck, head);
    }
    static QString named(const QString& name, const QString& figures)
    {
        return tr("%1: %2", "position of the head; its figures").arg(name, figures);
    }
};

template <class Is> const UsualHeadPosition* firstUsual(const Is& is)
{
    const auto* found = std::ranges::find_if(kUsualPositions, is);
    return found == kUsualPositions.end() ? nullptr : found;
}

} // namespace

std::span<const UsualHeadPosition> usualHeadPositions() { return kUsualPositions; }

const UsualHeadPosition* headPositionNamed(std::string_view name)
{
    return firstUsual([name](const UsualHeadPosition& usual) { return usual.name == name; });
}

const UsualHeadPosition* usualOf(const HeadPosition& position)
{
    return firstUsual(
        [&position](const UsualHeadPosition& usual) { return usual.position == position; });
}

QString usualText(const UsualHeadPosition& usual)
{
    return QCoreApplication::translate("Airway", usual.text);
}

QString neckText(const HeadPosition& position)
{
    const int deg = qRound(inDegrees(position.flexion));
    if (deg == 0)
        return HeadWords::neckStraight();
    return deg > 0 ? HeadWords::neckFlexed(deg) : HeadWords::neckExtended(-deg);
}

QString headText(const HeadPosition& position)
{
    const int deg = qRound(inDegrees(position.extension));
    if (deg == 0)
        return HeadWords::headStraight();
    return deg > 0 ? HeadWords::headExtended(deg) : HeadWords::headFlexed(-deg);
}

QString headFiguresText(const HeadPosition& position)
{
    return HeadWords::both(neckText(position), headText(position));
}

QString headPositionText(const HeadPosition& position)
{
    const QString figures = headFiguresText(position);
    const UsualHeadPosition* usual = usualOf(position);
    return usual ? HeadWords::named(usualText(*usual), figures) : figures;
}

} // namespace carina
