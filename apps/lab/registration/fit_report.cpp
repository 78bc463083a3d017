#include "apps/lab/registration/fit_report.h"

#include "engine/io/files/json_fields.h"
#include "engine/registration/error/localisation_error.h"

#include <array>

namespace carina::lab
{
namespace
{

/// A length, or null for one that is infinite: JSON has no such number.
QJsonValue millimetresOrNull(Length length)
{
    return length < metres(kKnownExactly) ? QJsonValue{inMillimetres(length)} : QJsonValue::Null;
}

QJsonObject namedLength(const std::string& name, const QJsonValue& mm)
{
    return {{QStringLiteral("name"), QString::fromStdString(name)}, {QStringLiteral("mm"), mm}};
}

} // namespace

QJsonObject describeFit(const std::vector<std::string>& names, const RigidFit& fit)
{
    QJsonArray residuals;
    for (std::size_t i = 0; i < names.size(); ++i)
        residuals.append(namedLength(names[i], inMillimetres(metres(fit.residuals[i]))));
    return {{QStringLiteral("schema"), QStringLiteral("carina.fit/1")},
            {QStringLiteral("rms_mm"), inMillimetres(metres(fit.rms))},
            {QStringLiteral("residuals_mm"), residuals},
            {QStringLiteral("X_AM_mm"), jsonPose(fit.X_AM)}};
}

void describeErrors(QJsonObject& object, const std::vector<std::string>& names, const RigidFit& fit,
                    const std::vector<std::optional<double>>& leftOut)
{
    const LocalisationError fle = localisationError(metres(fit.rms), names.size());
    object.insert(QStringLiteral("fle_mm"),
                  QJsonObject{{QStringLiteral("rms"), inMillimetres(fle.rms)},
                              {QStringLiteral("limit95"), inMillimetres(fle.limit())},
                              {QStringLiteral("degrees"), fle.degrees}});
    QJsonArray distances;
    for (std::size_t i = 0; i < names.size(); ++i)
        distances.append(
            namedLength(names[i], millimetresOrNull(metres(leftOut[i].value_or(kKnownExactly)))));
    object.insert(QStringLiteral("leave_one_out_mm"), distances);
}

void describeWeights(QJsonObject& object, const WeightedFit& fit)
{
    object.insert(QStringLiteral("chi_squared"), fit.chiSquared);
    object.insert(QStringLiteral("degrees"), fit.degrees);
    object.insert(QStringLiteral("scale"), fit.scale());
}

void describeOrder(QJsonObject& object, const std::vector<std::string>& names,
                   const OrderFinding& order)
{
    static const std::array kFound{QStringLiteral("as given"), QStringLiteral("exchanged"),
                                   QStringLiteral("mirror image"), QStringLiteral("unexplained")};
    QJsonArray touchOf;
    for (const std::size_t touch : order.touchOf)
        touchOf.append(QString::fromStdString(names[touch]));
    object.insert(
        QStringLiteral("order"),
        QJsonObject{{QStringLiteral("found"), kFound[static_cast<std::size_t>(order.order)]},
                    {QStringLiteral("touch_of"), touchOf},
                    {QStringLiteral("rms_mm"), millimetresOrNull(order.rms)},
                    {QStringLiteral("explanations"), static_cast<qint64>(order.explanations)}});
}

} // namespace carina::lab
