#include "apps/lab/breathing/mechanics_table.h"

#include "apps/lab/breathing/mechanics_page.h"
#include "apps/lab/breathing/published_ranges.h"
#include "apps/lab/command/patient_words.h"
#include "engine/lungs/drawing/chest_shape.h"
#include "engine/lungs/mechanics/respiratory_fold.h"

#include <QJsonArray>

#include <algorithm>
#include <cmath>
#include <vector>

namespace carina::lab
{
namespace
{

constexpr double kVentilated_s = 60.0;
constexpr double kDriven_s = 300.0;
constexpr double kTired_s = 1800.0;
constexpr double kTiring = 0.9;             // severity from which muscles may tire in that time
constexpr double kLongVentilated_s = 600.0; // until a tension pneumothorax has filled
constexpr Frequency kFastVentilation = perMinute(20.0);

constexpr const char* kNoRangeFound =
    "No published range was found for a patient of this age: the figures here are the model's.";

QString textOf(std::string_view text)
{
    return QString::fromLatin1(text.data(), qsizetype(text.size()));
}

Length tubeFor(const PatientBuild& build)
{
    if (build.ageInYears < kSchoolAge_years)
        return usualTube(build.ageInYears, build.sex);
    return millimetres(build.ageInYears < 16.0 ? 6.5 : 8.0);
}

RespiratorySettings ventilated(RespiratorySettings settings)
{
    settings.ventilator.mode = VentilationMode::VolumeControl;
    settings.ventilator.pressureLimit = cmH2O(60.0);
    settings.tube = tubeFor(settings.build);
    return settings;
}

void breathe(RespiratoryFold& fold, double seconds)
{
    const auto steps = static_cast<int>(seconds / kRespiratoryStep);
    for (int i = 0; i < steps; ++i)
        fold.step();
}

QJsonObject describeBreaths(const RespiratoryFold& fold)
{
    const BreathFigures& breath = fold.lastBreath();
    const RespiratoryState state = fold.state();
    const ChestShape shape =
        chestShape(fold.settings().build, fold.system(), fold.content(), fold.moment());
    const auto ml = [](Volume volume) { return inMillilitres(volume); };
    return {
        {mechanics_key::kRateBreathed, inPerMinute(breath.rate)},
        {mechanics_key::kEffort, inCmH2O(state.effort)},
        {mechanics_key::kInspiratoryShare, state.breath.inspiratoryFraction},
        {mechanics_key::kTiredness, state.drive.tiredness},
        {mechanics_key::kTidalVolume, ml(breath.tidalVolume)},
        {mechanics_key::kTidalVolumeRight, ml(breath.tidalVolumeOfLung[0])},
        {mechanics_key::kTidalVolumeLeft, ml(breath.tidalVolumeOfLung[1])},
        {mechanics_key::kPeak, inCmH2O(breath.peak)},
        {mechanics_key::kPlateau, inCmH2O(breath.plateau)},
        {mechanics_key::kAutoPeep, inCmH2O(breath.autoPeep)},
        {mechanics_key::kAlveolarVentilation, 60.0 * inLitresPerSecond(breath.alveolarVentilation)},
        {mechanics_key::kRightLung, ml(fold.content()[0].gas)},
        {mechanics_key::kLeftLung, ml(fold.content()[1].gas)},
        {mechanics_key::kRightPleura, inCmH2O(fold.moment().pleural[0])},
        {mechanics_key::kLeftPleura, inCmH2O(fold.moment().pleural[1])},
        {mechanics_key::kMediastinalShift, inMillimetres(shape.mediastinalShift)},
    };
}

/// What own breaths do to the torn side of the chest while gas comes in.
QJsonArray describeCourse(const RespiratorySettings& settings)
{
    constexpr double kWatched_s = 10.0;
    QJsonArray course;
    RespiratoryFold fold{settings};
    double breathed_s = 0.0;
    for (const double minutes : {1.0, 3.0, 5.0, 10.0}) {
        const double end_s = 60.0 * minutes;
        breathe(fold, end_s - kWatched_s - breathed_s);
        breathed_s = end_s;
        std::vector<double> pleura_cmH2O;
        std::vector<double> shift_mm;
        for (int i = 0; i < std::lround(kWatched_s / kRespiratoryStep); ++i) {
            fold.step();
            pleura_cmH2O.push_back(inCmH2O(fold.moment().pleural[0]));
            shift_mm.push_back(inMillimetres(
                chestShape(settings.build, fold.system(), fold.content(), fold.moment())
                    .mediastinalShift));
        }
        const auto pleura = std::ranges::minmax(pleura_cmH2O);
        const auto shift = std::ranges::minmax(shift_mm);
        course.append(QJsonObject{
            {mechanics_key::kMinutes, minutes},
            {mechanics_key::kRateBreathed, inPerMinute(fold.lastBreath().rate)},
            {mechanics_key::kEffort, inCmH2O(fold.state().effort)},
            {mechanics_key::kPleuralGas, inMillilitres(fold.content()[0].trapped)},
            {mechanics_key::kLeastPleura, pleura.min},
            {mechanics_key::kGreatestPleura, pleura.max},
            {mechanics_key::kLeastShift, shift.min},
            {mechanics_key::kGreatestShift, shift.max},
        });
    }
    return course;
}

QJsonObject describeCondition(RespiratorySettings settings, const NamedCondition& named,
                              double severity)
{
    const ConditionSide side = named.bothSides ? ConditionSide::Both : ConditionSide::Right;
    const RespiratorySystem healthy = systemOf(settings);
    if (named.kind != ConditionKind::Normal)
        settings.conditions = {{named.kind, severity, side}};
    const RespiratorySystem system = systemOf(settings);
    const ChestContent rest = restingContent(system);
    RespiratoryFold own{settings};
    breathe(own, kDriven_s);
    const QJsonObject driven = describeBreaths(own);
    const BreathFigures spontaneous = own.lastBreath();
    const double inspiratoryFraction = own.state().breath.inspiratoryFraction;
    if (severity == kTiring)
        breathe(own, kTired_s - kDriven_s);
    RespiratorySettings helped = ventilated(settings);
    RespiratoryFold byVolume{helped};
    breathe(byVolume, kVentilated_s);
    const RespiratorySystem relaxed = systemOf(helped);
    const BreathFigures volumeControl = byVolume.lastBreath();
    const QJsonObject ventilatedBreaths = describeBreaths(byVolume);
    if (named.kind == ConditionKind::TensionPneumothorax)
        breathe(byVolume, kLongVentilated_s - kVentilated_s);
    helped.pattern.rate = kFastVentilation;
    RespiratoryFold fast{helped};
    breathe(fast, kVentilated_s);
    const MeasuredCondition measured{{named.kind, severity, side},
                                     healthy,
                                     system,
                                     relaxed,
                                     spontaneous,
                                     volumeControl,
                                     fast.lastBreath(),
                                     byVolume.moment().pleural[0],
                                     helped.ventilator.peep,
                                     settings.build.ageInYears,
                                     inspiratoryFraction,
                                     settings.pattern.inspiratoryFraction};
    const QJsonArray ranges = publishedRanges(measured);
    QJsonObject described{
        {mechanics_key::kCondition, textOf(named.name)},
        {mechanics_key::kSeverity, severity},
        {mechanics_key::kSide, textOf(sideName(side))},
        {mechanics_key::kRestVolume, inMillilitres(rest[0].gas + rest[1].gas)},
        {mechanics_key::kCompliance, 1e3 * inLitresPerCmH2O(complianceAtRest(system))},
        {mechanics_key::kSpontaneous, driven},
        {mechanics_key::kVolumeControl, ventilatedBreaths},
        {mechanics_key::kRanges, ranges},
        {mechanics_key::kTargets, ourTargets(measured)},
    };
    if (named.kind == ConditionKind::TensionPneumothorax)
        described[mechanics_key::kCourse] = describeCourse(settings);
    if (ranges.isEmpty())
        described[mechanics_key::kNoRange] = QLatin1StringView{kNoRangeFound};
    if (severity == kTiring)
        described[mechanics_key::kTired] = describeBreaths(own);
    return described;
}

QString expectedOf(const QJsonValue& range)
{
    const double least = range[mechanics_key::kLeast].toDouble();
    const QJsonValue greatest = range[mechanics_key::kGreatest];
    if (greatest.isUndefined())
        return QStringLiteral("at least %1").arg(least);
    if (greatest.toDouble() == least)
        return QString::number(least);
    return QStringLiteral("%1 to %2").arg(least).arg(greatest.toDouble());
}

/// Such as "ards 0.9: ventilated_compliance_ml_per_cmh2o is 31.8, expected 0 to 30".
QJsonArray outsideOf(const QJsonArray& conditions)
{
    QJsonArray lines;
    for (const QJsonValue& condition : conditions) {
        for (const Key& list : {mechanics_key::kRanges, mechanics_key::kTargets}) {
            for (const QJsonValue& range : condition[list].toArray()) {
                if (range[mechanics_key::kIsWithin].toBool())
                    continue;
                lines.append(QStringLiteral("%1 %2: %3 is %4, expected %5")
                                 .arg(condition[mechanics_key::kCondition].toString())
                                 .arg(condition[mechanics_key::kSeverity].toDouble())
                                 .arg(range[mechanics_key::kFigure].toString())
                                 .arg(range[mechanics_key::kValue].toDouble(), 0, 'g', 3)
                                 .arg(expectedOf(range)));
            }
        }
    }
    return lines;
}

QJsonObject describePatient(const PatientBuild& build, Volume drawnRest)
{
    const LungVolumes volumes = lungVolumesOf(build);
    const RespiratorySystem system = healthySystem(build);
    const double bronchi = system.lungs[0].bronchi.si + system.lungs[1].bronchi.si;
    const BreathingPattern quiet = restingPattern(build);
    return {
        {mechanics_key::kHeight, inMillimetres(build.height)},
        {mechanics_key::kWeight, build.weightInKilograms},
        {mechanics_key::kAge, build.ageInYears},
        {mechanics_key::kResidualVolume, inMillilitres(volumes.residual)},
        {mechanics_key::kFunctionalResidualCapacity, inMillilitres(volumes.functionalResidual)},
        {mechanics_key::kDrawnRest, inMillilitres(drawnRest)},
        {mechanics_key::kDrawnDifference, 100.0 * (drawnRest / volumes.functionalResidual - 1.0)},
        {mechanics_key::kTotalCapacity, inMillilitres(volumes.totalCapacity)},
        {mechanics_key::kPatientCompliance, 1e3 * inLitresPerCmH2O(complianceAtRest(system))},
        {mechanics_key::kResistance,
         inCmH2OSecondsPerLitre({system.upperLaminar.si + 1.0 / bronchi})},
        {mechanics_key::kQuietRate, inPerMinute(quiet.rate)},
        {mechanics_key::kQuietTidalVolume, inMillilitres(quiet.tidalVolume)},
        {mechanics_key::kInspiratoryFraction, quiet.inspiratoryFraction},
    };
}

} // namespace

QJsonObject mechanicsTable(const RespiratorySettings& healthy, Volume drawnRest,
                           std::optional<ConditionKind> only)
{
    QJsonArray conditions;
    for (const NamedCondition& named : kNamedConditions) {
        if (only && only != named.kind)
            continue;
        if (named.kind == ConditionKind::Normal) {
            conditions.append(describeCondition(healthy, named, 0.0));
            continue;
        }
        for (const double severity : {0.3, 0.6, 0.9})
            conditions.append(describeCondition(healthy, named, severity));
    }
    return {{mechanics_key::kPatient, describePatient(healthy.build, drawnRest)},
            {mechanics_key::kPosition, textOf(positionName(healthy.position))},
            {mechanics_key::kSeconds, kDriven_s},
            {mechanics_key::kTiredSeconds, kTired_s},
            {mechanics_key::kVentilatedSeconds, kVentilated_s},
            {mechanics_key::kRate, inPerMinute(healthy.pattern.rate)},
            {mechanics_key::kConditions, conditions},
            {mechanics_key::kOutside, outsideOf(conditions)}};
}

} // namespace carina::lab
