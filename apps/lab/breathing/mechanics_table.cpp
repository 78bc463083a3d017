#include "apps/lab/breathing/mechanics_table.h"

#include "apps/lab/command/patient_words.h"
#include "engine/lungs/drawing/chest_shape.h"
#include "engine/lungs/mechanics/respiratory_fold.h"

#include <QJsonArray>

namespace carina::lab
{
namespace
{

constexpr double kSeconds = 60.0;

QString textOf(std::string_view text)
{
    return QString::fromLatin1(text.data(), qsizetype(text.size()));
}

Length tubeFor(const PatientBuild& build)
{
    return millimetres(build.ageInYears < 16.0 ? 6.5 : 8.0);
}

RespiratorySettings ventilated(RespiratorySettings settings)
{
    settings.ventilator.mode = VentilationMode::VolumeControl;
    settings.ventilator.pressureLimit = cmH2O(60.0);
    settings.tube = tubeFor(settings.build);
    return settings;
}

/// A push on both sides at rest: lung and wall in series, right and left beside each other.
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

QJsonObject describeBreaths(const RespiratorySettings& settings)
{
    RespiratoryFold fold{settings};
    const auto steps = static_cast<int>(kSeconds / kRespiratoryStep);
    for (int i = 0; i < steps; ++i)
        fold.step();
    const BreathFigures& breath = fold.lastBreath();
    const ChestShape shape =
        chestShape(settings.build, fold.system(), fold.content(), fold.moment());
    const auto ml = [](Volume volume) { return inMillilitres(volume); };
    return {
        {QStringLiteral("tidal_volume_ml"), ml(breath.tidalVolume)},
        {QStringLiteral("tidal_volume_right_ml"), ml(breath.tidalVolumeOfLung[0])},
        {QStringLiteral("tidal_volume_left_ml"), ml(breath.tidalVolumeOfLung[1])},
        {QStringLiteral("peak_cmh2o"), inCmH2O(breath.peak)},
        {QStringLiteral("plateau_cmh2o"), inCmH2O(breath.plateau)},
        {QStringLiteral("auto_peep_cmh2o"), inCmH2O(breath.autoPeep)},
        {QStringLiteral("alveolar_ventilation_l_per_min"),
         60.0 * inLitresPerSecond(breath.alveolarVentilation)},
        {QStringLiteral("right_lung_ml"), ml(fold.content()[0].gas)},
        {QStringLiteral("left_lung_ml"), ml(fold.content()[1].gas)},
        {QStringLiteral("right_pleura_cmh2o"), inCmH2O(fold.moment().pleural[0])},
        {QStringLiteral("left_pleura_cmh2o"), inCmH2O(fold.moment().pleural[1])},
        {QStringLiteral("mediastinal_shift_mm"), inMillimetres(shape.mediastinalShift)},
    };
}

QJsonObject describeCondition(RespiratorySettings settings, const NamedCondition& named,
                              double severity)
{
    const ConditionSide side = named.bothSides ? ConditionSide::Both : ConditionSide::Right;
    settings.condition = {named.kind, severity, side};
    const RespiratorySystem system = systemOf(settings);
    const ChestContent rest = restingContent(system);
    return {
        {QStringLiteral("condition"), textOf(named.name)},
        {QStringLiteral("severity"), severity},
        {QStringLiteral("side"), textOf(sideName(side))},
        {QStringLiteral("rest_volume_ml"), inMillilitres(rest[0].gas + rest[1].gas)},
        {QStringLiteral("compliance_ml_per_cmh2o"),
         1e3 * inLitresPerCmH2O(complianceAtRest(system))},
        {QStringLiteral("spontaneous"), describeBreaths(settings)},
        {QStringLiteral("volume_control"), describeBreaths(ventilated(settings))},
    };
}

QJsonObject describePatient(const PatientBuild& build)
{
    const LungVolumes volumes = lungVolumesOf(build);
    const RespiratorySystem system = healthySystem(build);
    const double bronchi = system.lungs[0].bronchi.si + system.lungs[1].bronchi.si;
    const BreathingPattern quiet = restingPattern(build);
    return {
        {QStringLiteral("height_mm"), inMillimetres(build.height)},
        {QStringLiteral("weight_kg"), build.weightInKilograms},
        {QStringLiteral("age_years"), build.ageInYears},
        {QStringLiteral("rv_ml"), inMillilitres(volumes.residual)},
        {QStringLiteral("frc_ml"), inMillilitres(volumes.functionalResidual)},
        {QStringLiteral("tlc_ml"), inMillilitres(volumes.totalCapacity)},
        {QStringLiteral("compliance_ml_per_cmh2o"),
         1e3 * inLitresPerCmH2O(complianceAtRest(system))},
        {QStringLiteral("resistance_cmh2o_s_per_l"),
         inCmH2OSecondsPerLitre({system.upperLaminar.si + 1.0 / bronchi})},
        {QStringLiteral("rate_per_min"), inPerMinute(quiet.rate)},
        {QStringLiteral("tidal_volume_ml"), inMillilitres(quiet.tidalVolume)},
        {QStringLiteral("inspiratory_fraction"), quiet.inspiratoryFraction},
    };
}

} // namespace

QJsonObject mechanicsTable(const RespiratorySettings& healthy)
{
    QJsonArray conditions;
    for (const NamedCondition& named : kNamedConditions) {
        if (named.kind == ConditionKind::Normal) {
            conditions.append(describeCondition(healthy, named, 0.0));
            continue;
        }
        for (const double severity : {0.3, 0.6, 0.9})
            conditions.append(describeCondition(healthy, named, severity));
    }
    return {{QStringLiteral("patient"), describePatient(healthy.build)},
            {QStringLiteral("position"), textOf(positionName(healthy.position))},
            {QStringLiteral("seconds"), kSeconds},
            {QStringLiteral("rate_per_min"), inPerMinute(healthy.pattern.rate)},
            {QStringLiteral("conditions"), conditions}};
}

} // namespace carina::lab
