#include "apps/lab/breathing/mechanics_page.h"
#include "apps/lab/breathing/mechanics_table.h"
#include "apps/lab/command/patient_options.h"
#include "apps/lab/command/patient_words.h"
#include "apps/lab/commands.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/lungs/mechanics/lung_pair.h"
#include "evaluation/waveforms/waveform_model.h"

#include <QJsonArray>

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr double kUsualFlow_lPerMin = 30.0;

QJsonArray spreadOf(const WaveformModel& model, double (*figure)(const LinearLung&))
{
    double least = figure(model.median);
    double greatest = least;
    for (const FittedBreath& breath : model.breaths) {
        least = std::min(least, figure(breath.lung));
        greatest = std::max(greatest, figure(breath.lung));
    }
    return {least, figure(model.median), greatest};
}

double resistanceOf(const LinearLung& lung) { return inCmH2OSecondsPerLitre(lung.resistance); }
double complianceOf_ml(const LinearLung& lung) { return 1e3 * inLitresPerCmH2O(lung.compliance); }

QJsonObject describeModel(const RecordedWaveform& waveform, const std::vector<BreathPart>& parts,
                          const WaveformModel& model, double assumed_lPerMin)
{
    const auto open = std::ranges::count(parts, BreathPart::Disconnected);
    QJsonObject object{
        {mechanics_waveform_key::kSchema, QLatin1StringView{mechanics_waveform_key::kSchema.help}},
        {mechanics_waveform_key::kSamples, qint64(waveform.pressure_cmH2O.size())},
        {mechanics_waveform_key::kSampleRate, waveform.rate_hz},
        {mechanics_waveform_key::kFlow,
         model.valve ? QStringLiteral("assumed") : QStringLiteral("recorded")},
        {mechanics_waveform_key::kBreaths, qint64(model.breaths.size())},
        {mechanics_waveform_key::kUnfitBreaths, model.unfit},
        {mechanics_waveform_key::kResistance, spreadOf(model, resistanceOf)},
        {mechanics_waveform_key::kCompliance, spreadOf(model, complianceOf_ml)},
        {mechanics_waveform_key::kTimeConstant,
         model.median.resistance.si * model.median.compliance.si},
        {mechanics_waveform_key::kError, inCmH2O(model.rms)},
        {mechanics_waveform_key::kErrorOfOneLung, inCmH2O(model.rmsOneLung)},
        {mechanics_waveform_key::kDisconnected, double(open) / waveform.rate_hz}};
    if (model.valve) {
        object[mechanics_waveform_key::kInspiratoryFlow] = assumed_lPerMin;
        object[mechanics_waveform_key::kValve] =
            QJsonObject{{mechanics_waveform_key::kValvePressure, inCmH2O(model.valve->pressure)},
                        {mechanics_waveform_key::kValveResistance,
                         inCmH2OSecondsPerLitre(model.valve->resistance)}};
    }
    return object;
}

Result<QJsonObject> describeWaveform(const QString& file, double assumed_lPerMin)
{
    const auto waveform = readWaveform(file);
    if (!waveform)
        return tl::unexpected(waveform.error());
    const std::vector<BreathPart> parts = breathParts(*waveform);
    const auto model = modelOf(*waveform, parts, litresPerSecond(assumed_lPerMin / 60.0));
    if (!model)
        return fail(model.error().code, file.toStdString() + " has " + model.error().detail + ".");
    return describeModel(*waveform, parts, *model, assumed_lPerMin);
}

/// What the surfaces of this patient's lungs enclose.
Result<Volume> drawnRestOf(const PatientParameters& figures)
{
    return patientFor(figures).and_then([](const Anatomy& anatomy) {
        return LungPair::of(anatomy).map([](const LungPair& lungs) {
            return lungs.restVolume(Side::Right) + lungs.restVolume(Side::Left);
        });
    });
}

Result<QJsonObject> describeTable(const Words& words)
{
    const auto figures = patientOption(words, BuiltinPatient::Adult);
    if (!figures)
        return tl::unexpected(figures.error());
    RespiratorySettings healthy;
    healthy.build = buildOf(dimensionsFor(*figures).value());
    const auto position = positionOption(words);
    if (!position)
        return tl::unexpected(position.error());
    healthy.position = *position;
    healthy.pattern = restingPattern(healthy.build);
    if (words.has(mechanics_option::kRate)) {
        const auto rate_perMin = words.number(mechanics_option::kRate, 4.0, 60.0);
        if (!rate_perMin)
            return tl::unexpected(rate_perMin.error());
        healthy.pattern.rate = perMinute(*rate_perMin);
    }
    std::optional<ConditionKind> only;
    if (words.has(mechanics_option::kOnly)) {
        const auto kind =
            words.word(mechanics_option::kOnly, kNamedConditions, &NamedCondition::kind);
        if (!kind)
            return tl::unexpected(kind.error());
        only = *kind;
    }
    const auto drawnRest = drawnRestOf(*figures);
    if (!drawnRest)
        return tl::unexpected(drawnRest.error());
    QJsonObject object = mechanicsTable(healthy, *drawnRest, only);
    object[mechanics_key::kSchema] = QLatin1StringView{mechanics_key::kSchema.help};
    return object;
}

