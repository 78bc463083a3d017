#include "apps/lab/breathing/published_ranges.h"

#include "apps/lab/breathing/mechanics_page.h"

#include <cmath>

namespace carina::lab
{
namespace
{

constexpr double kAny = -1.0;       // severity
constexpr double kRounding = 0.005; // of tables that are reproduced

/// One published range of a figure.
struct PublishedRange {
    ConditionKind kind;
    double severity;
    const char* figure;
    double least;
    double greatest;
    const char* source;
    double (*value)(const MeasuredCondition&);
    bool ofAdults = false; ///< an absolute figure that says nothing of a child
};

constexpr const char* kPulse = "Pulse RespiratoryMethodology, table of diseases";
constexpr const char* kEmphysema = "emphysema, AJRCCM 158:3";

double lungCompliance(const RespiratorySystem& system)
{
    const ChestContent rest = restingContent(system);
    double sum = 0.0;
    for (std::size_t i = 0; i < rest.size(); ++i)
        sum += inLitresPerCmH2O(system.lungs[i].curve.complianceAt(rest[i].gas));
    return sum;
}

double bronchi(const RespiratorySystem& system)
{
    return 1.0 / (system.lungs[0].bronchi.si + system.lungs[1].bronchi.si);
}

double rest_l(const RespiratorySystem& system)
{
    const ChestContent rest = restingContent(system);
    return inLitres(rest[0].gas + rest[1].gas);
}

double capacity_l(const RespiratorySystem& system)
{
    double sum = 0.0;
    for (const LungMechanics& lung : system.lungs)
        sum += inLitres(lung.curve.floor + lung.curve.span);
    return sum;
}

double deadSpace_l(const MeasuredCondition& m)
{
    const double size = rest_l(m.healthy) / 2.31; // of the patient of Pulse
    return inLitres(m.awake.lungs[0].alveolarDeadSpace + m.awake.lungs[1].alveolarDeadSpace) / size;
}

double complianceRatio(const MeasuredCondition& m)
{
    return lungCompliance(m.awake) / lungCompliance(m.healthy);
}

double bronchiRatio(const MeasuredCondition& m) { return bronchi(m.awake) / bronchi(m.healthy); }

double inspiration(const MeasuredCondition& m) { return 0.5 * m.awake.inspiratoryRatio; }

double airwayRatio(const MeasuredCondition& m)
{
    return (m.awake.upperLaminar.si + bronchi(m.awake))
           / (m.healthy.upperLaminar.si + bronchi(m.healthy));
}

double restRatio(const MeasuredCondition& m) { return rest_l(m.awake) / rest_l(m.healthy); }

double capacityRatio(const MeasuredCondition& m)
{
    return capacity_l(m.awake) / capacity_l(m.healthy);
}

/// Of the floor of both lungs' curves, which stands for it.
double residualRatio(const MeasuredCondition& m)
{
    return m.awake.lungs[0].curve.floor / m.healthy.lungs[0].curve.floor;
}

double staticCompliance_ml(const MeasuredCondition& m)
{
    const BreathFigures& breath = m.volumeControl;
    return inMillilitres(breath.tidalVolume) / inCmH2O(breath.plateau - m.peep - breath.autoPeep);
}

double autoPeepAt20_cmH2O(const MeasuredCondition& m) { return inCmH2O(m.at20PerMin.autoPeep); }

double openShareOfRight(const MeasuredCondition& m)
{
    return restingContent(m.awake)[0].gas / m.healthy.lungs[0].wallVolume;
}

double endOfUptake(const MeasuredCondition& m)
{
    return m.awake.lungs[1].uptakeEnd / m.healthy.lungs[1].wallVolume;
}

using enum ConditionKind;

constexpr PublishedRange kRanges[] = {
    {Normal, kAny, "ventilated_compliance_ml_per_cmh2o", 50.0, 80.0,
     "static compliance of adults under a ventilator (rdrr cliot)", staticCompliance_ml, true},
    {Ards, 0.3, "lung_compliance_ratio", 0.7, 0.7, kPulse, complianceRatio},
    {Ards, 0.6, "lung_compliance_ratio", 0.5, 0.5, kPulse, complianceRatio},
    {Ards, 0.9, "lung_compliance_ratio", 0.4, 0.4, kPulse, complianceRatio},
    {Ards, 0.3, "inspiration_to_expiration", 0.7, 0.7, kPulse, inspiration},
    {Ards, 0.6, "inspiration_to_expiration", 1.1, 1.1, kPulse, inspiration},
    {Ards, 0.9, "inspiration_to_expiration", 1.5, 1.5, kPulse, inspiration},
    {Ards, 0.6, "alveolar_dead_space_l", 0.03, 0.03, kPulse, deadSpace_l},
    {Ards, 0.9, "alveolar_dead_space_l", 0.15, 0.15, kPulse, deadSpace_l},
    {Ards, 0.9, "ventilated_compliance_ml_per_cmh2o", 0.0, 30.0,
     "static compliance in severe ARDS (rdrr cliot)", staticCompliance_ml, true},
    {Copd, 0.3, "bronchial_resistance_ratio", 0.85 / 0.45, 0.85 / 0.45, kPulse, bronchiRatio},
    {Copd, 0.6, "bronchial_resistance_ratio", 1.7 / 0.45, 1.7 / 0.45, kPulse, bronchiRatio},
    {Copd, 0.9, "bronchial_resistance_ratio", 2.4 / 0.45, 2.4 / 0.45, kPulse, bronchiRatio},
    {Copd, 0.3, "inspiration_to_expiration", 0.35, 0.35, kPulse, inspiration},
    {Copd, 0.6, "inspiration_to_expiration", 0.22, 0.22, kPulse, inspiration},
    {Copd, 0.9, "inspiration_to_expiration", 0.12, 0.12, kPulse, inspiration},
    {Copd, 0.9, "alveolar_dead_space_l", 0.9, 0.9, kPulse, deadSpace_l},
    {Copd, 0.9, "rest_volume_ratio", 1.77, 1.77, kEmphysema, restRatio},
    {Copd, 0.9, "total_capacity_ratio", 1.40, 1.40, kEmphysema, capacityRatio},
    {Copd, 0.9, "residual_volume_ratio", 2.42, 2.42, kEmphysema, residualRatio},
    {Copd, 0.9, "auto_peep_at_20_per_min_cmh2o", 5.0, 10.0,
     "range asked of adults with severe COPD at 20 breaths per minute", autoPeepAt20_cmH2O, true},
    {Asthma, 0.3, "airway_resistance_ratio", 5.0, 15.0, "acute asthma (Pulse)", airwayRatio},
    {Asthma, 0.6, "airway_resistance_ratio", 5.0, 15.0, "acute asthma (Pulse)", airwayRatio},
    {Asthma, 0.9, "airway_resistance_ratio", 5.0, 15.0, "acute asthma (Pulse)", airwayRatio},
    {Asthma, 0.9, "auto_peep_at_20_per_min_cmh2o", 8.0, 15.0,
     "range asked of adults with severe asthma at 20 breaths per minute", autoPeepAt20_cmH2O, true},
    {SimplePneumothorax, kAny, "lung_volume_ratio", 0.25, 1.0,
     "max(0.25 FRC, FRC - gas in the pleura) (Pulse)", openShareOfRight},
    {MainstemIntubation, kAny, "final_volume_ratio_of_the_other_lung", 0.40, 0.50,
     "40 to 50 % of FRC after minutes (textbook)", endOfUptake},
};

} // namespace

QJsonArray publishedRanges(const MeasuredCondition& measured)
{
    QJsonArray described;
    for (const PublishedRange& range : kRanges) {
        const bool isMeant =
            range.kind == measured.condition.kind
            && (range.severity == kAny || range.severity == measured.condition.severity)
            && (measured.isAdult || !range.ofAdults);
        if (!isMeant)
            continue;
        const double value = range.value(measured);
        const double slack = kRounding * std::abs(range.greatest);
        const bool isWithin = value >= range.least - slack && value <= range.greatest + slack;
        described.append(QJsonObject{{mechanics_key::kFigure, QLatin1StringView{range.figure}},
                                     {mechanics_key::kValue, value},
                                     {mechanics_key::kLeast, range.least},
                                     {mechanics_key::kGreatest, range.greatest},
                                     {mechanics_key::kSource, QLatin1StringView{range.source}},
                                     {mechanics_key::kIsWithin, isWithin}});
    }
    return described;
}

} // namespace carina::lab
