#include "apps/lab/drift/live_orders.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace carina::lab
{
namespace
{

QString textOf(const std::string& text) { return QString::fromStdString(text); }

Duration durationIn(const QJsonObject& json, const char* key)
{
    return Duration{json[QLatin1StringView{key}].toInteger()};
}

} // namespace

QByteArray lineOf(const LiveOrders& orders)
{
    const bool isRandom = orders.script.axes == ActionScript::Axes::Random;
    const QJsonObject json{{QStringLiteral("part"), static_cast<int>(orders.part)},
                           {QStringLiteral("name"), textOf(orders.name)},
                           {QStringLiteral("address"), textOf(orders.address)},
                           {QStringLiteral("port"), int{orders.port}},
                           {QStringLiteral("open"), orders.isOpen},
                           {QStringLiteral("key"), textOf(toHex(orders.key))},
                           {QStringLiteral("strategy"), static_cast<int>(orders.strategy)},
                           {QStringLiteral("lag_ns"), qint64{orders.longestLag.count()}},
                           {QStringLiteral("asa_delays"), int{orders.asaDelays}},
                           {QStringLiteral("frame_ns"), qint64{orders.frames.interval.count()}},
                           {QStringLiteral("first_frame_ns"), qint64{orders.frames.first.count()}},
                           {QStringLiteral("actions"), orders.script.actions},
                           {QStringLiteral("rad_s"), orders.script.angularSpeed},
                           {QStringLiteral("m_s"), orders.script.speed},
                           {QStringLiteral("random_axes"), isRandom},
                           {QStringLiteral("seed"), qint64{orders.seed}}};
    return QJsonDocument{json}.toJson(QJsonDocument::Compact) + '\n';
}

Result<LiveOrders> ordersIn(const QByteArray& line)
{
    const QJsonObject json = QJsonDocument::fromJson(line).object();
    const auto key = keyFromHex(json[QStringLiteral("key")].toString().toStdString());
    LiveOrders orders;
    orders.part = static_cast<LiveOrders::Part>(json[QStringLiteral("part")].toInt());
    orders.name = json[QStringLiteral("name")].toString().toStdString();
    orders.address = json[QStringLiteral("address")].toString().toStdString();
    orders.port = static_cast<std::uint16_t>(json[QStringLiteral("port")].toInt());
    orders.isOpen = json[QStringLiteral("open")].toBool();
    orders.strategy = static_cast<StrategyKind>(json[QStringLiteral("strategy")].toInt());
    orders.longestLag = durationIn(json, "lag_ns");
    orders.asaDelays = static_cast<std::uint16_t>(json[QStringLiteral("asa_delays")].toInt());
    orders.frames = {durationIn(json, "frame_ns"), durationIn(json, "first_frame_ns")};
    orders.script.actions = json[QStringLiteral("actions")].toInt();
    orders.script.angularSpeed = json[QStringLiteral("rad_s")].toDouble();
    orders.script.speed = json[QStringLiteral("m_s")].toDouble();
    if (json[QStringLiteral("random_axes")].toBool())
        orders.script.axes = ActionScript::Axes::Random;
    orders.seed = static_cast<std::uint32_t>(json[QStringLiteral("seed")].toInteger());
    if (!key || orders.script.actions < 1)
        return fail(Errc::FileMalformed, "drift-node is started by 'drift --live' only");
    orders.key = *key;
    return orders;
}

} // namespace carina::lab
