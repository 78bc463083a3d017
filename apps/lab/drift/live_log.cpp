#include "apps/lab/drift/live_log.h"

#include <QJsonArray>

#include <cmath>
#include <initializer_list>

namespace carina::lab
{
namespace
{

const QString kLogSchema = QStringLiteral("carina.drift-log/2");
constexpr qsizetype kSampleColumns = 16;
constexpr qsizetype kActionColumns = 10;

template <class Time> QJsonValue jsonTime(Time t) { return qint64{t.time_since_epoch().count()}; }

void appendNumbers(QJsonArray& row, std::initializer_list<double> numbers)
{
    for (const double number : numbers)
        row.append(number);
}

void appendPose(QJsonArray& row, const std::optional<RigidTransform>& X)
{
    if (!X) {
        for (int i = 0; i < 7; ++i)
            row.append(QJsonValue::Null);
        return;
    }
    const Quat& q = X->rotation();
    const Vec3& p = X->translation();
    appendNumbers(row, {q.w(), q.x(), q.y(), q.z(), p.x(), p.y(), p.z()});
}

QJsonArray rowOf(const LiveSample& sample)
{
    QJsonArray row{jsonTime(sample.machine)};
    row.append(sample.session ? jsonTime(*sample.session) : QJsonValue{QJsonValue::Null});
    appendPose(row, sample.X_AO_turned);
    appendPose(row, sample.X_AO_moved);
    return row;
}

QJsonArray rowOf(const DeclaredAction& action)
{
    QJsonArray row{jsonTime(action.called), jsonTime(action.turnedSince),
                   jsonTime(action.movedSince)};
    const Quat& q = action.q_AO;
    const Vec3& p = action.p_AO;
    appendNumbers(row, {q.w(), q.x(), q.y(), q.z(), p.x(), p.y(), p.z()});
    return row;
}

/// Reads rows of numbers and remembers whether one was none.
class RowReader
{
public:
    explicit RowReader(bool& isWhole) : m_isWhole{isWhole} {}

    void next(const QJsonValue& row, qsizetype columns)
    {
        m_row = row.toArray();
        m_isWhole = m_isWhole && m_row.size() == columns;
    }
    [[nodiscard]] bool isNull(qsizetype column) const { return m_row.at(column).isNull(); }
    Duration time(qsizetype column)
    {
        number(column);
        return Duration{m_row.at(column).toInteger()};
    }
    Vec3 vector(qsizetype column)
    {
        return {number(column), number(column + 1), number(column + 2)};
    }
    Quat rotation(qsizetype column)
    {
        const double w = number(column);
        const Vec3 v = vector(column + 1);
        const Quat q{w, v.x(), v.y(), v.z()};
        m_isWhole = m_isWhole && std::abs(q.norm() - 1.0) < 1e-9;
        return m_isWhole ? q : Quat::Identity();
    }
    std::optional<RigidTransform> pose(qsizetype column)
    {
        if (isNull(column))
            return std::nullopt;
        const Quat q = rotation(column);
        return RigidTransform{q, vector(column + 4)};
    }

private:
    double number(qsizetype column)
    {
        m_isWhole = m_isWhole && m_row.at(column).isDouble();
        return m_row.at(column).toDouble();
    }

    QJsonArray m_row;
    bool& m_isWhole;
};

} // namespace

QJsonObject toJson(const LiveLog& log)
{
    QJsonArray samples;
    for (const LiveSample& sample : log.samples)
        samples.append(rowOf(sample));
    QJsonArray actions;
    for (const DeclaredAction& action : log.actions)
        actions.append(rowOf(action));
    return {{QStringLiteral("schema"), kLogSchema},
            {QStringLiteral("handshake_ns"), qint64{log.handshake.count()}},
            {QStringLiteral("strategy"), static_cast<int>(log.strategy)},
            {QStringLiteral("actions"), actions},
            {QStringLiteral("samples"), samples}};
}

Result<LiveLog> liveLogFrom(const QJsonObject& json)
{
    LiveLog log;
    bool isWhole = json[QStringLiteral("schema")] == kLogSchema;
    RowReader row{isWhole};
    log.handshake = Duration{json[QStringLiteral("handshake_ns")].toInteger()};
    const int strategy = json[QStringLiteral("strategy")].toInt(-1);
    isWhole = isWhole && strategy >= 0 && strategy <= static_cast<int>(StrategyKind::None);
    log.strategy = static_cast<StrategyKind>(strategy);
    for (const auto& value : json[QStringLiteral("samples")].toArray()) {
        row.next(value, kSampleColumns);
        LiveSample sample;
        sample.machine = LocalTime{row.time(0)};
        if (!row.isNull(1))
            sample.session = SessionTime{row.time(1)};
        sample.X_AO_turned = row.pose(2);
        sample.X_AO_moved = row.pose(9);
        log.samples.push_back(sample);
    }
    for (const auto& value : json[QStringLiteral("actions")].toArray()) {
        row.next(value, kActionColumns);
        log.actions.push_back({.called = LocalTime{row.time(0)},
                               .turnedSince = LocalTime{row.time(1)},
                               .movedSince = LocalTime{row.time(2)},
                               .q_AO = row.rotation(3),
                               .p_AO = row.vector(7)});
    }
    if (!isWhole)
        return fail(Errc::FileMalformed, "no log of a live session");
    return log;
}

} // namespace carina::lab
