#include "apps/lab/breathing/published_ranges.h"

#include "apps/lab/breathing/mechanics_page.h"

#include <limits>

namespace carina::lab
{
namespace
{

constexpr double kAny = -1.0;       // severity
constexpr double kRounding = 0.005; // of tables that are reproduced
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kTwelve_years = 12.0;
constexpr double kGrown_years = 18.0;

/// Whose figure a range is: patients from `from` on and below `to`.
struct Ages {
    double from = 0.0;
    double to = kNoLimit;
};

constexpr Ages kAnyAge{};
constexpr Ages kAdults{kGrown_years};

/// In which range a figure is expected.
struct ExpectedRange {
    ConditionKind kind;
    double severity;
    const char* figure;
    double least;
    double greatest; ///< kNoLimit where there is none
    double (*value)(const MeasuredCondition&);
    Ages ages = kAnyAge;
};

/// A published range, and whether the model was given the figure or follows its own course to it.
struct PublishedRange {
    ExpectedRange expected;
    const char* source;
    bool isByConstruction = true;
};

constexpr const char* kPulse = "Pulse RespiratoryMethodology, table of diseases";
constexpr const char* kEmphysema = "emphysema, AJRCCM 158:3";
constexpr const char* kAcuteAsthma = "acute asthma (Pulse)";
constexpr const char* kOpenTension = "pleural pressure above that of the room throughout "
                                     "expiration: JIACM 2008;9:42; within minutes "
                                     "under a ventilator: Syst Rev 2014;3:3";
constexpr const char* kCollapse =
    "collapsed lung in anaesthesia, typically 10 % and up to 40 %: Compr Physiol 2012;2:69";
constexpr const char* kStenosis =
    "computed for narrowings of a man's trachea by 50, 80 and 90 %: J Appl Physiol 2007;102:1178";
constexpr const char* kScoliosis =
    "mean and standard deviation (from its standard error) of 55 people with scoliosis: J Clin "
    "Invest 1975;55:1153";

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

/// I:E of own breaths over that in health. The table of diseases has 0.5 in health, and the breath
/// that is set may have another.
double inspirationRatio(const MeasuredCondition& m)
{
    const auto ratio = [](double fraction) { return fraction / (1.0 - fraction); };
    return ratio(m.inspiratoryFraction) / ratio(m.inspiratoryFractionInHealth);
}

double airwayRatio(const MeasuredCondition& m)
{
    return (m.awake.upperLaminar.si + bronchi(m.awake))
           / (m.healthy.upperLaminar.si + bronchi(m.healthy));
}

double airway_cmH2OSecondsPerLitre(const MeasuredCondition& m)
{
    return inCmH2OSecondsPerLitre({m.awake.upperLaminar.si + bronchi(m.awake)});
}

double rate_perMin(const MeasuredCondition& m) { return inPerMinute(m.spontaneous.rate); }

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

/// Of both lungs, in health.
double closedShare(const MeasuredCondition& m)
{
    double open = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
        open += m.awake.lungs[i].curve.span.si;
        all += m.healthy.lungs[i].curve.span.si;
    }
    return 1.0 - open / all;
}

double rightPleuraAtLast_cmH2O(const MeasuredCondition& m) { return inCmH2O(m.rightPleuraAtLast); }

double lostInTrachea_Pa(const MeasuredCondition& m)
{
    const double flow = litresPerSecond(0.5).si;
    return (m.awake.upperTurbulent - m.healthy.upperTurbulent) * flow * flow;
}

double restingCompliance_ml(const MeasuredCondition& m)
{
    return 1e3 * inLitresPerCmH2O(complianceAtRest(m.awake));
}

double endOfUptake(const MeasuredCondition& m)
{
    return m.awake.lungs[1].uptakeEnd / m.healthy.lungs[1].wallVolume;
}

using enum ConditionKind;

constexpr PublishedRange kPublished[] = {
    {{Normal, kAny, "rate_per_min", 20.0, 25.0, rate_perMin, {6.0, kTwelve_years}},
     "APLS, 6 to 12 years"},
    {{Normal, kAny, "rate_per_min", 15.0, 20.0, rate_perMin, {kTwelve_years, kGrown_years}},
     "APLS, 12 to 18 years"},
    {{Normal, kAny, "rate_per_min", 12.0, 20.0, rate_perMin, kAdults}, "Pulse"},
    {{Normal,
      kAny,
      "airway_resistance_cmh2o_s_per_l",
      3.0,
      13.0,
      airway_cmH2OSecondsPerLitre,
      {0.0, kGrown_years}},
     "from 2 to 18 years: Pediatr Pulmonol 1985;1:134"},
    {{Normal, kAny, "ventilated_compliance_ml_per_cmh2o", 50.0, 80.0, staticCompliance_ml, kAdults},
     "static compliance of adults under a ventilator (rdrr cliot)",
     false},
    {{Ards, 0.3, "lung_compliance_ratio", 0.7, 0.7, complianceRatio}, kPulse},
    {{Ards, 0.6, "lung_compliance_ratio", 0.5, 0.5, complianceRatio}, kPulse},
    {{Ards, 0.9, "lung_compliance_ratio", 0.4, 0.4, complianceRatio}, kPulse},
    {{Ards, 0.3, "inspiration_to_expiration_ratio", 0.7 / 0.5, 0.7 / 0.5, inspirationRatio},
     kPulse},
    {{Ards, 0.6, "inspiration_to_expiration_ratio", 1.1 / 0.5, 1.1 / 0.5, inspirationRatio},
     kPulse},
    {{Ards, 0.9, "inspiration_to_expiration_ratio", 1.5 / 0.5, 1.5 / 0.5, inspirationRatio},
     kPulse},
    {{Ards, 0.6, "alveolar_dead_space_l", 0.03, 0.03, deadSpace_l}, kPulse},
    {{Ards, 0.9, "alveolar_dead_space_l", 0.15, 0.15, deadSpace_l}, kPulse},
    {{Ards, 0.9, "ventilated_compliance_ml_per_cmh2o", 0.0, 30.0, staticCompliance_ml, kAdults},
     "static compliance in severe ARDS (rdrr cliot)",
     false},
    {{Copd, 0.3, "lung_compliance_ratio", 1.0, 1.0, complianceRatio}, kPulse},
    {{Copd, 0.6, "lung_compliance_ratio", 1.1, 1.1, complianceRatio}, kPulse},
    {{Copd, 0.9, "lung_compliance_ratio", 1.4, 1.4, complianceRatio}, kPulse},
    {{Copd, 0.3, "bronchial_resistance_ratio", 0.85 / 0.45, 0.85 / 0.45, bronchiRatio}, kPulse},
    {{Copd, 0.6, "bronchial_resistance_ratio", 1.7 / 0.45, 1.7 / 0.45, bronchiRatio}, kPulse},
    {{Copd, 0.9, "bronchial_resistance_ratio", 2.4 / 0.45, 2.4 / 0.45, bronchiRatio}, kPulse},
    {{Copd, 0.3, "inspiration_to_expiration_ratio", 0.35 / 0.5, 0.35 / 0.5, inspirationRatio},
     kPulse},
    {{Copd, 0.6, "inspiration_to_expiration_ratio", 0.22 / 0.5, 0.22 / 0.5, inspirationRatio},
     kPulse},
    {{Copd, 0.9, "inspiration_to_expiration_ratio", 0.12 / 0.5, 0.12 / 0.5, inspirationRatio},
     kPulse},
    {{Copd, 0.3, "alveolar_dead_space_l", 0.3, 0.3, deadSpace_l}, kPulse},
    {{Copd, 0.6, "alveolar_dead_space_l", 0.6, 0.6, deadSpace_l}, kPulse},
    {{Copd, 0.9, "alveolar_dead_space_l", 0.9, 0.9, deadSpace_l}, kPulse},
    {{Copd, 0.9, "rest_volume_ratio", 1.77, 1.77, restRatio}, kEmphysema},
    {{Copd, 0.9, "total_capacity_ratio", 1.40, 1.40, capacityRatio}, kEmphysema},
    {{Asthma, kAny, "airway_resistance_ratio", 5.0, 15.0, airwayRatio}, kAcuteAsthma},
    {{SimplePneumothorax, kAny, "lung_volume_ratio", 0.25, 1.0, openShareOfRight},
     "max(0.25 FRC, FRC - gas in the pleura) (Pulse)"},
    {{TensionPneumothorax, kAny, "pleural_pressure_cmh2o", 0.0, kNoLimit, rightPleuraAtLast_cmH2O},
     kOpenTension,
     false},
    {{Atelectasis, kAny, "closed_share_of_both_lungs", 0.10, 0.40, closedShare}, kCollapse},
    {{MainstemIntubation, kAny, "final_volume_ratio_of_the_other_lung", 0.40, 0.50, endOfUptake},
     "40 to 50 % of FRC after minutes (textbook)"},
    {{Obstruction, 0.3, "loss_at_30_l_per_min_pa", 0.0, 7.0, lostInTrachea_Pa, kAdults},
     kStenosis,
     false},
    {{Obstruction, 0.6, "loss_at_30_l_per_min_pa", 7.0, 46.0, lostInTrachea_Pa, kAdults},
     kStenosis,
     false},
    {{Obstruction, 0.9, "loss_at_30_l_per_min_pa", 235.0, 235.0, lostInTrachea_Pa, kAdults},
     kStenosis,
     false},
    {{StiffChest, kAny, "compliance_ml_per_cmh2o", 19.0, 79.0, restingCompliance_ml, kAdults},
     kScoliosis,
     false},
};

/// What we ask of the model where no publication was found.
constexpr ExpectedRange kTargets[] = {
    {Copd, 0.9, "auto_peep_at_20_per_min_cmh2o", 5.0, 10.0, autoPeepAt20_cmH2O},
    {Asthma, 0.9, "auto_peep_at_20_per_min_cmh2o", 8.0, 15.0, autoPeepAt20_cmH2O},
};

bool concerns(const ExpectedRange& range, const MeasuredCondition& measured)
{
    return range.kind == measured.condition.kind
           && (range.severity == kAny || range.severity == measured.condition.severity)
           && measured.ageInYears >= range.ages.from && measured.ageInYears < range.ages.to;
}

QJsonObject compared(const ExpectedRange& range, const MeasuredCondition& measured)
{
    const double value = range.value(measured);
    const double slack = range.least == range.greatest ? kRounding * range.greatest : 0.0;
    QJsonObject object{{mechanics_key::kFigure, QLatin1StringView{range.figure}},
                       {mechanics_key::kValue, value},
                       {mechanics_key::kLeast, range.least},
                       {mechanics_key::kIsWithin,
                        value >= range.least - slack && value <= range.greatest + slack}};
    if (range.greatest != kNoLimit)
        object[mechanics_key::kGreatest] = range.greatest;
    return object;
}

} // namespace

Compliance complianceAtRest(const RespiratorySystem& system)
{
    const ChestContent rest = restingContent(system);
    Compliance sum;
    for (std::size_t i = 0; i < 2; ++i) {
        const LungMechanics& lung = system.lungs[i];
        sum.si += 1.0 / (1.0 / lung.curve.complianceAt(rest[i].gas).si + 1.0 / lung.wall.si);
    }
    return sum;
}

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
