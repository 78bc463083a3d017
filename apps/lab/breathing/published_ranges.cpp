#include "apps/lab/breathing/published_ranges.h"

#include "apps/lab/breathing/mechanics_page.h"

#include <cmath>

namespace carina::lab
{
namespace
{

constexpr double kAny = -1.0;       // severity
constexpr double kRounding = 0.005; // of tables that are reproduced

/// In which range a figure is expected.
struct ExpectedRange {
    ConditionKind kind;
    double severity;
    const char* figure;
    double least;
    double greatest;
    double (*value)(const MeasuredCondition&);
    bool ofAdults = false; ///< an absolute figure that says nothing of a child
};

/// A published range, and whether the model was given the figure or follows its own course to it.
struct PublishedRange {
    ExpectedRange expected;
    const char* source;
    bool isByConstruction = true;
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

constexpr PublishedRange kPublished[] = {
    {{Normal, kAny, "ventilated_compliance_ml_per_cmh2o", 50.0, 80.0, staticCompliance_ml, true},
     "static compliance of adults under a ventilator (rdrr cliot)",
     false},
    {{Ards, 0.3, "lung_compliance_ratio", 0.7, 0.7, complianceRatio}, kPulse},
    {{Ards, 0.6, "lung_compliance_ratio", 0.5, 0.5, complianceRatio}, kPulse},
    {{Ards, 0.9, "lung_compliance_ratio", 0.4, 0.4, complianceRatio}, kPulse},
    {{Ards, 0.3, "inspiration_to_expiration", 0.7, 0.7, inspiration}, kPulse},
    {{Ards, 0.6, "inspiration_to_expiration", 1.1, 1.1, inspiration}, kPulse},
    {{Ards, 0.9, "inspiration_to_expiration", 1.5, 1.5, inspiration}, kPulse},
    {{Ards, 0.6, "alveolar_dead_space_l", 0.03, 0.03, deadSpace_l}, kPulse},
    {{Ards, 0.9, "alveolar_dead_space_l", 0.15, 0.15, deadSpace_l}, kPulse},
    {{Ards, 0.9, "ventilated_compliance_ml_per_cmh2o", 0.0, 30.0, staticCompliance_ml, true},
     "static compliance in severe ARDS (rdrr cliot)",
     false},
    {{Copd, 0.3, "bronchial_resistance_ratio", 0.85 / 0.45, 0.85 / 0.45, bronchiRatio}, kPulse},
    {{Copd, 0.6, "bronchial_resistance_ratio", 1.7 / 0.45, 1.7 / 0.45, bronchiRatio}, kPulse},
    {{Copd, 0.9, "bronchial_resistance_ratio", 2.4 / 0.45, 2.4 / 0.45, bronchiRatio}, kPulse},
    {{Copd, 0.3, "inspiration_to_expiration", 0.35, 0.35, inspiration}, kPulse},
    {{Copd, 0.6, "inspiration_to_expiration", 0.22, 0.22, inspiration}, kPulse},
    {{Copd, 0.9, "inspiration_to_expiration", 0.12, 0.12, inspiration}, kPulse},
    {{Copd, 0.9, "alveolar_dead_space_l", 0.9, 0.9, deadSpace_l}, kPulse},
    {{Copd, 0.9, "rest_volume_ratio", 1.77, 1.77, restRatio}, kEmphysema},
    {{Copd, 0.9, "total_capacity_ratio", 1.40, 1.40, capacityRatio}, kEmphysema},
    {{Asthma, 0.3, "airway_resistance_ratio", 5.0, 15.0, airwayRatio}, "acute asthma (Pulse)"},
    {{Asthma, 0.6, "airway_resistance_ratio", 5.0, 15.0, airwayRatio}, "acute asthma (Pulse)"},
    {{Asthma, 0.9, "airway_resistance_ratio", 5.0, 15.0, airwayRatio}, "acute asthma (Pulse)"},
    {{SimplePneumothorax, kAny, "lung_volume_ratio", 0.25, 1.0, openShareOfRight},
     "max(0.25 FRC, FRC - gas in the pleura) (Pulse)"},
    {{MainstemIntubation, kAny, "final_volume_ratio_of_the_other_lung", 0.40, 0.50, endOfUptake},
     "40 to 50 % of FRC after minutes (textbook)"},
};

/// What we ask of the model of an adult where no publication was found.
constexpr ExpectedRange kTargets[] = {
    {Copd, 0.9, "auto_peep_at_20_per_min_cmh2o", 5.0, 10.0, autoPeepAt20_cmH2O, true},
    {Asthma, 0.9, "auto_peep_at_20_per_min_cmh2o", 8.0, 15.0, autoPeepAt20_cmH2O, true},
};

bool concerns(const ExpectedRange& range, const MeasuredCondition& measured)
{
    return range.kind == measured.condition.kind
           && (range.severity == kAny || range.severity == measured.condition.severity)
           && (measured.isAdult || !range.ofAdults);
}

QJsonObject compared(const ExpectedRange& range, const MeasuredCondition& measured)
{
    const double value = range.value(measured);
    const double slack = kRounding * std::abs(range.greatest);
    return {{mechanics_key::kFigure, QLatin1StringView{range.figure}},
            {mechanics_key::kValue, value},
            {mechanics_key::kLeast, range.least},
            {mechanics_key::kGreatest, range.greatest},
            {mechanics_key::kIsWithin,
             value >= range.least - slack && value <= range.greatest + slack}};
}

} // namespace

QJsonArray publishedRanges(const MeasuredCondition& measured)
{
    QJsonArray described;
    for (const PublishedRange& range : kPublished) {
        if (!concerns(range.expected, measured))
            continue;
        QJsonObject object = compared(range.expected, measured);
        object[mechanics_key::kSource] = QLatin1StringView{range.source};
        object[mechanics_key::kIsByConstruction] = range.isByConstruction;
        described.append(object);
    }
    return described;
}

QJsonArray ourTargets(const MeasuredCondition& measured)
{
    QJsonArray described;
    for (const ExpectedRange& range : kTargets)
        if (concerns(range, measured))
            described.append(compared(range, measured));
    return described;
}

} // namespace carina::lab
