#include "apps/lab/anatomy/sweep_report.h"

#include "apps/lab/anatomy/anatomy_page.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

QJsonValue orNull(bool isThere, double value)
{
    return isThere ? QJsonValue{value} : QJsonValue{QJsonValue::Null};
}

QJsonObject parametersOf(const DeformationCombination& combination)
{
    const SweptBlade blade = combination.blade.value_or(SweptBlade{});
    const bool hasBlade = combination.blade.has_value();
    const SweptJaw jaw = combination.jaw.value_or(SweptJaw{});
    const bool isJawSet = combination.jaw && !hasBlade;
    const std::string_view name = bladeOf(blade.kind).name;
    QJsonObject events;
    for (const AirwayEvent& event : combination.events)
        events[QString::fromLatin1(eventName(event.kind))] = event.severity;
    return {{anatomy_sweep_key::kSeed, combination.seed ? QJsonValue{qint64(*combination.seed)}
                                                        : QJsonValue{QJsonValue::Null}},
            {anatomy_sweep_key::kNeckFlexion, inDegrees(combination.head.flexion)},
            {anatomy_sweep_key::kHeadExtension, inDegrees(combination.head.extension)},
            {anatomy_sweep_key::kJawOpening, orNull(isJawSet, inDegrees(jaw.opening))},
            {anatomy_sweep_key::kJawForward, orNull(isJawSet, inMillimetres(jaw.forward))},
            {anatomy_sweep_key::kBlade,
             hasBlade ? QJsonValue{QString::fromLatin1(name.data(), qsizetype(name.size()))}
                      : QJsonValue{QJsonValue::Null}},
            {anatomy_sweep_key::kProgress, orNull(hasBlade, blade.progress)},
            {anatomy_sweep_key::kLift, orNull(hasBlade, inMillimetres(blade.lift))},
            {anatomy_sweep_key::kLevering, orNull(hasBlade, inDegrees(blade.levering))},
            {anatomy_sweep_key::kEvents, events}};
}

QJsonObject leastObjectOf(const DeformedPart& part, const DeformationCombination& combination)
{
    return {
        {anatomy_sweep_key::kDeterminant, part.leastDeterminant},
        {anatomy_sweep_key::kPart, QString::fromStdString(part.name)},
        {anatomy_sweep_key::kPlace,
         QJsonArray{1e3 * part.p_A_least.x(), 1e3 * part.p_A_least.y(), 1e3 * part.p_A_least.z()}},
        {anatomy_sweep_key::kParameters, parametersOf(combination)}};
}

bool isFolded(const DeformedPart& part) { return !(part.leastDeterminant > 0.0); }

} // namespace

void SweepReport::add(const DeformationCombination& combination,
                      const std::vector<DeformedPart>& parts)
{
    bool intersects = false;
    bool folds = false;
    for (const DeformedPart& part : parts) {
        const bool intersectsItself = part.intersections > 0;
        Found& found = m_parts[part.name];
        found.selfIntersecting += intersectsItself ? 1 : 0;
        found.leastDeterminant = std::min(found.leastDeterminant, part.leastDeterminant);
        if (part.leastDeterminant < m_least) {
            m_least = part.leastDeterminant;
            m_leastObject = leastObjectOf(part, combination);
        }
        intersects |= intersectsItself;
        folds |= isFolded(part);
        if (!intersectsItself && !isFolded(part))
            continue;
        m_bad.append(QJsonObject{{anatomy_sweep_key::kPart, QString::fromStdString(part.name)},
                                 {anatomy_sweep_key::kPairs, qint64(part.intersections)},
                                 {anatomy_sweep_key::kDeterminant, part.leastDeterminant},
                                 {anatomy_sweep_key::kParameters, parametersOf(combination)}});
    }
    ++m_combinations;
    m_selfIntersecting += intersects ? 1 : 0;
    m_folded += folds ? 1 : 0;
}

QJsonObject SweepReport::object() const
{
    QJsonArray parts;
    for (const auto& [name, found] : m_parts)
        parts.append(QJsonObject{{anatomy_sweep_key::kPart, QString::fromStdString(name)},
                                 {anatomy_sweep_key::kInCombinations, found.selfIntersecting},
                                 {anatomy_sweep_key::kPartsLeast, found.leastDeterminant}});
    return {{anatomy_sweep_key::kCombinations, m_combinations},
            {anatomy_sweep_key::kSelfIntersecting, m_selfIntersecting},
            {anatomy_sweep_key::kFolded, m_folded},
            {anatomy_sweep_key::kLeast, m_leastObject},
            {anatomy_sweep_key::kParts, parts},
            {anatomy_sweep_key::kBad, m_bad},
            {kAcceptable, isAcceptable()}};
}

} // namespace carina::lab
