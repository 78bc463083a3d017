#include "apps/lab/registration/fit_report.h"

#include "apps/lab/registration/fit_page.h"
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

QJsonObject namedLength(const std::string& name, const Key& key, const QJsonValue& mm)
{
    return {{fit_key::kName, QString::fromStdString(name)}, {key, mm}};
}

} // namespace

QJsonObject describeFit(const std::vector<std::string>& names, const RigidFit& fit)
{
    QJsonArray residuals;
    for (std::size_t i = 0; i < names.size(); ++i)
        residuals.append(
            namedLength(names[i], fit_key::kResidual, inMillimetres(metres(fit.residuals[i]))));
    return {{fit_key::kSchema, QLatin1StringView{fit_key::kSchema.help}},
            {fit_key::kRms, inMillimetres(metres(fit.rms))},
            {fit_key::kResiduals, residuals},
            {fit_key::kPose, jsonPose(fit.X_AM)}};
}

void describeErrors(QJsonObject& object, const std::vector<std::string>& names, const RigidFit& fit,
                    const std::vector<std::optional<double>>& leftOut)
{
    const LocalisationError fle = localisationError(metres(fit.rms), names.size());
    object.insert(fit_key::kFle, QJsonObject{{fit_key::kFleRms, inMillimetres(fle.rms)},
                                             {fit_key::kFleLimit, inMillimetres(fle.limit())},
                                             {fit_key::kFleDegrees, fle.degrees}});
    QJsonArray distances;
    for (std::size_t i = 0; i < names.size(); ++i)
        distances.append(
            namedLength(names[i], fit_key::kLeftOut,
                        millimetresOrNull(metres(leftOut[i].value_or(kKnownExactly)))));
    object.insert(fit_key::kLeaveOneOut, distances);
}

void describeWeights(QJsonObject& object, const WeightedFit& fit)
{
    object.insert(fit_key::kChiSquared, fit.chiSquared);
    object.insert(fit_key::kDegrees, fit.degrees);
    object.insert(fit_key::kScale, fit.scale());
}

void describeOrder(QJsonObject& object, const std::vector<std::string>& names,
                   const OrderFinding& order)
{
    static const std::array kFound{QStringLiteral("as given"), QStringLiteral("exchanged"),
                                   QStringLiteral("mirror image"), QStringLiteral("unexplained")};
    QJsonArray touchOf;
    for (const std::size_t touch : order.touchOf)
        touchOf.append(QString::fromStdString(names[touch]));
    object.insert(fit_key::kOrder,
                  QJsonObject{{fit_key::kFound, kFound[static_cast<std::size_t>(order.order)]},
                              {fit_key::kTouchOf, touchOf},
                              {fit_key::kOrderRms, millimetresOrNull(order.rms)},
                              {fit_key::kExplanations, static_cast<qint64>(order.explanations)}});
}

} // namespace carina::lab