Result<QJsonObject> mechanics(const Words& words)
{
    const bool hasWaveform = words.has(mechanics_option::kWaveform);
    if (!hasWaveform && !words.has(mechanics_option::kInspiratoryFlow))
        return describeTable(words);
    if (!hasWaveform || words.has(kPatient) || words.has(mechanics_option::kRate)
        || words.has(kPosition) || words.has(mechanics_option::kOnly))
        return words.refuse(QStringLiteral("takes --patient, --rate-per-min, --position and "
                                           "--condition alone, or --waveform with or without a "
                                           "flow."));
    return words.number(mechanics_option::kInspiratoryFlow, 1.0, 200.0, kUsualFlow_lPerMin)
        .and_then([&](double flow_lPerMin) {
            return describeWaveform(words.text(mechanics_option::kWaveform), flow_lPerMin);
        });
}

Use mechanicsOfConditions()
{
    return {.lines = {"[--patient WHO] [--rate-per-min R] [--position NAME] [--condition NAME]"},
            .text = "Calculates respiration with each condition by the respiratory mechanics, at "
                    "the severities 0.3, 0.6 and 0.9, after five minutes and after half an hour of "
                    "spontaneous breathing and after a minute of volume control, and compares it "
                    "with published ranges. The patient is the adult unless another is asked for.",
            .options = {kPatient, mechanics_option::kRate, kPosition, mechanics_option::kOnly},
            .schema = mechanics_key::kSchema,
            .keys = {mechanics_key::kPosition,
                     mechanics_key::kPatient,
                     mechanics_key::kHeight,
                     mechanics_key::kWeight,
                     mechanics_key::kAge,
                     mechanics_key::kResidualVolume,
                     mechanics_key::kFunctionalResidualCapacity,
                     mechanics_key::kDrawnRest,
                     mechanics_key::kDrawnDifference,
                     mechanics_key::kTotalCapacity,
                     mechanics_key::kPatientCompliance,
                     mechanics_key::kResistance,
                     mechanics_key::kQuietRate,
                     mechanics_key::kQuietTidalVolume,
                     mechanics_key::kInspiratoryFraction,
                     mechanics_key::kSeconds,
                     mechanics_key::kTiredSeconds,
                     mechanics_key::kVentilatedSeconds,
                     mechanics_key::kRate,
                     mechanics_key::kConditions,
                     mechanics_key::kCondition,
                     mechanics_key::kSeverity,
                     mechanics_key::kSide,
                     mechanics_key::kRestVolume,
                     mechanics_key::kCompliance,
                     mechanics_key::kSpontaneous,
                     mechanics_key::kRateBreathed,
                     mechanics_key::kEffort,
                     mechanics_key::kInspiratoryShare,
                     mechanics_key::kTiredness,
                     mechanics_key::kTidalVolume,
                     mechanics_key::kTidalVolumeRight,
                     mechanics_key::kTidalVolumeLeft,
                     mechanics_key::kPeak,
                     mechanics_key::kPlateau,
                     mechanics_key::kAutoPeep,
                     mechanics_key::kAlveolarVentilation,
                     mechanics_key::kRightLung,
                     mechanics_key::kLeftLung,
                     mechanics_key::kRightPleura,
                     mechanics_key::kLeftPleura,
                     mechanics_key::kMediastinalShift,
                     mechanics_key::kTired,
                     mechanics_key::kVolumeControl,
                     mechanics_key::kCourse,
                     mechanics_key::kMinutes,
                     mechanics_key::kPleuralGas,
                     mechanics_key::kLeastPleura,
                     mechanics_key::kGreatestPleura,
                     mechanics_key::kLeastShift,
                     mechanics_key::kGreatestShift,
                     mechanics_key::kRanges,
                     mechanics_key::kFigure,
                     mechanics_key::kValue,
                     mechanics_key::kLeast,
                     mechanics_key::kGreatest,
                     mechanics_key::kSource,
                     mechanics_key::kIsByConstruction,
                     mechanics_key::kIsWithin,
                     mechanics_key::kTargets,
                     mechanics_key::kNoRange,
                     mechanics_key::kOutside}};
}

Use mechanicsOfWaveform()
{
    return {.lines = {"--waveform FILE [--inspiratory-flow-l-per-min F]"},
            .text = "Finds resistance and compliance in what a ventilator recorded, by least "
                    "squares, breath by breath; then drives the mechanics with them and compares "
                    "the pressure with the recorded one. Where no flow was recorded, a ventilator "
                    "with the inspiratory flow F and an expiratory valve is assumed, and the valve "
                    "is fitted together with the lung; resistance and elastance are then "
                    "proportional to 1/F, but their time constant does not depend on F.",
            .options = {mechanics_option::kWaveform, mechanics_option::kInspiratoryFlow},
            .schema = mechanics_waveform_key::kSchema,
            .keys = {mechanics_waveform_key::kSamples, mechanics_waveform_key::kSampleRate,
                     mechanics_waveform_key::kFlow, mechanics_waveform_key::kInspiratoryFlow,
                     mechanics_waveform_key::kBreaths, mechanics_waveform_key::kUnfitBreaths,
                     mechanics_waveform_key::kResistance, mechanics_waveform_key::kCompliance,
                     mechanics_waveform_key::kTimeConstant, mechanics_waveform_key::kValve,
                     mechanics_waveform_key::kValvePressure,
                     mechanics_waveform_key::kValveResistance, mechanics_waveform_key::kError,
                     mechanics_waveform_key::kErrorOfOneLung,
                     mechanics_waveform_key::kDisconnected}};
}

} // namespace

Command mechanicsCommand()
{
    return {.name = "mechanics",
            .theme = "the patient",
            .summary = "calculates breathing with each condition, or fits a recorded ventilator",
            .uses = {mechanicsOfConditions(), mechanicsOfWaveform()},
            .experiment = mechanics};
}

} // namespace carina::lab
